#!/usr/bin/python3
"""Each function of the C headers, and each field of their structs, is used by the classes of each language.

What is not is in unreached.txt with a reason.
"""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))
HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(ROOT / "tools"))

from generator import c_header  # noqa: E402

HEADERS = [c_header.read(ROOT / "include/cleft" / name) for name in ("cleft.h", "cleft_io.h")]
LANGUAGES = {"python": "*.py", "java": "*.java", "csharp": "*.cs", "fortran": "cleft*.f90"}


def declared():
    """The names of the functions."""
    return {function.name for header in HEADERS for function in header.functions}


def fields():
    """{struct: its fields}, but for those that the lowest level fills in."""
    return {
        struct.name: {field.name for field in struct.fields} - {"struct_size", "reserved"}
        for header in HEADERS
        for struct in header.structs
    }


# Where a class or a function begins in the sources of a language, to look for fields there alone.
BEGINNINGS = {
    "python": r"^(?=@|class |def )",
    "java": r"^(?=package )",
    "csharp": r"^(?=    (?:public |internal )?(?:sealed |static |partial )*class )",
}


def sources(language):
    """The text of the hand-written classes of a language, without the modules that are the C interface one to one."""
    folder = ROOT / "bindings" / language
    return "\n".join(path.read_text() for path in folder.rglob(LANGUAGES[language]) if not path.stem.endswith("_c"))


def words_about(struct, language):
    """The words of the classes and functions that use a struct, or are called as it; getters and setters by the field's
    name.
    """
    name = "".join(part.capitalize() for part in re.sub(r"^cleft_(io_)?", "", struct).split("_"))
    parts = re.split(BEGINNINGS[language], sources(language), flags=re.MULTILINE)
    about = "".join(part for part in parts if re.search(rf"\bNative{name}\b|\bclass {name}\b", part))
    words = set(re.findall(r"\w+", about))
    words |= {word[3:4].lower() + word[4:] for word in words if word.startswith(("get", "set"))}
    words |= {word[4:] for word in words if word.startswith("set_")}
    words |= {"dims", "spacing"} if "axis" in words else set()
    return words | ({"dihedral_histogram"} if "histogram_bin" in words else set())


def used(language):
    """All names of C functions in the hand-written sources of a language."""
    return set(re.findall(r"\bcleft_\w+", sources(language)))


def excused():
    """{language: {name: reason}} of unreached.txt, whose lines are LANGUAGE NAME REASON."""
    reasons = {language: {} for language in LANGUAGES}
    for line in (HERE / "unreached.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            languages, name, reason = line.split(maxsplit=2)
            for language in LANGUAGES if languages == "all" else languages.split(","):
                reasons[language][name] = reason
    return reasons


class Reach(unittest.TestCase):
    def test_headers_are_understood(self):
        self.assertGreater(len(declared()), 70)

    def test_every_language(self):
        for language in LANGUAGES:
            reached, reasons = used(language), excused()[language]
            with self.subTest(language):
                self.assertEqual(declared() - reached - set(reasons), set(), "not reachable")
                self.assertEqual(set(reasons) & reached, set(), "reachable, but excused in unreached.txt")
                self.assertLessEqual(
                    {name for name in reasons if "." not in name}, declared(), "excused, but no function"
                )

    def test_every_field(self):
        structs = fields()
        self.assertGreater(sum(map(len, structs.values())), 60)
        for language in BEGINNINGS:  # in Fortran the structs are public
            for struct, names in structs.items():
                with self.subTest(language=language, struct=struct):
                    there = names & words_about(struct, language)
                    excuses = {name for name in names if f"{struct}.{name}" in excused()[language]}
                    self.assertEqual(names - there, excuses, "not reachable")


if __name__ == "__main__":
    unittest.main()
