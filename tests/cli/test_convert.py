"""cleft convert keeps a mesh what it is."""
import errno
import json
import os
import unittest

from support import CANNOT_READ, CANNOT_WRITE, CommandTest, cleft


class Convert(CommandTest):
    def info(self, name):
        return json.loads(self.run_ok("info", self.path(name), "--json", "-").stdout)["mesh"]

    def test_around_all_formats_that_can_be_read(self):
        self.mesh(self.volume, output="start.vtu")
        previous = "start.vtu"
        for name in ("a.mesh", "c.vtk", "d.node", "end.vtu"):
            self.run_ok("convert", self.path(previous), self.path(name))
            previous = name
        self.assertEqual(self.info("start.vtu"), self.info("end.vtu"))
        self.assertEqual(self.path("start.vtu").read_bytes(), self.path("end.vtu").read_bytes())

    def test_gmsh_groups_elements_by_material_and_keeps_the_rest(self):
        self.mesh(self.volume, output="start.vtu")
        self.run_ok("convert", self.path("start.vtu"), self.path("a.msh"))
        self.run_ok("convert", self.path("a.msh"), self.path("grouped.vtu"))
        self.assertEqual(self.info("start.vtu"), self.info("grouped.vtu"))
        self.run_ok("convert", self.path("grouped.vtu"), self.path("b.msh"))
        self.run_ok("convert", self.path("b.msh"), self.path("again.vtu"))
        self.assertEqual(self.path("grouped.vtu").read_bytes(), self.path("again.vtu").read_bytes())

    def test_surfaces(self):
        self.mesh(self.volume)
        for name in ("a.stl", "a.ply", "a.inp"):
            self.run_ok("convert", self.path("out.vtu"), self.path(name))
            self.assertGreater(self.path(name).stat().st_size, 1000)

    def test_some_labels(self):
        self.mesh(self.volume)
        self.run_ok("convert", self.path("out.vtu"), self.path("a.msh"), "--strip", "0", "--msh-version", "2.2")
        self.assertEqual([row["label"] for row in self.info("a.msh")["labels"]], [3, 7])

    def test_report(self):
        self.mesh(self.volume)
        start, end = self.path("out.vtu"), self.path("a.msh")
        done = self.run_ok("convert", start, end, "--strip", "0", "--json", self.path("r.json"))
        report = json.loads(self.path("r.json").read_text())
        made = self.info("a.msh")
        self.assertEqual(
            (report["command"], report["inputs"], report["outputs"]), ("convert", [str(start)], [str(end)])
        )
        self.assertEqual((report["points"], report["tets"]), (made["points"], made["tets"]))
        self.assertEqual([stage["name"] for stage in report["stages"]], ["read", "strip", "write"])
        self.assertEqual(report["warnings"], [])
        self.assertIn("tetrahedra", done.stdout)
        done = self.run_ok("convert", start, end, "--json", "-")
        whole = json.loads(done.stdout)  # there is nothing else
        self.assertGreater(whole["tets"], report["tets"])
        self.assertEqual(whole["tets"], self.info("a.msh")["tets"])

    def test_failures(self):
        self.mesh(self.volume)
        self.assert_fails(CANNOT_WRITE, cleft("convert", self.path("out.vtu"), self.path("a.xyz")), "a.xyz")
        self.assert_fails(CANNOT_READ, cleft("convert", self.path("none.vtu"), self.path("a.msh")), "none.vtu")
        self.assertFalse(self.path("a.msh").exists())

    def test_folders_are_no_meshes(self):
        self.path("folder.vtu").mkdir()
        done = cleft("convert", self.path("folder.vtu"), self.path("a.msh"))
        self.assert_fails(CANNOT_READ, done, self.path("folder.vtu"), os.strerror(errno.EISDIR))


if __name__ == "__main__":
    unittest.main()
