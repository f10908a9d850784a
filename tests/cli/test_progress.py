"""How far the work is: a bar on a terminal, lines elsewhere, and a table of the stages at the end of long runs."""
import fcntl
import json
import os
import pty
import re
import struct
import subprocess
import termios
import unittest

from support import CLEFT, HANGS, OK, CommandTest, cleft, read_terminal

LINE = re.compile(r"cleft: (\d+) % after (\d+ s|\d+ min \d+ s|\d+ h \d+ min)(, [\dhmins ]+ left)?: (.+)")
BAR = re.compile(r"(\[#*\.*\] )?( *\d+) %  .*")


class Progress(CommandTest):
    def on_terminal(self, *arguments, columns=80, **environment):
        """What a terminal gets of a run: standard error and standard output alone."""
        terminal, end = pty.openpty()
        fcntl.ioctl(end, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        run = subprocess.Popen(
            [CLEFT, *map(str, arguments)], stdout=end, stderr=end, env={**os.environ, "TERM": "xterm", **environment}
        )
        self.addCleanup(run.kill)
        os.close(end)
        text = read_terminal(terminal)
        self.assertEqual(run.wait(HANGS), OK, text)
        return text.replace("\r\n", "\n")

    def mesh_arguments(self, *more):
        return ("mesh", self.volume, "-o", self.path("out.vtu"), "--json", self.path("report.json"), *more)

    def seconds(self):
        return json.loads(self.path("report.json").read_text())["seconds"]

    def drawn(self, text):
        """The bars that were drawn, and what stands on the terminal when the last one is cleared."""
        *bars, rest = text.split("\r")
        self.assertEqual(bars[0], "")
        self.assertTrue(rest.startswith("\033[K"))
        return [bar[: -len("\033[K")] for bar in bars[1:]], rest[len("\033[K") :]

    def test_bars_fit_the_terminal(self):
        for columns in (10, 40, 80, 200):
            bars, rest = self.drawn(self.on_terminal(*self.mesh_arguments(), columns=columns))
            self.assertGreater(len(bars), 0)
            self.assertLess(max(map(len, bars)), columns)
            self.assertTrue(rest.startswith("Volume"), rest)
        self.assertEqual(bars[0], "[" + 30 * "." + "]   0 %  0 s  reading the volume")
        parts = [int(BAR.fullmatch(bar)[2]) for bar in bars]
        self.assertEqual(parts, sorted(parts))

    def test_the_variable_where_the_terminal_does_not_say(self):
        for variable, longest in (("30", 29), ("", 79), ("x", 79)):
            bars, _ = self.drawn(self.on_terminal(*self.mesh_arguments(), columns=0, COLUMNS=variable))
            self.assertLessEqual(max(map(len, bars)), longest)

    def test_a_dumb_terminal_is_like_a_log(self):
        for kind in ("dumb", ""):
            text = self.on_terminal(*self.mesh_arguments("--progress", "auto"), TERM=kind)
            self.assertNotIn("\r", text)
            self.assertNotIn("\033", text)

    def assert_lines(self, text):
        lines = [LINE.fullmatch(line) for line in text.splitlines()]
        self.assertNotIn(None, lines, text)
        parts = [int(line[1]) for line in lines]
        self.assertEqual(parts, sorted(parts))
        return lines

    def test_lines(self):
        done = self.run_ok(*self.mesh_arguments("--progress", "lines"))
        lines = self.assert_lines(done.stderr)
        self.assertEqual(lines[0][0], "cleft: 0 % after 0 s: reading the volume")

    def test_short_runs_are_silent_elsewhere(self):
        done = self.run_ok(*self.mesh_arguments("--progress", "auto"))
        if self.seconds() < 10:
            self.assertEqual(done.stderr, "")
        else:
            self.assert_lines(done.stderr)

    def test_no_progress(self):
        for arguments in (["--progress", "none"], ["--quiet"], ["--quiet", "--progress", "lines"]):
            self.assertEqual(self.run_ok(*self.mesh_arguments(*arguments)).stderr, "")
        self.assertTrue(self.on_terminal(*self.mesh_arguments("--progress", "none")).startswith("Volume"))

    def test_a_bar_where_it_is_asked_for(self):
        arguments = map(str, self.mesh_arguments("--progress", "bar"))
        done = subprocess.run([CLEFT, *arguments], capture_output=True, env={**os.environ, "TERM": "dumb"})
        _, rest = self.drawn(done.stderr.decode())
        self.assertEqual(rest, "")

    def test_other_words_are_refused(self):
        done = cleft(*self.mesh_arguments("--progress", "pie"))
        self.assertNotEqual(done.returncode, OK)
        self.assertIn("--progress", done.stderr)

    def test_all_commands_have_it(self):
        self.run_ok(*self.mesh_arguments())
        for arguments in (
            ["info", self.volume],
            ["check", self.path("out.vtu")],
            ["convert", self.path("out.vtu"), self.path("out.msh")],
            ["sizing", self.volume, "-o", self.path("h.nrrd")],
            ["render", self.path("out.vtu"), "-o", self.path("out.png"), "--size", "40x30"],
            ["view", self.path("out.vtu"), "-o", self.path("out.html")],
        ):
            done = self.run_ok(*arguments, "--progress", "lines")
            self.assertIn("0 % after 0 s: reading the", self.assert_lines(done.stderr)[0][0])

    def test_stages_at_the_end_of_long_runs_on_a_terminal(self):
        self.assertNotIn("Stages", self.run_ok(*self.mesh_arguments()).stdout)
        text = self.on_terminal(*self.mesh_arguments())
        # The report is written a little before the summary, so the limit of 5 seconds is met a little earlier.
        if self.seconds() < 4:
            self.assertNotIn("Stages", text)
        elif self.seconds() >= 5:
            self.assertIn("Stages", text)


if __name__ == "__main__":
    unittest.main()
