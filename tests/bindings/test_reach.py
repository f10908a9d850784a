#!/usr/bin/python3
"""Each function of the C headers is used by the classes of each language, or is in unreached.txt with a reason."""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))
HERE = pathlib.Path(__file__).parent
HEADERS = ("cleft.h", "cleft_io.h")
LANGUAGES = {"python": "*.py", "java": "*.java", "csharp": "*.cs", "fortran": "cleft*.f90"}


def functions(header):
    """The names of the functions that a header declares."""
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    return set(re.findall(r"\b(cleft_\w+)\s*\((?:[^()]|\([^()]*\))*\)\s*CLEFT_NOEXCEPT\s*;", text))


def declared():
    return set().union(*(functions((ROOT / "include/cleft" / name).read_text()) for name in HEADERS))


def used(folder, pattern):
    """All names of C functions in the hand-written sources of a language."""
    return set(re.findall(r"\bcleft_\w+", "\n".join(path.read_text() for path in folder.rglob(pattern))))


def excused():
    """{language: {function: reason}} of unreached.txt, whose lines are LANGUAGE FUNCTION REASON."""
    reasons = {language: {} for language in LANGUAGES}
    for line in (HERE / "unreached.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            languages, function, reason = line.split(maxsplit=2)
            for language in LANGUAGES if languages == "all" else languages.split(","):
                reasons[language][function] = reason
    return reasons


class Reach(unittest.TestCase):
    def test_headers_are_understood(self):
        names = declared()
        self.assertGreater(len(names), 70)
        for header in HEADERS:
            text = (ROOT / "include/cleft" / header).read_text()
            self.assertEqual(len(re.findall(r"\)\s*CLEFT_NOEXCEPT\s*;", text)), len(functions(text)), header)

    def test_every_language(self):
        seen = 0
        for language, pattern in LANGUAGES.items():
            folder = ROOT / "bindings" / language
            if not any(folder.rglob(pattern)):
                continue
            seen += 1
            reached, reasons = used(folder, pattern), excused()[language]
            with self.subTest(language):
                self.assertEqual(declared() - reached - set(reasons), set(), "not reachable")
                self.assertEqual(set(reasons) & reached, set(), "reachable, but excused in unreached.txt")
                self.assertLessEqual(set(reasons), declared(), "excused, but no function")
        self.assertGreater(seen, 0)


if __name__ == "__main__":
    unittest.main()
