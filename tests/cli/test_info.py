"""cleft info, on volumes and on meshes."""
import json
import unittest

from support import CANNOT_READ, DATA, CommandTest, cleft


class Info(CommandTest):
    def test_volume(self):
        report = json.loads(self.run_ok("info", DATA / "mickey.nrrd", "--json", "-").stdout)
        self.assertEqual(report["volume"]["dims"], [63, 63, 63])
        self.assertEqual(len(report["volume"]["labels"]), 5)
        self.assertEqual(sum(row["voxels"] for row in report["volume"]["labels"]), 63**3)

    def test_volume_as_text(self):
        text = self.run_ok("info", self.volume).stdout
        self.assertIn("16 x 16 x 16 voxels of 1 x 1 x 1, 3 labels", text)
        self.assertIn("(-0.5, -0.5, -0.5) to (15.5, 15.5, 15.5)", text)

    def test_mesh(self):
        made = self.mesh(self.volume)
        report = json.loads(self.run_ok("info", self.path("out.vtu"), "--json", "-").stdout)
        self.assertEqual(report["mesh"], made["mesh"])
        self.assertEqual(report["quality"], made["quality"])
        self.assertIn("tetrahedra", self.run_ok("info", self.path("out.vtu")).stdout)

    def test_neither(self):
        self.path("notes.txt").write_text("nothing of the kind")
        self.assert_fails(CANNOT_READ, cleft("info", self.path("notes.txt")), "notes.txt")
        self.assert_fails(CANNOT_READ, cleft("info", self.path("missing.nrrd")), "missing.nrrd")


if __name__ == "__main__":
    unittest.main()
