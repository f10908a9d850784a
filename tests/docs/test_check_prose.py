"""Does tools/check_prose.py count what is prose, and fail where sentences are too long?"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKER = pathlib.Path(__file__).resolve().parents[2] / "tools/check_prose.py"
LONG = "Word " + "word " * 45 + "end."  # 47 words
SHORT = "A short sentence. " * 20 + "\n\n"


def run(text):
    """The exit code of the checker for a page, and what it printed."""
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder, "page.md")
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


if __name__ == "__main__":
    unittest.main()
