"""The command says how it is used."""
import re
import unittest

from support import OK, USAGE, CommandTest, cleft


class Help(CommandTest):
    def test_lists_commands_and_exit_codes(self):
        done = self.run_ok("--help")
        for word in ("mesh", "info", "check", "convert", "sizing", "Exit codes", "130", "Examples"):
            self.assertIn(word, done.stdout)

    def test_every_command_has_examples_and_exit_codes(self):
        for command in ("mesh", "info", "check", "convert", "sizing"):
            done = self.run_ok(command, "--help")
            self.assertIn("Examples", done.stdout)
            self.assertIn("Exit codes", done.stdout)

    def test_mesh_tells_the_table_of_options_with_ranges_and_defaults(self):
        help_text = self.run_ok("mesh", "--help").stdout
        for option in (
            "background",
            "size",
            "size-min",
            "size-max",
            "feature-scale",
            "gradation",
            "interface-size",
            "label-size",
            "tets",
            "smooth",
            "snap",
            "improve",
            "seed",
            "strict",
            "strip",
            "only",
            "threads",
            "json",
            "quiet",
            "sizing",
            "world",
            "dims",
            "type",
            "spacing",
            "estimate",
        ):
            self.assertIn("--" + option, help_text)
        self.assertIn("default 0.3", help_text)
        self.assertIn(".vtu", help_text)
        self.assertRegex(help_text, r"--background (\w+\|)+FILE\s")

    def options_of(self, command, group):
        """The options under a heading of the help."""
        sections = re.split(r"^(\w[\w ]*):?$", self.run_ok(command, "--help").stdout, flags=re.MULTILINE)
        return re.findall(r"^ +(--[\w-]+)", sections[sections.index(group) + 1], flags=re.MULTILINE)

    def test_options_are_grouped_and_offered_as_the_table_says(self):
        sizes = self.options_of("mesh", "Sizes")
        self.assertEqual(sizes[:2], ["--size", "--size-min"])
        self.assertIn("--max-tets", sizes)
        self.assertNotIn("--max-tets", self.options_of("mesh", "Meshing"))
        self.assertEqual(self.options_of("sizing", "Sizes"), [name for name in sizes if name != "--sizing"])
        self.assertEqual(self.options_of("sizing", "Labels"), self.options_of("mesh", "Labels"))
        self.assertEqual(
            self.options_of("sizing", "Meshing"),
            ["--background", "--smooth", "--snap", "--improve", "--min-angle", "--steps", "--seed", "--block"],
        )

    def test_lines_fit_a_wide_terminal(self):
        for command in ((), ("mesh",), ("info",), ("check",), ("convert",), ("sizing",)):
            for line in self.run_ok(*command, "--help").stdout.splitlines():
                self.assertLessEqual(len(line), 120, line)

    def test_version(self):
        self.assertRegex(self.run_ok("--version").stdout, r"^cleft \d+\.\d+\.\d+")

    def test_wrong_usage(self):
        for arguments in ((), ("grind",), ("mesh",), ("mesh", "--nonsense"), ("check",), ("convert", "a.vtu")):
            self.assert_fails(USAGE, cleft(*arguments))


if __name__ == "__main__":
    unittest.main()
