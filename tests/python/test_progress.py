"""Mesher(progress=True): a bar of tqdm for each call, or lines."""
import contextlib
import importlib.util
import io
import re
import sys
import types
import unittest
from unittest import mock

import cleft
from cleft import _shown_progress
from support import QUICK, ball_volume


class Recorder:
    """A bar that notes what becomes of it."""

    made = []

    def __init__(self, **keywords):
        self.total, self.n, self.stages, self.closed = keywords["total"], 0, [], False
        self.made.append(self)

    def set_description_str(self, text, refresh):
        self.stages.append(text)

    def update(self, more):
        assert more >= 0 and not self.closed
        self.n += more

    def close(self):
        self.closed = True


def with_tqdm(make):
    """The module as it is with this tqdm; without any for None."""
    module = types.SimpleNamespace(tqdm=make) if make else None
    return mock.patch.dict(sys.modules, {"tqdm.auto": module})


class ShownProgress(unittest.TestCase):
    def setUp(self):
        Recorder.made = []
        self.mesher = cleft.Mesher(progress=True)

    def test_a_bar_a_call(self):
        with with_tqdm(Recorder):
            volume = ball_volume(mesher=self.mesher)
            cleft.mesh(volume, mesher=self.mesher, **QUICK)
        self.assertEqual(len(Recorder.made), 2)
        for bar in Recorder.made:
            self.assertTrue(bar.closed)
            self.assertAlmostEqual(bar.n, bar.total)
            self.assertTrue(all(bar.stages))

    def test_a_call_that_fails_ends_its_bar(self):
        class Failing(Recorder):
            def update(self, more):
                super().update(more)
                if self.n > 0.3:
                    raise KeyError("in a bar")

        with with_tqdm(Failing):
            with self.assertRaises(KeyError):
                cleft.mesh(ball_volume(), mesher=self.mesher, **QUICK)
        with with_tqdm(Recorder):
            self.assertTrue(cleft.mesh(ball_volume(), mesher=self.mesher, **QUICK))
        self.assertEqual([bar.closed for bar in Recorder.made], [True, True])

    def test_lines_without_tqdm(self):
        said = io.StringIO()
        with with_tqdm(None), mock.patch.object(_shown_progress, "_DELAY", 0), contextlib.redirect_stderr(said):
            cleft.mesh(ball_volume(), mesher=self.mesher, **QUICK)
        lines = said.getvalue().splitlines()
        self.assertTrue(lines)
        for line in lines:
            self.assertRegex(line, r"^cleft: \d+ % after \d+ s: .+$")

    def test_times_of_lines(self):
        now = [0.0]
        said = io.StringIO()
        lines = _shown_progress._Lines(clock=lambda: now[0])
        with contextlib.redirect_stderr(said):
            for tenth in range(1000):
                now[0] = tenth / 10
                lines.show(tenth / 1000, "a" if tenth < 500 else "b")
        times = [int(time) for time in re.findall(r"after (\d+) s", said.getvalue())]
        self.assertEqual(times, [0, 10, 20, 30, 40, 50, 60, 70, 80, 90])

    @unittest.skipUnless(importlib.util.find_spec("tqdm"), "tqdm is not installed")
    def test_tqdm(self):
        said = io.StringIO()
        with mock.patch.object(_shown_progress, "_DELAY", 0), contextlib.redirect_stderr(said):
            cleft.mesh(ball_volume(), mesher=self.mesher, **QUICK)
        last = said.getvalue().rstrip("\n").split("\r")[-1]
        self.assertRegex(last, r"^100 %\|.*\| \d\d:\d\d, 00:00 left  \w+")

    def test_nothing_is_shown_unasked(self):
        said = io.StringIO()
        with with_tqdm(Recorder), contextlib.redirect_stderr(said):
            for progress in (False, None):
                cleft.mesh(ball_volume(), mesher=cleft.Mesher(progress=progress), **QUICK)
        self.assertEqual((Recorder.made, said.getvalue()), ([], ""))


if __name__ == "__main__":
    unittest.main()
