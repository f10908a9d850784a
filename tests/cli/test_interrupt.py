"""Ctrl-C stops the work, leaves no file, and is reported by the exit code."""
import os
import pty
import signal
import subprocess
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
