"""`cleft mesh --estimate` against the mesh: numbers within 15 %, memory from the peak to twice it."""
import json
import os
import unittest

from support import CommandTest, write_nrrd

BACKGROUNDS = ("particles", "lattice", "octree")
OFF = 0.15  # of the number
ROUGHLY_OFF = 0.5  # where it is said to be rough
MOST_TIMES = 2  # the peak of memory


def grid(dims, value):
    """value(x, y, z) at the voxels' numbers, x fastest."""
    return [value(x, y, z) for z in range(dims[2]) for y in range(dims[1]) for x in range(dims[0])]


def distance(x, y, z, centre):
    return ((x - centre[0]) ** 2 + (y - centre[1]) ** 2 + (z - centre[2]) ** 2) ** 0.5


@unittest.skipIf(os.environ.get("SANITIZERS"), "sanitizers take memory of their own")
class Estimate(CommandTest):
    def volume_of(self, dims, value, kind="uint8", name="v.nrrd"):
        write_nrrd(self.path(name), dims, grid(dims, value), kind)
        return self.path(name)

    def assert_estimated(self, *arguments, off=OFF, rough=False):
        arguments = (*arguments, "--quiet", "--threads", 1, "--json", self.path("r.json"))
        self.run_ok("mesh", *arguments, "--estimate")
        estimate = json.loads(self.path("r.json").read_text())["estimate"]
        self.run_ok("mesh", *arguments, "-o", self.path("out.vtu"))
        report = json.loads(self.path("r.json").read_text())
        tets, peak = report["mesh"]["tets"], max(stage["peak_bytes"] for stage in report["stages"])
        self.assertEqual(estimate["is_rough"], rough)
        self.assertLess(abs(estimate["tets"] / tets - 1), off, (arguments, tets, estimate))
        self.assertTrue(1 <= estimate["peak_bytes"] / peak <= MOST_TIMES, (arguments, peak, estimate))

    def test_shapes_on_every_background(self):
        shapes = {
            "shell": ((48, 48, 48), lambda x, y, z: int(14 < distance(x, y, z, (23.5, 23.5, 23.5)) < 18)),
            "plate": ((80, 8, 80), lambda x, y, z: int(3 <= y < 5)),
        }
        for name, (dims, value) in shapes.items():
            volume = self.volume_of(dims, value)
            for background in BACKGROUNDS:
                with self.subTest(shape=name, background=background):
                    self.assert_estimated(volume, "--background", background)

    def test_one_size_everywhere(self):
        # A lattice fills the box, so that the number of tetrahedra before cleaving is known.
        dims = (20, 20, 20)
        volume = self.volume_of(dims, lambda x, y, z: int(distance(x, y, z, (10, 10, 10)) < 7))
        for size in (5, 2.3, 1.7):
            with self.subTest(size=size):
                self.assert_estimated(volume, "--size", size)

    def test_voxels_alone(self):
        dims = (110, 110, 110)
        for kind in ("uint8", "int16", "int32", "float"):
            volume = self.volume_of(dims, lambda x, y, z: int(distance(x, y, z, (50, 50, 50)) < 40), kind)
            with self.subTest(kind=kind):
                self.assert_estimated(volume)
        sizes = self.volume_of(dims, lambda x, y, z: 15, "float", "sizes.nrrd")
        self.assert_estimated(volume, "--sizing", sizes)

    def test_indicator_functions(self):
        dims, centres = (60, 60, 60), [(15 + 10 * i, 20 + 5 * i, 30) for i in range(4)]
        for kind in ("float", "double"):
            functions = [
                self.volume_of(dims, lambda x, y, z: 12 - distance(x, y, z, centre), kind, "f%d.nrrd" % i)
                for i, centre in enumerate(centres)
            ]
            for count in (1, 2, 4):
                with self.subTest(kind=kind, count=count):
                    self.assert_estimated(*functions[:count])

    def test_every_rule_of_snapping(self):
        volume = self.volume_of((32, 32, 32), lambda x, y, z: int(distance(x, y, z, (15, 16, 14)) < 9))
        for rule in ("none", "safe"):
            for background in BACKGROUNDS:
                with self.subTest(rule=rule, background=background):
                    self.assert_estimated(volume, "--snap", rule, "--background", background, "--size", 2)

    def test_every_angle(self):
        # Grains around ten places.
        seeds = [(7 * i % 32, 13 * i % 32, 19 * i % 32) for i in range(10)]
        volume = self.volume_of((32, 32, 32), lambda x, y, z: min(range(10), key=lambda i: distance(x, y, z, seeds[i])))
        for options in (("--min-angle", 20), ("--min-angle", 30), ("--improve", "off")):
            with self.subTest(options=options):
                self.assert_estimated(volume, *options)

    def test_files_of_masks(self):
        # Read one after the other, they need no more memory than one label map.
        dims = (100, 100, 100)
        masks = [
            self.volume_of(dims, lambda x, y, z: int(12 * i <= z < 12 * i + 12), "int32", "m%d.nrrd" % i)
            for i in range(8)
        ]
        self.assert_estimated(*masks)

    def test_a_number_that_the_limit_does_not_let_be(self):
        # The small label would have 2,000 tetrahedra in a mesh that is far too large.
        volume = self.volume_of((40, 40, 40), lambda x, y, z: int(distance(x, y, z, (20, 20, 20)) < 4))
        limits = ("--only", 1, "--tets", 3000, "--max-tets", 30000)
        # Cells of a lattice fit the box in whole numbers, so that it stays a jump below the limit.
        for background, off in (("particles", OFF), ("lattice", 0.25)):
            with self.subTest(background=background):
                self.assert_estimated(volume, *limits, "--background", background, off=off)

    def test_edges_that_are_long_against_the_parts(self):
        # Several interfaces cross an edge: the number is said to be rough.
        checker = self.volume_of((14, 14, 14), lambda x, y, z: (x + y + z) % 2)
        for background in BACKGROUNDS:
            with self.subTest(background=background):
                self.assert_estimated(checker, "--background", background, off=ROUGHLY_OFF, rough=True)
        slabs = self.volume_of((60, 60, 60), lambda x, y, z: x // 5)
        for size, rough in ((20, True), (5, False)):
            self.run_ok("mesh", slabs, "--size", size, "--estimate", "--quiet", "--json", self.path("r.json"))
            estimate = json.loads(self.path("r.json").read_text())["estimate"]
            self.assertEqual(estimate["is_rough"], rough)


if __name__ == "__main__":
    unittest.main()
