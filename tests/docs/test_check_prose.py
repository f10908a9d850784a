"""Does tools/check_prose.py count what is prose, and fail where sentences are too long?"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKER = pathlib.Path(__file__).resolve().parents[2] / "tools/check_prose.py"
LONG = "Word " + "word " * 45 + "end."  # 47 words
SHORT = "A short sentence. " * 20 + "\n\n"


def run(text, name="page.md"):
    """The exit code of the checker for a file, and what it printed."""
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder, name)
        page.write_text(text)
        done = subprocess.run([sys.executable, "-B", CHECKER, page], stdout=subprocess.PIPE, text=True)
    return done.returncode, done.stdout


class CheckProse(unittest.TestCase):
    def test_one_sentence_is_too_long(self):
        code, printed = run(SHORT + LONG)
        self.assertEqual(code, 1)
        self.assertIn("page.md:3: 47 words", printed)

    def test_too_many_sentences_are_long(self):
        self.assertEqual(run(SHORT + "word " * 29 + "end.\n")[0], 0)
        self.assertEqual(run(SHORT + ("Word " * 29 + "end.\n") * 3)[0], 1)

    def test_items_are_sentences_of_their_own(self):
        items = "- " + "word " * 20 + "\n"
        self.assertEqual(run(SHORT + items * 3)[0], 0)

    def test_what_is_no_prose_is_left_out(self):
        for frame in (
            "```c\n%s\n```",
            "    %s",
            "| %s |",
            "# %s",
            "<!-- %s -->",
            "![%s](x.png)",
            "1. An item.\n\n## A heading\n\n    %s",
        ):
            self.assertEqual(run(SHORT + frame % LONG)[0], 0, frame)

    def test_a_piece_of_code_is_one_word(self):
        self.assertEqual(run("`" + "word " * 50 + "` is code.\n")[0], 0)
        self.assertIn(": 1 sentences", run("Take `a. B` now.\n")[1])

    def test_abbreviations_and_links_end_no_sentence(self):
        self.assertIn(": 1 sentences", run("By J. Levine, e.g. Cleaving.\n")[1])
        self.assertIn(": 2 sentences", run("It is there. [a.md](a.md) says why.\n")[1])

    def test_docstrings_of_a_header_are_prose_and_its_code_is_not(self):
        short = "/** A short sentence. */\n" * 20 + "#define CODE " + "word " * 50 + "\n// " + LONG + "\n"
        for docstring, line in (("/** %s \\since 0.1 */", 23), ("/**\n *  %s\n */", 24), ("int field; /**< %s */", 23)):
            self.assertEqual(run(short + docstring % "It does.", "h.h")[0], 0, docstring)
            code, printed = run(short + docstring % LONG, "h.hpp")
            self.assertEqual(code, 1, docstring)
            self.assertIn(f"h.hpp:{line}: 47 words", printed)

    def test_the_comment_at_the_head_is_prose(self):
        self.assertEqual(run("/*\n * " + LONG + "\n */\n/* Short. */", "h.h")[0], 1)
        self.assertEqual(run("/* Short. */\n/* " + LONG + " */", "h.h")[0], 0)

    def test_a_name_of_the_interface_begins_a_sentence(self):
        self.assertIn(": 2 sentences", run("/** It does. cleft_x() does it too. \\since 0.1 */", "h.h")[1])

    def test_texts_of_toml_are_prose(self):
        rows = '[[row]]\ntext = "a short phrase"\nother = "An %s"\n' % LONG.lower()
        self.assertEqual(run(rows, "t.toml")[0], 0)
        code, printed = run(rows + '[[row]]\nvalues = [\n{ text = "%s" }]\n' % LONG, "t.toml")
        self.assertEqual(code, 1)
        self.assertIn("t.toml:6: 47 words", printed)


if __name__ == "__main__":
    unittest.main()
