"""Arrays in: any order, stride, type and byte order; their axes and their place in the world."""
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
        for array in (np.ascontiguousarray(self.labels), np.asfortranarray(self.labels), wide[::2, :, ::2],
                      backwards[::-1, :, ::-1], np.ascontiguousarray(self.labels.transpose(2, 1, 0)).transpose(2, 1, 0)):
            self.assertTrue(same_mesh(meshed(array), self.wanted))

    def test_every_whole_number_type(self):
        for kind in "int8 uint8 int16 uint16 int32 uint32 int64 uint64 >i2 >i4 >u4 >i8".split():
            self.assertTrue(same_mesh(meshed(self.labels.astype(kind)), self.wanted), kind)
        flags = meshed(self.labels > 0)
        self.assertEqual(flags.different_labels.tolist(), [0, 1])

    def test_lists_are_arrays(self):
        self.assertTrue(same_mesh(meshed(self.labels.tolist()), self.wanted))

    def test_labels_keep_their_values(self):
        labels = np.where(self.labels == 7, -2**31, 2**31 - 1)
        self.assertEqual(meshed(labels).different_labels.tolist(), [-2**31, 2**31 - 1])

    def test_labels_beyond_32_bits(self):
        for value in (2**31, -2**31 - 1, 2**40):
            with self.assertRaises(OverflowError):
                cleft.Volume(np.where(self.labels == 7, value, 0))

    def test_voxels_are_copied(self):
        labels = self.labels.copy()
        volume = cleft.Volume(labels)
        labels[:] = 5
        self.assertTrue(same_mesh(cleft.mesh(volume, **QUICK), self.wanted))

    def test_wrong_arrays(self):
        with self.assertRaises(TypeError):
            cleft.Volume(self.labels.astype(float))
        with self.assertRaises(TypeError):
            cleft.Volume(np.full((2, 2, 2), None))
        with self.assertRaises(TypeError):
            cleft.Volume(None, affine=np.eye(4))
        with self.assertRaises(TypeError):
            cleft.Volume("labels")
        with self.assertRaisesRegex(TypeError, "masked"):
            cleft.Volume(np.ma.masked_equal(self.labels, 7))
        self.assertTrue(cleft.Volume(np.ma.masked_equal(self.labels, 7).filled(0)))
        for wrong in (np.zeros((3, 3), int), np.zeros((2, 2, 2, 2), int), np.zeros((0, 2, 2), int)):
            with self.assertRaises(ValueError):
                cleft.Volume(wrong)

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
        for world in ({"spacing": (1, 1)}, {"spacing": (1, 0, 1)}, {"spacing": (1, -1, 1)}, {"origin": (1,)},
                      {"spacing": (1, np.nan, 1)}, {"origin": (np.inf, 0, 0)}, {"affine": np.eye(3)},
                      {"affine": np.zeros((3, 4))}, {"affine": np.full((3, 4), np.nan)}, {"affine": 2 * np.eye(4)}):
            with self.assertRaises(ValueError):
                cleft.Volume(self.labels, **world)
        with self.assertRaises(cleft.NotFinite):
            cleft.Volume(self.labels, affine=np.full((4, 4), np.nan))
        for world in ({"spacing": "abc"}, {"affine": np.eye(4), "spacing": (1, 1, 1)}, {"spacing": 1j * np.ones(3)}):
            with self.assertRaises(TypeError):
                cleft.Volume(self.labels, **world)

    def test_indicators(self):
        i, j, k = np.ogrid[:12, :12, :12]
        distance = 4 - np.sqrt((i - 5.5)**2 + (j - 5.5)**2 + (k - 5.5)**2)
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


if __name__ == "__main__":
    unittest.main()
