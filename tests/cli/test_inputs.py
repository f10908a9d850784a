"""What can be read: raw voxels, indicator functions, both worlds."""
import unittest

from support import DATA, CommandTest, balls, write_nrrd


class Inputs(CommandTest):
    def test_raw_voxels(self):
        self.path("balls.raw").write_bytes(b"header" + bytes(balls()))
        raw = self.mesh(self.path("balls.raw"), "--dims", 16, 16, 16, "--type", "uint8", "--skip", 6,
                        "--spacing", 0.5, 0.5, 2)
        self.assertEqual(raw["volume"]["dims"], [16, 16, 16])
        self.assertEqual(raw["volume"]["spacing"], [0.5, 0.5, 2])
        self.assertEqual([row["label"] for row in raw["labels"]], [0, 3, 7])
        self.assertAlmostEqual(raw["quality"]["total_volume"], 8 * 8 * 32, places=6)

    def test_raw_voxels_with_the_other_byte_order(self):
        self.path("b.raw").write_bytes(b"".join(bytes([0, label]) for label in balls()))
        raw = self.mesh(self.path("b.raw"), "--dims", "16,16,16", "--type", "uint16", "--big-endian")
        self.assertEqual([row["label"] for row in raw["labels"]], [0, 3, 7])

    def test_several_inputs_are_indicator_functions(self):
        report = self.mesh(*[DATA / ("spheres%d.nrrd" % i) for i in (1, 2, 3, 4)])
        self.assertEqual([row["label"] for row in report["labels"]], [0, 1, 2, 3])
        self.assertEqual(report["volume"]["dims"], [28, 28, 28])

    def test_one_float_input_is_a_signed_function(self):
        n = 16
        values = [5.0 - ((x - 7.5) ** 2 + (y - 7.5) ** 2 + (z - 7.5) ** 2) ** 0.5
                  for z in range(n) for y in range(n) for x in range(n)]
        write_nrrd(self.path("ball.nrrd"), (n, n, n), values, "float")
        report = self.mesh(self.path("ball.nrrd"), "--size", 1)
        inside = [row for row in report["mesh"]["labels"] if row["label"] == 1][0]
        self.assertLess(abs(inside["volume"] / (4 / 3 * 3.14159265 * 125) - 1), 0.03)

    def test_spacing_replaces_that_of_the_file(self):
        report = self.mesh(self.volume, "--spacing", "2,2,2")
        self.assertAlmostEqual(report["quality"]["total_volume"], 32 ** 3, places=6)

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
