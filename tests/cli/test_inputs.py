"""What can be read: raw voxels, indicator functions, both worlds."""
import json
import unittest

from support import CANNOT_READ, DATA, USAGE, CommandTest, balls, cleft, write_nrrd


class Inputs(CommandTest):
    def test_raw_voxels(self):
        self.path("balls.raw").write_bytes(b"header" + bytes(balls()))
        raw = self.mesh(
            self.path("balls.raw"), "--dims", 16, 16, 16, "--type", "uint8", "--skip", 6, "--spacing", 0.5, 0.5, 2
        )
        self.assertEqual(raw["volume"]["dims"], [16, 16, 16])
        self.assertEqual(raw["volume"]["spacing"], [0.5, 0.5, 2])
        self.assertEqual([row["label"] for row in raw["labels"]], [0, 3, 7])
        self.assertAlmostEqual(raw["quality"]["total_volume"], 8 * 8 * 32, places=6)

    def test_raw_voxels_with_the_other_byte_order(self):
        self.path("b.raw").write_bytes(b"".join(bytes([0, label]) for label in balls()))
        raw = self.mesh(self.path("b.raw"), "--dims", "16,16,16", "--type", "uint16", "--big-endian")
        self.assertEqual([row["label"] for row in raw["labels"]], [0, 3, 7])

    def test_a_layout_of_raw_voxels_needs_their_dimensions(self):
        """A header tells them otherwise, so they would have no effect."""
        for words in (["--type", "uint16"], ["--skip", 6], ["--big-endian"]):
            self.assert_fails(USAGE, cleft("info", self.volume, *words), words[0], "--dims")

    def test_several_inputs_are_indicator_functions(self):
        report = self.mesh(*[DATA / ("spheres%d.nrrd" % i) for i in (1, 2, 3, 4)])
        self.assertEqual([row["label"] for row in report["labels"]], [0, 1, 2, 3])
        self.assertEqual(report["volume"]["dims"], [28, 28, 28])

    def test_one_float_input_is_a_signed_function(self):
        n = 16
        values = [
            5.0 - ((x - 7.5) ** 2 + (y - 7.5) ** 2 + (z - 7.5) ** 2) ** 0.5
            for z in range(n)
            for y in range(n)
            for x in range(n)
        ]
        write_nrrd(self.path("ball.nrrd"), (n, n, n), values, "float")
        report = self.mesh(self.path("ball.nrrd"), "--size", 1)
        inside = [row for row in report["mesh"]["labels"] if row["label"] == 1][0]
        self.assertLess(abs(inside["volume"] / (4 / 3 * 3.14159265 * 125) - 1), 0.03)

    def test_spacing_replaces_that_of_the_file(self):
        report = self.mesh(self.volume, "--spacing", "2,2,2")
        self.assertAlmostEqual(report["quality"]["total_volume"], 32**3, places=6)

    def test_scale_takes_spacing_and_origin(self):
        write_nrrd(self.path("mm.nrrd"), (16, 16, 16), balls(), spacing=(1, 2, 1), origin=(40, -30, 20))
        box = self.mesh(self.path("mm.nrrd"), "--scale", 0.001)["mesh"]
        for got, wanted in zip(box["low"] + box["high"], (39.5, -31, 19.5, 55.5, 1, 35.5)):
            self.assertAlmostEqual(got, wanted / 1000, places=9)
        box = self.mesh(self.path("mm.nrrd"), "--scale", 0.001, "--spacing", "0.001,0.001,0.001")["mesh"]
        for got, wanted in zip(box["low"] + box["high"], (39.5, -30.5, 19.5, 55.5, -14.5, 35.5)):
            self.assertAlmostEqual(got, wanted / 1000, places=9)

    def test_scale_in_every_command_that_reads_volumes(self):
        write_nrrd(self.path("mm.nrrd"), (16, 16, 16), balls(), origin=(40, -30, 20))
        wanted = [0.001, 0, 0, 0.04, 0, 0.001, 0, -0.03, 0, 0, 0.001, 0.02]
        info = self.run_ok("info", self.path("mm.nrrd"), "--scale", 0.001, "--json", "-")
        self.run_ok("sizing", self.path("mm.nrrd"), "--scale", 0.001, "-o", self.path("h.nrrd"))
        field = self.run_ok("info", self.path("h.nrrd"), "--as", "indicators", "--json", "-")
        for done in (info, field):
            for got, value in zip(json.loads(done.stdout)["volume"]["affine"], wanted):
                self.assertAlmostEqual(got, value, places=9)
        made = self.mesh(self.path("mm.nrrd"), "--scale", 0.001, "--sizing", self.path("h.nrrd"))
        self.assertLess(made["mesh"]["high"][0], 0.06)
        self.run_ok("sizing", self.path("mm.nrrd"), "-o", self.path("mm_h.nrrd"))
        done = cleft("mesh", self.path("mm.nrrd"), "--scale", 0.001, "--sizing", self.path("mm_h.nrrd"), "--estimate")
        self.assert_fails(CANNOT_READ, done, "places")

    def test_scale_is_positive_and_not_for_raw_voxels(self):
        for value in (0, -1, "nan", "inf", "mm"):
            self.assert_fails(USAGE, cleft("info", self.volume, "--scale", value), "--scale")
            self.assert_fails(USAGE, cleft("info", self.volume, "--spacing", 1, value, 1), "--spacing")
        self.assert_fails(USAGE, cleft("info", self.volume, "--scale", 2, "--dims", 16, 16, 16), "--scale")

    def test_worlds_differ_by_two_signs(self):
        write_nrrd(self.path("moved.nrrd"), (16, 16, 16), balls(), spacing=(1, 2, 1), origin=(10, 20, 30))
        lps = self.mesh(self.path("moved.nrrd"))["mesh"]
        ras = self.mesh(self.path("moved.nrrd"), "--world", "ras")["mesh"]
        for i, wanted in enumerate((9.5, 19, 29.5)):
            self.assertAlmostEqual(lps["low"][i], wanted)
        for axis in (0, 1):
            self.assertAlmostEqual(ras["low"][axis], -lps["high"][axis])
            self.assertAlmostEqual(ras["high"][axis], -lps["low"][axis])
        self.assertAlmostEqual(ras["low"][2], lps["low"][2])


if __name__ == "__main__":
    unittest.main()
