"""Does run-tests refuse words that it does not know, before it installs, builds or runs anything?"""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "run-tests"
WORKS = 7  # what a copy returns when it comes to its work


def run(*words):
    """The exit code, the output and the errors of a copy of the script that ends where its work would begin."""
    with tempfile.TemporaryDirectory() as folder:
        script = shutil.copy(SCRIPT, folder)
        tools = pathlib.Path(folder, "tools")
        tools.mkdir()
        (tools / "setup.sh").write_text("exit %d\n" % WORKS)
        done = subprocess.run([script, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    return done.returncode, done.stdout, done.stderr


class RunTests(unittest.TestCase):
    def is_refused(self, named, *words):
        code, printed, error = run(*words)
        self.assertEqual((code, printed), (2, ""), words)
        self.assertEqual(error.count("\n"), 1, error)
        self.assertIn(named, error)

    def test_help_is_the_head_of_the_script(self):
        for word in ("--help", "-h"):
            code, printed, error = run(word)
            self.assertEqual((code, error), (0, ""))
            self.assertTrue(printed.startswith("Installs what the tests need"), printed)
            for option in ("storm N", "fuzz SECONDS", "compilers", "tidy", "faults", "sanitizers", "coverage"):
                self.assertIn("--" + option, printed)
            self.assertNotIn("#", printed)

    def test_unknown_words_are_refused(self):
        for word in ("--strom", "help", "--tidy=1", "-j2"):
            self.is_refused("'%s'" % word, word)
        self.is_refused("'--tidy'", "--compilers", "--tidy")

    def test_numbers_are_needed(self):
        for option in ("--storm", "--fuzz"):
            for number in ((), ("0",), ("-1",), ("many",), ("--seed", "1")):
                self.is_refused(option, option, *number)

    def test_known_words_come_to_their_work(self):
        self.assertEqual(run()[0], WORKS)
        for words in ("--storm 3 --seed 4", "--fuzz 1 --seed 2 options", "--compilers", "--tidy", "--faults"):
            self.assertEqual(run(*words.split())[0], WORKS, words)
        for word in ("--sanitizers", "--coverage"):
            self.assertEqual(run(word)[0], WORKS, word)


if __name__ == "__main__":
    unittest.main()
