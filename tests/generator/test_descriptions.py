#!/usr/bin/python3
"""The generator refuses descriptions that are not sound, and its reader of the headers what it does not understand."""
import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(ROOT / "tools"))

from generator import c_header, fortran, guide, layout, option_table, text  # noqa: E402


class OptionTable(unittest.TestCase):
    def changed(self, pattern, replacement):
        """The table whose description has one place changed."""
        description = (ROOT / option_table.PATH).read_text()
        changed, count = re.subn(pattern, replacement, description, count=1)
        self.assertEqual(count, 1, pattern)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, option_table.PATH)
            path.parent.mkdir(parents=True)
            path.write_text(changed)
            return option_table.read(pathlib.Path(folder))

    def test_choices_give_the_default_and_the_range(self):
        table = option_table.read(ROOT)
        for option in table.options:
            if option.choice:
                self.assertEqual(option.greatest, len(option.choice.values) - 1)
        more = self.changed(r'(\{ name = "octree".*\},)', r'\1 { name = "none_such", text = "cells" },')
        for before, after in zip(table.options, more.options):
            self.assertEqual(after.greatest - before.greatest, before.key == "BACKGROUND")

    def test_what_is_not_sound_is_refused(self):
        for pattern, replacement, words in (
            (r"number = 2\n", "number = 1\n", "twice"),
            (r'key = "SIZE"\n', 'key = "TETS"\n', "twice"),
            (r'type = "real"', 'type = "number"', "no type"),
            (r"default = 0\n", "default = -1\n", "out of its range"),
            (r'default = "particles"', 'default = "none_such"', "none of"),
            (r'calls = \["sizing', 'calls = ["sising', "no calls"),
            (r"number = 2\n", "number = 2\nhelp = 1\n", "unknown fields"),
            (r'text = "one wanted', 'text = "One wanted', "phrase"),
            (r'type = "flag"', 'type = "flag"\nleast = 0', "no range"),
            (r'default = "particles"\n', "", "BACKGROUND lacks default"),
            (r'type = "flag"', 'type = "choice"', r"KEEP_THIN has no \[\[choice\]\]"),
        ):
            with self.subTest(replacement), self.assertRaisesRegex(ValueError, words):
                self.changed(pattern, replacement)

    def test_a_new_group_needs_a_place_in_the_guide(self):
        table = self.changed(r'group = "Sizes"', 'group = "Shapes"')
        with self.assertRaisesRegex(ValueError, "docs/guide.md has no place for the group Shapes"):
            guide.files(Tree("", "", ""), table)


class Reader(unittest.TestCase):
    def test_what_is_not_understood_is_refused(self):
        for declaration in (
            "CLEFT_API int\ncleft_new(void) CLEFT_NOEXCEPT;",
            "struct cleft_new { int field; };",
            "enum named { CLEFT_NEW };",
            "CLEFT_API int cleft_new(void) CLEFT_NOEXCEPT;",
        ):
            with self.subTest(declaration), self.assertRaises(ValueError):
                c_header.Header(declaration).check()

    def test_declarations_are_read_whole(self):
        header = c_header.Header(
            """
            /** Adds. \\since 0.1 */
            CLEFT_NODISCARD CLEFT_API cleft_status cleft_add(const double a[3], cleft_mesh** out) CLEFT_NOEXCEPT;
            /** A pair. \\since 0.1 */
            typedef struct cleft_pair {
                uint32_t struct_size;
                const char* name; /**< of the pair */
                int64_t numbers[4];
            } cleft_pair;""".replace(
                "\n            ", "\n"
            )
        ).check()
        add, pair = header.functions[0], header.structs[0]
        self.assertEqual(
            [(a.name, a.type, a.length) for a in add.arguments], [("a", "const double", 3), ("out", "cleft_mesh**", 0)]
        )
        self.assertEqual((add.result, add.since), ("cleft_status", "0.1"))
        self.assertEqual(
            [(f.name, f.type, f.length, f.comment) for f in pair.fields],
            [
                ("struct_size", "uint32_t", 0, ""),
                ("name", "const char*", 0, "of the pair"),
                ("numbers", "int64_t", 4, ""),
            ],
        )


class Tree:
    """The files of the repository, one of them changed."""

    def __init__(self, path, pattern, replacement):
        self.path, self.pattern, self.replacement = path, pattern, replacement

    def read(self, path):
        content = (ROOT / path).read_text()
        return re.sub(self.pattern, self.replacement, content, count=1) if path == self.path else content


class Layout(unittest.TestCase):
    HEADER = "include/cleft/cleft.h"

    def made(self, pattern, replacement):
        return layout.files(Tree(self.HEADER, pattern, replacement), None)[layout.PATH]

    def test_structs_grow_at_their_end_alone(self):
        grown = self.made(r"\n} cleft_contact;", r"\n    double area; /**< of the triangles */\n} cleft_contact;")
        before = (ROOT / layout.PATH).read_text()
        size = int(re.search(r"sizeof\(cleft_contact\) >= (\d+)", before)[1])
        self.assertIn(f"PLACE(cleft_contact, area, {size});\n", grown)
        self.assertIn(f"HOLDS(sizeof(cleft_contact) >= {size + 8});\n", grown)
        for pattern, replacement, lost in (
            (r"(int64_t triangles;)", r"double area; \1", "PLACE.cleft_contact, triangles, 16."),
            (r"CLEFT_SNAP_SAFE = 1", "CLEFT_SNAP_SAFE = 3", "HOLDS.CLEFT_SNAP_SAFE == 1."),
            (r"    double total_volume;[^\n]*\n", "", "PLACE.cleft_quality, total_volume, 136."),
        ):
            with self.subTest(replacement), self.assertRaisesRegex(ValueError, lost):
                self.made(pattern, replacement)

    def test_nullable_arguments_are_there(self):
        with self.assertRaisesRegex(ValueError, "cleft_mesh_create.labels"):
            fortran.files(
                Tree(
                    self.HEADER,
                    r"const int32_t\* labels, int32_t index_base",
                    "const int32_t* marks, int32_t index_base",
                ),
                None,
            )


class Text(unittest.TestCase):
    def test_regions(self):
        before = "a\n  // <x> made\nold\n  // </x>\nb\n"
        self.assertEqual(text.region(before, "f", "x", "new\n", ("//", "")), before.replace("old", "new"))
        with self.assertRaises(ValueError):
            text.region(before, "f", "y", "new\n", ("//", ""))

    def test_numbers(self):
        for value, words in (
            (0, "0"),
            (10000000, "10000000"),
            (0.3, "0.3"),
            (1e30, "1e30"),
            (2.0**53, "9007199254740992"),
        ):
            self.assertEqual(text.number(float(value)), words)


if __name__ == "__main__":
    unittest.main()
