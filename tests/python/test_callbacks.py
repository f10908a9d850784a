"""Progress, log, cancelling, Ctrl-C and the interpreter's lock."""
import os
import signal
import threading
import time
import unittest
import warnings

import numpy as np

import cleft
from support import QUICK, ball_labels, ball_volume


def slow_volume():
    """Meshing this takes seconds if nothing stops it."""
    labels = np.random.default_rng(1).integers(0, 3, (40, 40, 40))
    return cleft.Volume(labels)


def ball_volume_of(**keywords):
    return cleft.Volume(ball_labels(), **keywords)


class Callbacks(unittest.TestCase):
    def test_progress(self):
        seen, threads = [], set()

        def progress(fraction, stage):
            seen.append((fraction, stage))
            threads.add(threading.get_ident())

        cleft.mesh(ball_volume(), mesher=cleft.Mesher(threads=2, progress=progress), **QUICK)
        fractions = [fraction for fraction, _ in seen]
        self.assertGreater(len(seen), 3)
        self.assertEqual(fractions, sorted(fractions))
        self.assertTrue(all(0 <= fraction <= 1 and stage for fraction, stage in seen))
        self.assertEqual(threads, {threading.get_ident()})

    def test_false_cancels_and_no_answer_goes_on(self):
        def answering(answer):
            return cleft.mesh(ball_volume(), mesher=cleft.Mesher(progress=lambda fraction, stage: answer), **QUICK)

        for answer in (False, np.False_, np.array(False), 0, 0.0, "", []):
            with self.assertRaises(cleft.Cancelled):
                answering(answer)
        for answer in (None, True, np.True_, 1, "go on"):
            self.assertTrue(answering(answer))
        with self.assertRaisesRegex(ValueError, "ambiguous"):  # the truth of an array is no answer
            answering(np.array([True, False]))

    def test_exceptions_of_callbacks_come_out(self):
        class Own(Exception):
            pass

        def progress(fraction, stage):
            if fraction > 0.3:
                raise Own("in progress")

        mesher = cleft.Mesher(progress=progress)
        with self.assertRaises(Own):
            cleft.mesh(ball_volume(), mesher=mesher, **QUICK)
        with self.assertRaises(TypeError):
            cleft.mesh(ball_volume(), mesher=cleft.Mesher(progress=lambda: None), **QUICK)

    def test_log(self):
        lines = []
        mesher = cleft.Mesher(log=lambda level, sentence: lines.append((level, sentence)))
        too_few = {"background": "lattice", "tets": 1}  # which cannot be met, and is warned of
        cleft.mesh(ball_volume(), mesher=mesher, **too_few)
        self.assertIn("warning", {level for level, _ in lines})
        self.assertLessEqual({level for level, _ in lines}, {"warning", "info", "debug"})

        def broken(level, sentence):
            raise KeyError(sentence)

        with self.assertRaises(KeyError):
            cleft.mesh(ball_volume(), mesher=cleft.Mesher(log=broken), **too_few)

    def test_warnings_without_a_log(self):
        too_few = {"background": "lattice", "tets": 1}
        for mesher in (None, cleft.Mesher()):
            with self.assertWarnsRegex(cleft.CleftWarning, "tetrahedra") as reported:
                cleft.mesh(ball_volume(), mesher=mesher, **too_few)
            self.assertEqual(reported.filename, __file__)  # where the user called
        self.assertTrue(issubclass(cleft.CleftWarning, UserWarning))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(cleft.CleftWarning):
                cleft.mesh(ball_volume(), **too_few)
            self.assertTrue(cleft.mesh(ball_volume(), mesher=cleft.Mesher(log=lambda level, sentence: None), **too_few))
            self.assertTrue(cleft.mesh(ball_volume(), **QUICK))

    def test_options_that_a_volume_does_not_read_are_told(self):
        with self.assertWarnsRegex(cleft.CleftWarning, "size_max.*mesh()") as reported:
            ball_volume_of(size_max=3.0)
        self.assertEqual(reported.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertTrue(ball_volume_of(smooth=3))
            self.assertTrue(ball_volume_of(options=cleft.Options(size_max=3.0, smooth=3)))

    def test_cancel_from_another_thread(self):
        started = threading.Event()
        mesher = cleft.Mesher(progress=lambda fraction, stage: started.set())  # answers None
        volume = slow_volume()

        def cancel():
            started.wait()
            mesher.cancel()

        thread = threading.Thread(target=cancel)
        thread.start()
        with self.assertRaises(cleft.Cancelled):
            while True:  # a request between two calls is forgotten
                cleft.mesh(volume, mesher=mesher)
        thread.join()

    def test_one_call_at_a_time(self):
        mesher = cleft.Mesher()

        def progress(fraction, stage):
            cleft.mesh(ball_volume(), mesher=inner, **QUICK)

        inner = cleft.Mesher(progress=progress)
        self.assertTrue(issubclass(cleft.Busy, RuntimeError))
        with self.assertRaises(cleft.Busy):
            cleft.mesh(ball_volume(), mesher=inner, **QUICK)
        self.assertTrue(cleft.mesh(ball_volume(), mesher=mesher, **QUICK))

    def test_callbacks_may_mesh_elsewhere(self):
        made = []

        def progress(fraction, stage):
            if not made:
                made.append(cleft.mesh(ball_volume(), **QUICK))

        self.assertTrue(cleft.mesh(ball_volume(), mesher=cleft.Mesher(progress=progress), **QUICK))
        self.assertEqual(len(made), 1)

    def test_other_threads_run_meanwhile(self):
        count, stop, seen = [0], threading.Event(), []

        def work():
            while not stop.is_set():
                count[0] += 1
                time.sleep(0.001)

        def progress(fraction, stage):
            seen.append(count[0])
            return len(seen) < 40 or seen[-1] == seen[0]

        thread = threading.Thread(target=work)
        thread.start()
        try:
            cleft.mesh(slow_volume(), mesher=cleft.Mesher(progress=progress))
        except cleft.Cancelled:
            pass
        stop.set()
        thread.join()
        self.assertGreater(seen[-1], seen[0])

    def test_interrupt(self):
        def interrupt(fraction, stage):
            os.kill(os.getpid(), signal.SIGINT)

        signal.signal(signal.SIGINT, signal.default_int_handler)
        with self.assertRaises(KeyboardInterrupt):
            cleft.mesh(slow_volume(), mesher=cleft.Mesher(progress=interrupt))
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        volume = slow_volume()
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            while True:  # no progress function at all
                cleft.mesh(volume)
        self.assertTrue(cleft.mesh(ball_volume(), **QUICK))


if __name__ == "__main__":
    unittest.main()
