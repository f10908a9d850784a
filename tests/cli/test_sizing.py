"""cleft sizing, and meshing with a field of one's own."""
import array
import json
import unittest

from support import CANNOT_READ, CANNOT_WRITE, DATA, USAGE, CommandTest, cleft, write_nrrd


class Sizing(CommandTest):
    def field(self, *arguments):
        done = self.run_ok("sizing", *arguments, "-o", self.path("h.nrrd"), "--json", "-")
        return json.loads(done.stdout)["sizing"]

    def test_written_field_follows_the_options(self):
        sizes = self.field(self.volume, "--size-min", 0.7, "--size-max", 8)
        self.assertGreaterEqual(sizes["least"], 0.7 * 0.999)
        self.assertLessEqual(sizes["greatest"], 8 * 1.001)
        self.assertLess(sizes["least"], sizes["greatest"])
        self.assertGreater(sizes["expected_tets"], 100)

    def test_the_number_of_tetrahedra_is_bounded(self):
        free = self.field(DATA / "mickey.nrrd")
        bounded = self.field(DATA / "mickey.nrrd", "--max-tets", 3000)
        self.assertGreater(bounded["least"], free["least"])
        self.assertLess(bounded["expected_tets"], 3000 * 1.1)

    def test_written_field_lies_on_the_grid_of_the_volume(self):
        self.field(DATA / "CIT168.nrrd")
        volumes = [
            json.loads(self.run_ok("info", path, "--as", kind, "--json", "-").stdout)["volume"]
            for path, kind in ((DATA / "CIT168.nrrd", "labels"), (self.path("h.nrrd"), "indicators"))
        ]
        self.assertEqual(volumes[0]["dims"], volumes[1]["dims"])
        for a, b in zip(volumes[0]["affine"], volumes[1]["affine"]):
            self.assertAlmostEqual(a, b, places=4)

    def test_a_field_of_ones_own(self):
        write_nrrd(self.path("mine.nrrd"), (16, 16, 16), [3.0 if i % 16 > 8 else 1.0 for i in range(16**3)], "float")
        mine = self.mesh(self.volume, "--sizing", self.path("mine.nrrd"))
        coarse = self.mesh(self.volume, "--size", 3)
        fine = self.mesh(self.volume, "--size", 1)
        self.assertGreater(mine["mesh"]["tets"], coarse["mesh"]["tets"])
        self.assertLess(mine["mesh"]["tets"], fine["mesh"]["tets"])
        self.assertEqual(mine["options"]["sizing"], str(self.path("mine.nrrd")))

    def test_combined_field_is_no_coarser_than_either(self):
        write_nrrd(self.path("mine.nrrd"), (16, 16, 16), [4.0] * 16**3, "float")
        alone = self.mesh(self.volume, "--sizing", self.path("mine.nrrd"))["mesh"]["tets"]
        combined = self.mesh(self.volume, "--sizing", self.path("mine.nrrd"), "--combine")["mesh"]["tets"]
        self.assertGreater(combined, alone)

    def test_the_written_field_gives_a_mesh_of_about_its_size(self):
        expected = self.field(self.volume)["expected_tets"]
        tets = self.mesh(self.volume, "--sizing", self.path("h.nrrd"))["mesh"]["tets"]
        self.assertGreater(tets, 0.5 * expected)
        self.assertLess(tets, 4 * expected)

    def test_the_field_of_a_number_gives_the_mesh_of_the_one_call(self):
        for background in ("particles", "lattice", "octree"):
            with self.subTest(background):
                kept, wanted = ("--strip", 0, "--background", background), ("--tets", 8000)
                self.field(self.volume, *kept, *wanted)
                tets = self.mesh(self.volume, *kept, *wanted, output="one.vtu")["mesh"]["tets"]
                self.mesh(self.volume, *kept, "--sizing", self.path("h.nrrd"), output="two.vtu")
                self.assertEqual(self.path("one.vtu").read_bytes(), self.path("two.vtu").read_bytes())
                whole = self.field(self.volume, "--background", background, *wanted)
                self.assertGreater(whole["least"], self.field(self.volume, *kept, *wanted)["least"])
                if background != "lattice":
                    self.assertAlmostEqual(tets, 8000, delta=800)

    def test_labels_that_are_not_there_are_told(self):
        done = self.run_ok("sizing", self.volume, "--only", 3, 9, "-o", self.path("h.nrrd"))
        self.assertEqual(done.stderr.count("only names label 9, which the volume does not have"), 1)
        self.assert_fails(USAGE, cleft("sizing", self.volume, "--only", 9, "-o", self.path("h.nrrd")), "leave nothing")

    def metric(self, name, order=None):
        """A metric of lengths of 4 along x and y, and of 2 along z."""
        kinds = "3D-symmetric-matrix" if order is None else "???"
        numbers = [1 / 16, 0, 0, 1 / 16, 0, 1 / 4] if order is None else [1 / 16, 1 / 16, 1 / 4, 0, 0, 0]
        header = (
            "NRRD0005\ntype: double\ndimension: 4\nspace: left-posterior-superior\nsizes: 6 16 16 16\n"
            "space directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: %s domain domain domain\nendian: little\n"
            "encoding: raw\nspace origin: (0,0,0)\n\n" % kinds
        )
        self.path(name).write_bytes(header.encode() + array.array("d", numbers * 16**3).tobytes())
        return self.path(name)

    def test_a_metric_from_a_file_and_as_six_numbers_give_the_same_mesh(self):
        report = self.mesh(self.volume, "--metric", self.metric("m.nrrd"), output="one.vtu")
        self.mesh(self.volume, "--metric", "0.0625,0,0,0.0625,0,0.25", output="two.vtu")
        self.assertEqual(self.path("one.vtu").read_bytes(), self.path("two.vtu").read_bytes())
        self.assertEqual(report["options"]["metric"], str(self.path("m.nrrd")))
        found = report["metric_quality"]
        self.assertGreater(found["share_in_range"], 0.8)
        self.assertEqual(sum(found["dihedral_histogram"]), 6 * report["mesh"]["tets"])
        combined = self.mesh(self.volume, "--metric", self.path("m.nrrd"), "--combine")
        self.assertGreater(combined["mesh"]["tets"], report["mesh"]["tets"])

    def test_check_measures_by_a_metric(self):
        found = self.mesh(self.volume, "--metric", self.metric("m.nrrd"))["metric_quality"]
        for metric in ("m.nrrd", "0.0625,0,0,0.0625,0,0.25"):
            metric = self.path(metric) if metric == "m.nrrd" else metric
            done = self.run_ok("check", self.path("out.vtu"), "--metric", metric, "--json", "-")
            measured = json.loads(done.stdout)["metric_quality"]
            for name in ("edge_least", "edge_median", "mean_ratio_01", "min_dihedral"):
                self.assertAlmostEqual(measured[name], found[name], places=3)
        text = self.run_ok("check", self.path("out.vtu"), "--metric", self.path("m.nrrd")).stdout
        self.assertIn("mean ratio", text)
        self.assertIn("Dihedral angles in the metric", text)
        self.assertNotIn("metric_quality", json.loads(self.run_ok("check", self.path("out.vtu"), "--json", "-").stdout))

    def test_a_written_metric_gives_the_same_mesh(self):
        self.run_ok("sizing", self.volume, "--metric", self.metric("m.nrrd"), "-o", self.path("w.nrrd"))
        first = self.mesh(self.volume, "--metric", self.path("m.nrrd"))["metric_quality"]
        again = self.mesh(self.volume, "--metric", self.path("w.nrrd"))["metric_quality"]
        self.assertAlmostEqual(first["edge_median"], again["edge_median"], places=2)
        self.assert_fails(
            CANNOT_WRITE,
            cleft("sizing", self.volume, "--metric", self.path("m.nrrd"), "-o", self.path("w.mha")),
            ".nrrd or .vtk",
        )

    def test_a_metric_that_cannot_be_is_refused(self):
        vtk = self.metric("v.nrrd", "vtk")
        output = ("-o", self.path("out.vtu"))
        self.assert_fails(CANNOT_READ, cleft("mesh", self.volume, "--metric", vtk, *output), "in which order")
        self.run_ok("mesh", self.volume, "--metric", vtk, "--metric-order", "vtk", *output)
        self.assert_fails(CANNOT_READ, cleft("mesh", self.volume, "--metric", "1,0,0,1,0,-1", *output), "definite")
        self.assert_fails(USAGE, cleft("mesh", self.volume, "--metric", "1,0,0,1,0", *output), "--metric")
        self.assert_fails(USAGE, cleft("mesh", self.volume, "--metric", vtk, "--sizing", vtk, *output), "--sizing")

    def test_unknown_format(self):
        self.assert_fails(CANNOT_WRITE, cleft("sizing", self.volume, "-o", self.path("h.vtu")), "h.vtu")


if __name__ == "__main__":
    unittest.main()
