"""cleft check distinguishes sound meshes from broken ones, and where they are broken."""
import json
import unittest

from support import CANNOT_READ, CHECK_FAILED, OK, CommandTest, cleft

CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]


class Check(CommandTest):
    def check(self, points, tets, *options):
        """Writes a MEDIT mesh (points are counted from 1) and checks it."""
        lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
        lines += ["%r %r %r 0" % tuple(map(float, point)) for point in points]
        lines += ["Tetrahedra", str(len(tets))] + ["%d %d %d %d 1" % tet for tet in tets] + ["End", ""]
        self.path("a.mesh").write_text("\n".join(lines))
        return cleft("check", self.path("a.mesh"), *options)

    def assert_broken(self, done, *words):
        self.assertEqual(done.returncode, CHECK_FAILED, done.stdout + done.stderr)
        for word in ("Valid", "NO", *words):
            self.assertIn(word, done.stdout)

    def test_sound(self):
        done = self.check(CORNERS[:4], [(1, 2, 3, 4)])
        self.assertEqual(done.returncode, OK, done.stdout)
        self.assertRegex(done.stdout, r"Valid\s+yes")
        self.assertIn("Angles", done.stdout)
        self.assertEqual(self.check(CORNERS, [(1, 2, 3, 4), (2, 3, 4, 5)]).returncode, OK)

    def test_inside_out(self):
        self.assert_broken(self.check(CORNERS[:4], [(1, 3, 2, 4)]), "1 tetrahedra turned inside out")

    def test_flat(self):
        points = CORNERS[:3] + [(1, 1, 0)]
        self.assert_broken(self.check(points, [(1, 2, 3, 4)]), "flat")

    def test_crowded_face(self):
        points = CORNERS + [(2, 2, 2)]
        self.assert_broken(self.check(points, [(1, 2, 3, 4), (2, 3, 4, 5), (2, 3, 4, 6)]), "faces of more than two")

    def test_unused_point(self):
        self.assert_broken(self.check(CORNERS, [(1, 2, 3, 4)]), "points of no tetrahedron")

    def test_repeated_point(self):
        points = CORNERS[:4] + [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
        self.assert_broken(self.check(points, [(1, 2, 3, 4), (5, 6, 7, 8)]), "repeated points")

    def test_filling_the_box_is_asked_on_request_only(self):
        self.assertEqual(self.check(CORNERS[:4], [(1, 2, 3, 4)]).returncode, OK)
        self.assertEqual(self.check(CORNERS[:4], [(1, 2, 3, 4)], "--fills-box").returncode, CHECK_FAILED)
        self.mesh(self.volume)
        self.run_ok("check", self.path("out.vtu"), "--fills-box")

    def test_report_is_written_for_broken_meshes_too(self):
        done = self.check(CORNERS[:4], [(1, 3, 2, 4)], "--json", self.path("r.json"), "--quiet")
        self.assertEqual(done.returncode, CHECK_FAILED)
        self.assertEqual(done.stdout, "")
        validation = json.loads(self.path("r.json").read_text())["validation"]
        self.assertFalse(validation["valid"])
        self.assertEqual(validation["negative_tets"], 1)
        self.assertIn("tetrahedron", validation["first_fault"])

    def test_unreadable(self):
        self.path("a.mesh").write_text("MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0 0\n")
        self.assert_fails(CANNOT_READ, cleft("check", self.path("a.mesh")), "a.mesh")
        self.assert_fails(CANNOT_READ, cleft("check", self.path("missing.vtu")), "missing.vtu")


if __name__ == "__main__":
    unittest.main()
