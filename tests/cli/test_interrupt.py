"""Ctrl-C stops the work, leaves no file, and is reported by the exit code."""
import fcntl
import json
import os
import pty
import signal
import subprocess
import time
import unittest

from support import CLEFT, DATA, HANGS, INTERRUPTED, CommandTest


class Interrupt(CommandTest):
    def start(self, arguments, mark):
        """Starts a run with its stderr on a terminal, and waits until the line of its progress has the mark."""
        terminal, stderr = pty.openpty()
        self.addCleanup(os.close, terminal)
        run = subprocess.Popen(
            [CLEFT, *arguments, "--json", self.path("r.json"), "--threads", "1"],
            stdout=subprocess.PIPE,
            stderr=stderr,
            env={**os.environ, "TERM": "xterm", "COLUMNS": "200"},
        )
        self.addCleanup(run.stdout.close)
        self.addCleanup(run.kill)
        os.close(stderr)
        seen = b""
        while mark not in seen:
            seen += os.read(terminal, 1000)
        return run, seen

    def stop(self, number, arguments, mark, *kept):
        """Stops such a run by a signal, and answers its exit code. Only these files are left, and the report."""
        run, _ = self.start(arguments, mark)
        run.send_signal(number)
        run.wait(HANGS)
        self.assertEqual(run.stdout.read(), b"")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), sorted(["balls.nrrd", "r.json", *kept]))
        self.assertIn('"cancelled"', self.path("r.json").read_text())
        return run.returncode

    def stop_meshing(self, number):
        # A run of minutes.
        arguments = ["mesh", DATA / "mickey.nrrd", "-o", self.path("out.vtu"), "--tets", "20000000"]
        return self.stop(number, arguments, b"##")

    def test_control_c(self):
        self.assertEqual(self.stop_meshing(signal.SIGINT), INTERRUPTED)

    def test_terminate(self):
        self.assertEqual(self.stop_meshing(signal.SIGTERM), 128 + signal.SIGTERM)

    def start_report(self, report, **keywords):
        """A short run, which has its report to write when the mesh is written."""
        arguments = ["mesh", self.volume, "-o", self.path("out.vtu"), "--json", report, "--threads", "1"]
        return subprocess.Popen([CLEFT, *arguments], stderr=subprocess.PIPE, text=True, **keywords)

    def wait_for_mesh(self):
        while not any(self.folder.glob(".cleft-*/out.vtu")):
            time.sleep(0.01)

    def stop_report(self, run):
        self.wait_for_mesh()
        time.sleep(0.5)  # a run that is not at its report yet is stopped all the same
        run.send_signal(signal.SIGTERM)
        errors = run.communicate(timeout=HANGS)[1]
        self.assertEqual(run.returncode, 128 + signal.SIGTERM)
        self.assertEqual(errors, "cleft mesh: stopped by a signal; nothing was written\n")
        self.assertEqual(self.names(), [])

    def names(self):
        return [path.name for path in self.folder.iterdir() if path.name not in ("balls.nrrd", "pipe")]

    def test_a_report_to_a_pipe(self):
        os.mkfifo(self.path("pipe"))
        with self.start_report(self.path("pipe")) as run:
            self.stop_report(run)
        # A reader that does not read more than a page, which is less than the report.
        reader = os.open(self.path("pipe"), os.O_RDONLY | os.O_NONBLOCK)
        fcntl.fcntl(reader, fcntl.F_SETPIPE_SZ, 4096)
        with self.start_report(self.path("pipe")) as run:
            self.stop_report(run)
        os.close(reader)
        with self.start_report(self.path("pipe")) as run:
            self.wait_for_mesh()
            report = json.loads(self.path("pipe").read_text())
        self.assertEqual((run.returncode, report["mesh"]["tets"] > 0, self.names()), (0, True, ["out.vtu"]))

    def test_a_signal_that_was_ignored_from_the_start(self):
        os.mkfifo(self.path("pipe"))
        ignore = lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)
        with self.start_report(self.path("pipe"), preexec_fn=ignore) as run:
            self.wait_for_mesh()
            run.send_signal(signal.SIGHUP)
            time.sleep(0.3)
            json.loads(self.path("pipe").read_text())
        self.assertEqual((run.returncode, self.names()), (0, ["out.vtu"]))

    def test_a_report_on_standard_output(self):
        reader, writer = os.pipe()
        self.addCleanup(os.close, reader)
        fcntl.fcntl(reader, fcntl.F_SETPIPE_SZ, 4096)
        with self.start_report("-", stdout=writer) as run:
            os.close(writer)
            self.stop_report(run)

    def test_drawing(self):
        self.mesh(self.volume)
        self.path("report.json").unlink()
        # A picture of many seconds.
        arguments = ["render", self.path("out.vtu"), "-o", self.path("a.png"), "--size", "6000x6000"]
        self.assertEqual(self.stop(signal.SIGINT, arguments, b"picture:", "out.vtu"), INTERRUPTED)

    def test_writing_a_page(self):
        self.mesh(self.volume, "--background", "lattice", "--size", "0.25")
        self.path("report.json").unlink()
        out = self.path("out.vtu")
        arguments = ["view", out, out, "-o", self.path("a.html")]
        self.assertEqual(self.stop(signal.SIGINT, arguments, b"page:", "out.vtu"), INTERRUPTED)


if __name__ == "__main__":
    unittest.main()
