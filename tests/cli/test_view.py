"""cleft view and cleft mesh --view write a page that has the mesh, all or nothing."""
import html.parser
import json
import unittest

from support import CANNOT_READ, CANNOT_WRITE, USAGE, CommandTest, cleft


class Page(html.parser.HTMLParser):
    """The data elements of a page, by their names."""

    def __init__(self, path):
        super().__init__()
        self.elements, self.current = {}, None
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        self.current = dict(attributes).get("id") if tag == "script" else None

    def handle_data(self, data):
        if self.current:
            self.elements[self.current] = data

    def handle_endtag(self, tag):
        self.current = None

    def data(self):
        return json.loads(self.elements["data"])


class View(CommandTest):
    def setUp(self):
        super().setUp()
        self.report = self.mesh(self.volume)

    def test_the_page_tells_what_the_command_tells(self):
        page = self.path("page.html")
        done = self.run_ok("view", self.path("out.vtu"), "-o", page, "--json", self.path("view.json"))
        self.assertIn("page.html", done.stdout)
        (mesh,) = Page(page).data()["meshes"]
        self.assertEqual(mesh["title"], "out.vtu")
        self.assertEqual((mesh["tets"], mesh["points"]), (self.report["mesh"]["tets"], self.report["mesh"]["points"]))
        self.assertEqual(mesh["quality"]["dihedral_histogram"], self.report["quality"]["dihedral_histogram"])
        for mine, reported in zip(mesh["labels"], self.report["mesh"]["labels"]):
            self.assertEqual((mine["label"], mine["tets"]), (reported["label"], reported["tets"]))
            self.assertAlmostEqual(mine["volume"], reported["volume"], 9)
        worst = mesh["worst"]
        self.assertAlmostEqual(worst["angle"][0]["least_angle"], self.report["quality"]["min_dihedral"], 6)
        self.assertAlmostEqual(worst["ratio"][0]["radius_ratio"], self.report["quality"]["radius_ratio_max"], 6)
        angles = [tet["least_angle"] for tet in worst["angle"]]
        self.assertEqual(angles, sorted(angles))
        report = json.loads(self.path("view.json").read_text())
        self.assertEqual((report["command"], report["outputs"]), ("view", [str(page)]))
        self.assertEqual(report["tets"], [mesh["tets"]])

    def test_mesh_writes_the_same_page_with_its_report(self):
        self.run_ok("mesh", self.volume, "-o", self.path("b.vtu"), "--view", self.path("b.html"), "-q")
        self.run_ok("view", self.path("b.vtu"), "-o", self.path("c.html"), "-q")
        ours, read = Page(self.path("b.html")), Page(self.path("c.html"))
        report = json.loads(ours.elements.pop("report-0"))
        self.assertEqual(ours.elements, read.elements)
        self.assertEqual((report["command"], report["view"]), ("mesh", str(self.path("b.html"))))
        self.assertEqual(report["labels"], self.report["labels"])
        self.assertEqual([stage["name"] for stage in report["stages"]][-1], "write")

    def test_a_view_may_be_the_only_output(self):
        self.run_ok("mesh", self.volume, "--view", self.path("b.html"))
        self.assertEqual(Page(self.path("b.html")).data()["meshes"][0]["title"], "balls.nrrd")

    def test_reports_and_names_of_files(self):
        names = self.path("names.txt")
        names.write_text("3 <b>inner</b>\n7 outer\n")
        out = self.path("out.vtu")
        self.run_ok("view", out, out, "-o", self.path("p.htm"), "--report", self.path("report.json"), "--names", names)
        page = Page(self.path("p.htm"))
        self.assertEqual(json.loads(page.elements["report-0"]), self.report)
        self.assertNotIn("report-1", page.elements)
        self.assertEqual([mesh["title"] for mesh in page.data()["meshes"]], ["out.vtu", "out.vtu"])
        self.assertEqual([row["name"] for row in page.data()["meshes"][1]["labels"]], ["", "<b>inner</b>", "outer"])

    def test_the_report_of_another_mesh_is_refused(self):
        def refuse(mesh, report, *words):
            done = cleft("view", self.path(mesh), "-o", self.path("p.html"), "--report", self.path(report))
            self.assert_fails(CANNOT_READ, done, report, *words)
            self.assertEqual(len(done.stderr.splitlines()), 1)
            self.assertFalse(self.path("p.html").exists())

        out = self.path("out.vtu")
        tets = f"{self.report['mesh']['tets']:,}"
        self.run_ok("convert", out, self.path("part.vtu"), "--strip", "0")
        refuse("part.vtu", "report.json", f"it has {tets} tetrahedra, and '{self.path('part.vtu')}' has ")
        far = {**self.report, "mesh": {**self.report["mesh"], "low": [0, 0, 0]}}
        self.path("far.json").write_text(json.dumps(far))
        refuse("out.vtu", "far.json", "it has the box 0 to 15.5 x ")
        labels = [{**row, "label": row["label"] + 1} for row in self.report["mesh"]["labels"]]
        self.path("labels.json").write_text(json.dumps({"mesh": {**self.report["mesh"], "labels": labels}}))
        refuse("out.vtu", "labels.json", "it has 0 tetrahedra of label 0, and ")
        for text in ("{}", "[]", "3", '{"mesh": {"tets": "many"}}'):
            self.path("bad.json").write_text(text)
            refuse("out.vtu", "bad.json", 'lacks "mesh"')
        # Formats that round coordinates.
        self.run_ok("convert", out, self.path("out.vtk"))
        self.run_ok("view", self.path("out.vtk"), "-o", self.path("p.html"), "--report", self.path("report.json"))

    def test_meshes_of_one_name_are_told_apart(self):
        for folder in ("a", "b"):
            self.path(folder).mkdir()
            self.run_ok("convert", self.path("out.vtu"), self.path(folder) / "out.vtu")
        self.run_ok("view", self.path("a/out.vtu"), self.path("b/out.vtu"), "-o", self.path("p.html"))
        titles = [mesh["title"] for mesh in Page(self.path("p.html")).data()["meshes"]]
        self.assertEqual(titles, ["a/out.vtu", "b/out.vtu"])

    def test_a_part_of_a_mesh_is_told(self):
        page, report = self.path("p.html"), self.path("view.json")
        done = self.run_ok("view", self.path("out.vtu"), "-o", page, "--max-shown", 100, "--json", report)
        warning = f"'out.vtu' has {self.report['mesh']['tets']} tetrahedra, and the page shows 100 of them"
        self.assertIn("cleft: warning: " + warning, done.stderr)
        told = json.loads(report.read_text())
        self.assertEqual(len(told["warnings"]), 1)

    def test_failures_leave_nothing(self):
        out, page = self.path("out.vtu"), self.path("page.html")
        self.path("bad.json").write_text("{")
        self.path("bad.txt").write_text("lung 3\n")
        view = ("view", out, "-o", page)
        self.assert_fails(CANNOT_WRITE, cleft("view", out, "-o", self.path("page.vtu")), "page.vtu", ".html")
        self.assert_fails(CANNOT_WRITE, cleft("view", out, "-o", self.path("none/page.html")), "none")
        self.assert_fails(CANNOT_READ, cleft("view", self.path("none.vtu"), "-o", page), "none.vtu")
        self.assert_fails(CANNOT_READ, cleft(*view, "--report", self.path("bad.json")), "bad.json")
        self.assert_fails(CANNOT_READ, cleft(*view, "--names", self.path("bad.txt")), "bad.txt", "line 1")
        self.assert_fails(USAGE, cleft("view", out), "--output")
        self.assert_fails(USAGE, cleft("view", out, out, out, "-o", page))
        self.assert_fails(
            USAGE, cleft(*view, "--report", self.path("report.json"), "--report", self.path("report.json"))
        )
        for option, value, limits in (
            ("--goal", "91", "(above 0, at most 90)"),
            ("--goal", "nan", "(above 0, at most 90)"),
            ("--max-shown", "0", "(whole, at least 1)"),
            ("--max-shown", "1.5", "(whole, at least 1)"),
        ):
            done = cleft(*view, option, value)
            self.assert_fails(USAGE, done, f"cleft view: {option}: '{value}'", limits)
            self.assertLess(len(done.stderr), 150)
        self.assert_fails(USAGE, cleft("mesh", self.volume, "-o", page, "--view", page))
        self.assert_fails(CANNOT_WRITE, cleft("mesh", self.volume, "--view", self.path("a.vtu")), "a.vtu")
        self.path("names.html").write_text("3 precious\n")
        self.assert_fails(USAGE, cleft("view", out, "-o", self.path("names.html"), "--names", self.path("names.html")))
        self.assertEqual(self.path("names.html").read_text(), "3 precious\n")
        self.assertFalse(page.exists())


if __name__ == "__main__":
    unittest.main()
