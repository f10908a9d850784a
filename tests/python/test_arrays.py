"""Arrays in: any order, stride, type and byte order; their axes and their place in the world."""
import pathlib
import tempfile
import unittest

import numpy as np

import cleft
from support import QUICK, ball_labels, same_mesh


def meshed(labels, **world):
    return cleft.mesh(cleft.Volume(labels, **world), **QUICK)


class Arrays(unittest.TestCase):
    def setUp(self):
        self.labels = ball_labels()
        self.wanted = meshed(self.labels)

    def test_memory_order_does_not_matter(self):
        wide = np.zeros((24, 13, 28), np.uint8)
        wide[::2, :, ::2] = self.labels
        backwards = np.ascontiguousarray(self.labels[::-1, :, ::-1])
        for array in (
            np.ascontiguousarray(self.labels),
            np.asfortranarray(self.labels),
            wide[::2, :, ::2],
            backwards[::-1, :, ::-1],
            np.ascontiguousarray(self.labels.transpose(2, 1, 0)).transpose(2, 1, 0),
        ):
            self.assertTrue(same_mesh(meshed(array), self.wanted))

    def test_every_whole_number_type(self):
        for kind in "int8 uint8 int16 uint16 int32 uint32 int64 uint64 >i2 >i4 >u4 >i8".split():
            self.assertTrue(same_mesh(meshed(self.labels.astype(kind)), self.wanted), kind)
        flags = meshed(self.labels > 0)
        self.assertEqual(flags.different_labels.tolist(), [0, 1])

    def test_lists_are_arrays(self):
        self.assertTrue(same_mesh(meshed(self.labels.tolist()), self.wanted))

    def test_labels_keep_their_values(self):
        labels = np.where(self.labels == 7, -(2**31), 2**31 - 1)
        self.assertEqual(meshed(labels).different_labels.tolist(), [-(2**31), 2**31 - 1])

    def test_labels_beyond_32_bits(self):
        for value in (2**31, -(2**31) - 1, 2**40):
            with self.assertRaises(OverflowError):
                cleft.Volume(np.where(self.labels == 7, value, 0))

    def test_voxels_are_copied(self):
        labels = self.labels.copy()
        volume = cleft.Volume(labels)
        labels[:] = 5
        self.assertTrue(same_mesh(cleft.mesh(volume, **QUICK), self.wanted))

    def test_whole_numbers_of_a_real_type_are_labels(self):
        for kind in "f2 f4 f8 >f4 >f8 g".split():
            self.assertTrue(same_mesh(meshed(np.asfortranarray(self.labels.astype(kind))), self.wanted), kind)
        self.assertEqual(
            cleft.Volume(np.where(self.labels == 7, -(2.0**31), 2.0**31 - 1)).labels.tolist(),
            [-(2**31), 2**31 - 1],
        )
        with self.assertRaises(OverflowError):
            cleft.Volume(np.where(self.labels == 7, 2.0**31, 0))

    def test_numbers_that_are_not_whole_are_named(self):
        for value in (0.988, 7014.9999, -0.5):
            labels = self.labels.astype(float)
            labels[3, 4, 5] = value
            with self.assertRaisesRegex(ValueError, rf"labels\[3, 4, 5\] is {value}.*rint.*from_indicators"):
                cleft.Volume(labels)
        for value in (np.nan, np.inf, -np.inf):
            labels[0, 2, 13] = value
            with self.assertRaisesRegex(cleft.NotFinite, r"labels\[0, 2, 13\]"):
                cleft.Volume(labels)

    def test_arrays_that_cannot_be_written_to(self):
        frozen = self.labels.copy()
        frozen.flags.writeable = False
        self.assertTrue(same_mesh(meshed(frozen), self.wanted))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "labels.npy")
            np.save(path, self.labels)
            self.assertTrue(same_mesh(meshed(np.load(path, mmap_mode="r")), self.wanted))

    def test_masked_arrays(self):
        hidden = np.ma.masked_equal(self.labels, 7)
        with self.assertRaisesRegex(TypeError, "masked"):
            cleft.Volume(hidden)
        with self.assertRaisesRegex(TypeError, "masked"):
            cleft.Volume.from_indicators([hidden.astype(float)])
        self.assertEqual(cleft.Volume(hidden.filled(0)).labels.tolist(), [0, 1])
        self.assertTrue(same_mesh(meshed(np.ma.masked_array(self.labels)), self.wanted))  # with nothing masked
        mesh = self.wanted
        with self.assertRaisesRegex(TypeError, "masked"):
            cleft.Mesh(np.ma.masked_less(mesh.points, 1.0), mesh.tets)
        with self.assertRaisesRegex(TypeError, "masked"):
            cleft.Mesh(mesh.points, mesh.tets, np.ma.masked_equal(mesh.labels, 7))

    def test_wrong_arrays(self):
        for kind in ("c16", "m8[s]", "M8[s]", "O", "S1", "U1", [("a", "i4")]):
            with self.assertRaises(TypeError):
                cleft.Volume(np.zeros((2, 2, 2), kind))
            with self.assertRaises(TypeError):
                cleft.Volume.from_indicators([np.zeros((2, 2, 2), kind)])
            with self.assertRaises(TypeError):
                cleft.Mesh(np.zeros((4, 3)), np.zeros((1, 4), kind))
        with self.assertRaises(TypeError):
            cleft.Volume(None, affine=np.eye(4))
        with self.assertRaises(TypeError):
            cleft.Volume("labels")
        for wrong, reported in (
            ((3, 3), "two dimensions.*one slice"),
            ((2, 2, 2, 2), "4 dimensions"),
            ((0, 2, 2), "no voxels"),
            ((0,), "1 dimensions"),
        ):
            with self.assertRaisesRegex(ValueError, reported):
                cleft.Volume(np.zeros(wrong, int))

    def test_first_index_runs_along_x(self):
        volume = cleft.Volume(self.labels, spacing=(0.5, 1, 2), origin=(10, 20, 30))
        self.assertEqual(volume.shape, (12, 13, 14))
        i, j, k = np.meshgrid(range(12), range(13), range(14), indexing="ij")
        centers = np.column_stack([10 + 0.5 * i.ravel(), 20 + j.ravel(), 30 + 2 * k.ravel()])
        self.assertTrue(np.array_equal(volume.sample(centers), self.labels.ravel()))
        mesh = cleft.mesh(volume, **QUICK)
        self.assertTrue(np.allclose(mesh.points.min(0), (9.75, 19.5, 29)))
        self.assertTrue(np.allclose(mesh.points.max(0), (15.75, 32.5, 57)))

    def test_affine(self):
        affine = np.array([[0, -2, 0, 5], [1, 0, 0, 6], [0, 0, 3, 7.0], [0, 0, 0, 1]])
        for given in (affine, affine[:3], np.asfortranarray(affine), affine.astype(np.float32), affine.tolist()):
            self.assertTrue(np.array_equal(cleft.Volume(self.labels, affine=given).affine, affine))

    def test_default_world(self):
        self.assertTrue(np.array_equal(cleft.Volume(self.labels).affine[:, 3], (0.5, 0.5, 0.5, 1)))
        self.assertTrue(np.array_equal(cleft.Volume(self.labels, spacing=(1, 2, 4)).affine[:3, 3], (0.5, 1, 2)))
        self.assertTrue(np.array_equal(cleft.Volume(self.labels, origin=(1, 2, 3)).affine[:3, 3], (1, 2, 3)))

    def test_wrong_worlds(self):
        for world in (
            {"spacing": (1, 1)},
            {"spacing": (1, 0, 1)},
            {"spacing": (1, -1, 1)},
            {"origin": (1,)},
            {"spacing": (1, np.nan, 1)},
            {"origin": (np.inf, 0, 0)},
            {"affine": np.eye(3)},
            {"affine": np.zeros((3, 4))},
            {"affine": np.full((3, 4), np.nan)},
            {"affine": 2 * np.eye(4)},
        ):
            with self.assertRaises(ValueError):
                cleft.Volume(self.labels, **world)
        with self.assertRaises(cleft.NotFinite):
            cleft.Volume(self.labels, affine=np.full((4, 4), np.nan))
        for world in ({"spacing": "abc"}, {"affine": np.eye(4), "spacing": (1, 1, 1)}, {"spacing": 1j * np.ones(3)}):
            with self.assertRaises(TypeError):
                cleft.Volume(self.labels, **world)

    def test_indicators(self):
        i, j, k = np.ogrid[:12, :12, :12]
        distance = 4 - np.sqrt((i - 5.5) ** 2 + (j - 5.5) ** 2 + (k - 5.5) ** 2)
        one = cleft.mesh(cleft.Volume.from_indicators([distance]), **QUICK)
        self.assertEqual(one.different_labels.tolist(), [0, 1])
        two = cleft.mesh(cleft.Volume.from_indicators([-distance, distance.astype(np.float32)], [40, -3]), **QUICK)
        self.assertEqual(two.different_labels.tolist(), [-3, 40])
        with self.assertRaises(ValueError):
            cleft.Volume.from_indicators([])
        with self.assertRaises(ValueError):
            cleft.Volume.from_indicators([distance, distance[1:]])
        with self.assertRaises(ValueError):
            cleft.Volume.from_indicators([distance], [1, 2, 3])
        with self.assertRaises(cleft.NotFinite):
            cleft.Volume.from_indicators([distance * np.nan])
        bad = distance.copy()
        bad[2, 3, 10] = np.inf
        with self.assertRaisesRegex(
            cleft.NotFinite, "2nd indicator function .* 3rd along x, the 4th along y and the 11th"
        ):
            cleft.Volume.from_indicators([distance, bad])

    def test_masks_that_leave_voxels_to_nobody(self):
        masks = [self.labels == 1, self.labels == 7]
        nobody = int((self.labels == 0).sum())
        for of_type in (bool, np.uint8, float):
            with self.assertRaisesRegex(ValueError, f"^{nobody} of {self.labels.size} voxels.*label map"):
                cleft.Volume.from_indicators([mask.astype(of_type) for mask in masks])

    def test_functions_come_as_a_list(self):
        masks = np.stack([self.labels == label for label in (0, 1, 7)])
        volume = cleft.Volume.from_indicators(list(masks), [0, 1, 7])
        self.assertEqual(volume.voxel_counts, cleft.Volume(self.labels).voxel_counts)
        for array in (masks, np.moveaxis(masks, 0, -1), masks[1]):  # which axis counts them, nobody can tell
            with self.assertRaisesRegex(TypeError, "list of arrays"):
                cleft.Volume.from_indicators(array)


if __name__ == "__main__":
    unittest.main()
