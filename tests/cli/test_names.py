"""Names of labels: reported by the command, and kept through the formats that hold them."""
import json
import unittest
from xml.sax.saxutils import quoteattr

from support import CANNOT_READ, USAGE, CommandTest, cleft

NAME = 'Linke Niere "größer" & <ok>'
PLAIN = "Linke_Niere_gr_er_ok"


class Names(CommandTest):
    def setUp(self):
        super().setUp()
        self.mesh(self.volume, output="plain.vtu")
        self.name_in_vtu("material_3 " + NAME)

    def name_in_vtu(self, title):
        array = '<DataArray type="Int32" Name=%s NumberOfTuples="1" format="ascii">3</DataArray>'
        field = f"<FieldData>\n{array}\n</FieldData>\n"
        plain = self.path("plain.vtu").read_bytes()
        self.path("named.vtu").write_bytes(plain.replace(b"<Piece", (field % quoteattr(title)).encode() + b"<Piece", 1))

    def names(self, name):
        labels = json.loads(self.run_ok("info", self.path(name), "--json", "-").stdout)["mesh"]["labels"]
        return {row["label"]: row["name"] for row in labels}

    def text(self, name):
        return self.path(name).read_bytes().decode(errors="replace")

    def test_info_tells_them(self):
        self.assertEqual(self.names("named.vtu"), {0: "", 3: NAME, 7: ""})
        table = self.run_ok("info", self.path("named.vtu")).stdout.splitlines()
        self.assertTrue([line for line in table if line.split()[:1] == ["3"] and line.endswith("  " + NAME)])

    def test_vtu_keeps_every_character(self):
        self.run_ok("convert", self.path("named.vtu"), self.path("again.vtu"))
        self.assertEqual(self.names("again.vtu"), self.names("named.vtu"))
        self.run_ok("convert", self.path("again.vtu"), self.path("kept.vtu"), "--only", "0", "3")
        self.assertEqual(self.names("kept.vtu"), {0: "", 3: NAME})

    def test_gmsh_keeps_letters_and_digits(self):
        for version in ("2.2", "4.1"):
            self.run_ok("convert", self.path("named.vtu"), self.path("a.msh"), "--msh-version", version)
            self.assertIn('3 3 "material_3_%s"\n' % PLAIN, self.text("a.msh"))
            self.assertIn('3 7 "material_7"\n', self.text("a.msh"))
            self.run_ok("convert", self.path("a.msh"), self.path("b.vtu"))
            self.assertEqual(self.names("b.vtu"), {0: "", 3: PLAIN, 7: ""})

    def test_element_sets_keep_their_names_and_get_another(self):
        self.run_ok("convert", self.path("named.vtu"), self.path("a.inp"))
        self.assertIn("ELSET=MATERIAL_3\n", self.text("a.inp"))
        self.assertIn("*ELSET, ELSET=MATERIAL_3_%s\nMATERIAL_3\n" % PLAIN.upper(), self.text("a.inp"))

    def test_comments(self):
        for name, file in (("a.mesh", "a.mesh"), ("a.node", "a.face")):
            self.run_ok("convert", self.path("named.vtu"), self.path(name))
            self.assertIn("# material 3 = %s\n" % NAME, self.text(file))

    def test_names_of_groups_of_others(self):
        self.run_ok("convert", self.path("plain.vtu"), self.path("a.msh"), "--msh-version", "2.2")
        self.path("a.msh").write_text(self.text("a.msh").replace('"material_3"', '"steel"'))
        self.assertEqual(self.names("a.msh"), {0: "", 3: "steel", 7: ""})

    def test_names_without_a_letter_and_long_ones(self):
        for name, group in (("肝臓", "material_3"), ("x" * 200, "material_3_" + "x" * 40), ("-- a --", "material_3_a")):
            self.name_in_vtu("material_3 " + name)
            self.run_ok("convert", self.path("named.vtu"), self.path("a.msh"))
            self.assertIn('"%s"\n' % group, self.text("a.msh"))

    def test_a_name_that_is_no_text_is_refused(self):
        broken = self.path("named.vtu").read_bytes().replace("größer".encode(), b"gr\xff\xfe", 1)
        self.path("broken.vtu").write_bytes(broken)
        self.assert_fails(CANNOT_READ, cleft("info", self.path("broken.vtu")), "name of label 3")

    def table(self, text="0 air\n3 right lung\n7 left lung\n"):
        self.path("names.txt").write_text(text)
        return self.path("names.txt")

    def test_a_table_names_the_labels_of_a_run(self):
        outputs = [word for name in ("a.vtu", "a.msh", "a.inp") for word in ("-o", self.path(name))]
        report, page = self.path("r.json"), self.path("page.html")
        done = self.run_ok(
            "mesh", self.volume, *outputs, "--view", page, "--json", report, "--names", self.table(), "--strip", "0"
        )
        self.assertEqual(done.stderr, "")
        table = done.stdout.splitlines()
        self.assertTrue([row for row in table if row.split()[:1] == ["3"] and row.endswith("  right lung")])
        found = json.loads(report.read_text())
        self.assertEqual(found["names"], str(self.path("names.txt")))
        self.assertEqual([row["name"] for row in found["labels"]], ["air", "right lung", "left lung"])
        self.assertEqual([row["name"] for row in found["volume"]["labels"]], ["air", "right lung", "left lung"])
        self.assertEqual(self.names("a.vtu"), {3: "right lung", 7: "left lung"})
        self.assertIn('"material_3_right_lung"', self.text("a.msh"))
        self.assertIn("MATERIAL_7_LEFT_LUNG", self.text("a.inp"))
        self.assertIn('"name":"right lung"', self.text("page.html"))

    def test_info_takes_a_table(self):
        for file in (self.volume, self.path("plain.vtu")):
            report = self.path("info.json")
            self.run_ok("info", file, "--names", self.table(), "--json", report)
            found = json.loads(report.read_text())
            labels = (found["mesh"] if "mesh" in found else found["volume"])["labels"]
            self.assertEqual([row["name"] for row in labels], ["air", "right lung", "left lung"])
        self.assertIn("left lung", self.run_ok("info", self.volume, "--names", self.table()).stdout)
        table = self.table("index\tname\tcolor\n0\tair\t#000000\n3\tright lung\t#ff0000\n")
        self.assertIn("right lung", self.run_ok("info", self.volume, "--names", table).stdout)
        self.assert_fails(USAGE, cleft("info", self.volume, "--names", table, "--json", table))

    def test_a_table_goes_before_the_file(self):
        names = self.table("3 lung\n")
        done = self.run_ok("convert", self.path("named.vtu"), self.path("a.vtu"), "--names", names)
        self.assertIn(f"names.txt': it calls label 3 'lung', and the mesh '{NAME}'; the names of the", done.stderr)
        self.assertEqual(self.names("a.vtu"), {0: "", 3: "lung", 7: ""})
        done = self.run_ok("mesh", self.volume, "-o", self.path("b.vtu"), "--names", self.table("5 bone\n"))
        self.assertIn("names.txt': it has no name for any label of the volume\n", done.stderr)

    def test_a_legend_has_the_names_of_a_table(self):
        pictures = []
        for names in ([], ["--names", self.table()]):
            arguments = ["-o", self.path("p.png"), "--size", "300x200", "--legend", *names]
            self.run_ok("render", self.path("plain.vtu"), *arguments)
            pictures.append(self.path("p.png").read_bytes())
        self.assertNotEqual(*pictures)

    def test_tables_that_cannot_be(self):
        names = self.table("lung 3\n")
        for arguments in (
            ["mesh", self.volume, "-o", self.path("x.vtu")],
            ["convert", self.path("plain.vtu"), self.path("x.msh")],
            ["render", self.path("plain.vtu"), "-o", self.path("x.png")],
        ):
            self.assert_fails(CANNOT_READ, cleft(*arguments, "--names", names), "names.txt", "line 1")
            self.assert_fails(USAGE, cleft(*arguments, "--names", self.path("none.txt")), "--names")
        copy = self.path("names.vtu")
        copy.write_text("3 precious\n")
        self.assert_fails(USAGE, cleft("mesh", self.volume, "-o", copy, "--names", copy))
        self.assertEqual(copy.read_text(), "3 precious\n")


if __name__ == "__main__":
    unittest.main()
