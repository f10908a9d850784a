"""The Mesher: threads, progress, cancelling and figures of calls that may take long."""
from __future__ import annotations

import contextlib
import threading
from typing import Any, Callable, Iterator

from . import native
from ._arrays import whole_number
from ._handle import Handle
from ._shown_progress import ShownProgress
from .errors import Busy, Closed, CleftError, raise_for, warn

#: Called with the fraction done and the stage in words. An answer that is false stops the call (False, numpy.False_,
#: 0); no answer (None) and true ones go on.
Progress = Callable[[float, str], object]
#: Called with a level ("warning", "info" or "debug") and a sentence.
Log = Callable[[str, str], object]

_LEVELS = {native.CLEFT_LOG_WARNING: "warning", native.CLEFT_LOG_INFO: "info", native.CLEFT_LOG_DEBUG: "debug"}


def _warn(level: int, sentence: str) -> None:
    """What is done with sentences where the user gave no log function."""
    if level == native.CLEFT_LOG_WARNING:
        warn(sentence)


class Mesher:
    """How calls run: Mesher(threads=4, progress=show). Give it to the functions as `mesher`; they work without one too.

    `threads` is 1 to 1024, or 0 for as many as the machine has; the result does not depend on it. `progress` and `log`
    are called on the thread that made the call; an exception that they raise stops the call and comes out of it. Ctrl-C
    stops the call with KeyboardInterrupt. `progress=True` shows a bar of tqdm, in a notebook too, or lines on standard
    error if tqdm is not installed. Without a `log`, warnings come as CleftWarning through Python's `warnings`.

    One call runs on a Mesher at a time; another thread that tries gets Busy, a RuntimeError. cancel() is for other
    threads.
    """

    def __init__(self, threads: int = 1, progress: Progress | bool | None = None, log: Log | None = None) -> None:
        self._shown = ShownProgress() if progress is True else None
        function_of_progress = None if isinstance(progress, bool) else progress
        for name, function in (("progress", function_of_progress), ("log", log)):
            if function is not None and not callable(function):
                raise TypeError(f"{name} must be a function, not {type(function).__name__}")
        status, address = native.cleft_context_create()
        raise_for(status, "a mesher could not be made")
        self._handle: Handle | None = Handle(address, native.cleft_context_destroy)
        self._busy = threading.Lock()
        # The library borrows the two functions: they must live as long as the context.
        self._progress = self._shown or function_of_progress
        self._log = _warn if log is None else lambda level, sentence: log(_LEVELS.get(level, "info"), sentence)
        self.threads = threads
        self._check(native.cleft_context_set_progress(self._native, self._progress))
        self._check(native.cleft_context_set_log(self._native, self._log))

    @property
    def threads(self) -> int:
        """Threads that calls use; 0 means as many as the machine has."""
        return int(native.cleft_context_threads(self._native))

    @threads.setter
    def threads(self, value: int) -> None:
        count = whole_number(value, "threads", -(2**31), 2**31 - 1)
        with self._running():
            self._check(native.cleft_context_set_threads(self._native, count))

    def cancel(self) -> None:
        """Asks the call that runs on this mesher to stop soon with Cancelled; from any thread."""
        native.cleft_context_cancel(self._native)

    def metrics(self) -> dict[str, float]:
        """Figures that the stages noted: seconds, counts, angles before and after ..."""
        with self._running():
            count = native.cleft_context_metric_count(self._native)
            value = bytearray(8)
            figures = {}
            for index in range(count):
                status, name = native.cleft_context_metric(self._native, index, value)
                self._check(status)
                figures[name] = memoryview(value).cast("d")[0]
            return figures

    def clear_metrics(self) -> None:
        """Forgets the figures."""
        with self._running():
            self._check(native.cleft_context_clear_metrics(self._native))

    @property
    def closed(self) -> bool:
        """Has close() been called?"""
        return self._handle is None

    def close(self) -> None:
        """Gives the context up. What was made with it lives on."""
        self._handle = None

    def __enter__(self) -> Mesher:
        self._native
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    @property
    def _native(self) -> Handle:
        if self._handle is None:
            raise Closed("this Mesher is closed")
        return self._handle

    @contextlib.contextmanager
    def _running(self) -> Iterator[None]:
        if not self._busy.acquire(blocking=False):
            raise Busy("this Mesher is running another call; use one Mesher a thread")
        try:
            yield
        finally:
            self._busy.release()

    def _check(self, status: int) -> None:
        if status:
            raise_for(status, _sentence_of(status, self._native))

    def _call(self, function: Callable[..., Any], *arguments: Any) -> Any:
        """Runs a function of the library on this context, and answers what it answers besides the status."""
        with self._running():
            handle = self._native
            try:
                answer = function(handle, *arguments)
            finally:
                if self._shown is not None:
                    self._shown.end()
            status, *made = answer if isinstance(answer, (list, tuple)) else (answer,)
            if status:
                raise_for(status, _sentence_of(status, handle))
            return made[0] if made else None

    def _sentence(self) -> str:
        return str(native.cleft_context_last_error(self._native))


def _sentence_of(status: int, context: Handle) -> str:
    """What the context says of a failure; the words for the status where it has no sentence. A busy one leaves none."""
    sentence = "" if status == native.CLEFT_ERROR_BUSY else native.cleft_context_last_error(context)
    return str(sentence or native.cleft_status_string(status))


def mesher_or_plain(mesher: Mesher | None) -> Mesher:
    """The mesher of a call, or a plain one."""
    if mesher is not None and not isinstance(mesher, Mesher):
        raise TypeError(f"mesher must be a Mesher, not {type(mesher).__name__}")
    return mesher if mesher is not None else Mesher()
