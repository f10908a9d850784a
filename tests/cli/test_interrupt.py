"""Ctrl-C stops the work, leaves no file, and is reported by the exit code."""
import os
import pty
import signal
import subprocess
import unittest

from support import CLEFT, DATA, HANGS, INTERRUPTED, CommandTest


class Interrupt(CommandTest):
    def start(self):
        """Starts a run of minutes with its stderr on a terminal, and waits until the progress bar has moved."""
        terminal, stderr = pty.openpty()
        self.addCleanup(os.close, terminal)
        run = subprocess.Popen(
            [
                CLEFT,
                "mesh",
                DATA / "mickey.nrrd",
                "-o",
                self.path("out.vtu"),
                "--json",
                self.path("r.json"),
                "--tets",
                "20000000",
                "--threads",
                "1",
            ],
            stdout=subprocess.PIPE,
            stderr=stderr,
            env={**os.environ, "TERM": "xterm"},
        )
        self.addCleanup(run.stdout.close)
        self.addCleanup(run.kill)
        os.close(stderr)
        seen = b""
        while b"##" not in seen:
            seen += os.read(terminal, 1000)
        return run, seen

    def stop(self, number):
        run, seen = self.start()
        run.send_signal(number)
        run.wait(HANGS)
        self.assertEqual(run.stdout.read(), b"")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["balls.nrrd", "r.json"])
        self.assertIn('"cancelled"', self.path("r.json").read_text())
        return run.returncode, seen

    def test_control_c(self):
        exit_code, seen = self.stop(signal.SIGINT)
        self.assertEqual(exit_code, INTERRUPTED)
        self.assertIn(b"%", seen)

    def test_terminate(self):
        exit_code, _ = self.stop(signal.SIGTERM)
        self.assertEqual(exit_code, 128 + signal.SIGTERM)


if __name__ == "__main__":
    unittest.main()
