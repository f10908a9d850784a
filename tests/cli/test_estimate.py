"""`cleft mesh --estimate` against the mesh: numbers within 15 %, memory from the peak to twice it."""
import json
import os
import unittest

from support import CommandTest, write_nrrd

BACKGROUNDS = ("particles", "lattice", "octree")
OFF = 0.15  # of the number
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

    def assert_estimated(self, *arguments, off=OFF):
        arguments = (*arguments, "--quiet", "--threads", 1, "--json", self.path("r.json"))
        self.run_ok("mesh", *arguments, "--estimate")
        estimate = json.loads(self.path("r.json").read_text())["estimate"]
        self.run_ok("mesh", *arguments, "-o", self.path("out.vtu"))
        report = json.loads(self.path("r.json").read_text())
        tets, peak = report["mesh"]["tets"], max(stage["peak_bytes"] for stage in report["stages"])
        self.assertFalse(estimate["is_bound"])
        self.assertLess(abs(estimate["tets"] / tets - 1), off, (arguments, tets, estimate))
        self.assertTrue(1 <= estimate["peak_bytes"] / peak <= MOST_TIMES, (arguments, peak, estimate))

    def test_shapes_on_every_background(self):
        shapes = {
            "shell": ((48, 48, 48), lambda x, y, z: int(14 < distance(x, y, z, (23.5, 23.5, 23.5)) < 18)),
            "plate": ((80, 8, 80), lambda x, y, z: int(3 <= y < 5)),
            "checker": ((14, 14, 14), lambda x, y, z: (x + y + z) % 2),
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


if __name__ == "__main__":
    unittest.main()
