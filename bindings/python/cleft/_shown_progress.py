"""How far a call is, shown by a bar of tqdm, or by lines where tqdm is not installed."""
from __future__ import annotations

import importlib
import sys
import time
from typing import Any, Callable

# Calls that are done in less show nothing.
_DELAY = 0.5
_FORMAT = "{percentage:3.0f} %|{bar}| {elapsed}, {remaining} left  {desc}"


class _Bar:
    """One call: a bar on a terminal, and a widget in a notebook."""

    def __init__(self, make: Callable[..., Any]) -> None:
        # The fraction grows as time does, so the average over the whole call says most (smoothing=0). miniters=0: the
        # time goes on where the fraction stands still.
        self._bar = make(total=1.0, bar_format=_FORMAT, delay=_DELAY, smoothing=0, miniters=0)

    def show(self, fraction: float, stage: str) -> None:
        self._bar.set_description_str(stage, refresh=False)
        # A call that is made of several may say less than before.
        self._bar.update(max(0.0, fraction - self._bar.n))

    def end(self) -> None:
        self._bar.close()


class _Lines:
    """One call: a line where a stage begins, and one every ten seconds."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._start = clock()
        self._last = self._start + _DELAY - 1
        self._stage = ""

    def show(self, fraction: float, stage: str) -> None:
        now = self._clock()
        if now - self._last < (10 if stage == self._stage else 1):
            return
        self._last, self._stage = now, stage
        print(f"cleft: {int(100 * fraction)} % after {int(now - self._start)} s: {stage}", file=sys.stderr, flush=True)

    def end(self) -> None:
        pass


class ShownProgress:
    """What Mesher(progress=True) calls: begins with the first report of a call, and ends with the call."""

    def __init__(self) -> None:
        self._call: _Bar | _Lines | None = None

    def __call__(self, fraction: float, stage: str) -> None:
        if self._call is None:
            self._call = _bar_or_lines()
        self._call.show(fraction, stage)

    def end(self) -> None:
        """The call is over, well or not."""
        call, self._call = self._call, None
        if call is not None:
            call.end()


def _bar_or_lines() -> _Bar | _Lines:
    try:
        # tqdm.auto knows a notebook from a terminal.
        return _Bar(importlib.import_module("tqdm.auto").tqdm)
    except ImportError:
        return _Lines()
