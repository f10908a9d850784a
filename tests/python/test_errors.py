"""Wrong use gives Python's ordinary exceptions."""
import copy
import pickle
import unittest

import numpy as np

import cleft
from cleft import native
from cleft.errors import _CLASSES, raise_for
from support import QUICK, ball_mesh, ball_volume


class Errors(unittest.TestCase):
    def test_closed_objects(self):
        volume, mesh = ball_volume(), ball_mesh()
        sizing, surface, mesher = cleft.Sizing(volume), mesh.surface(), cleft.Mesher()
        for thing in (volume, mesh, sizing, surface, mesher):
            self.assertFalse(thing.closed)
            with thing:
                pass
            self.assertTrue(thing.closed)
            thing.close()  # twice is allowed
            self.assertTrue(repr(thing))
        for use in (
            lambda: volume.shape,
            lambda: volume.labels,
            lambda: volume.sample([[0, 0, 0]]),
            lambda: cleft.mesh(volume),
            lambda: cleft.Sizing(volume),
            lambda: mesh.points,
            lambda: mesh.quality(),
            lambda: mesh.quadratic(),
            lambda: mesh.surface(),
            lambda: mesh.write("x.vtu"),
            lambda: mesh.__enter__(),
            lambda: sizing.values,
            lambda: sizing.has_metric,
            lambda: sizing.metric,
            lambda: sizing.at((0, 0, 0)),
            lambda: cleft.make_background(sizing),
            lambda: surface.hull_sides,
            lambda: mesher.threads,
            lambda: mesher.cancel(),
            lambda: mesher.metrics(),
            lambda: cleft.mesh(ball_volume(), mesher=mesher),
        ):
            with self.assertRaises(cleft.Closed):
                use()
        self.assertTrue(issubclass(cleft.Closed, ValueError))

    def test_wrong_objects(self):
        volume, mesh = ball_volume(), ball_mesh()
        for use in (
            lambda: cleft.mesh(mesh),
            lambda: cleft.mesh(None),
            lambda: cleft.mesh(3),
            lambda: cleft.mesh(volume, sizing=mesh),
            lambda: cleft.mesh(volume, background_mesh=volume),
            lambda: cleft.mesh(volume, mesher=3),
            lambda: cleft.mesh(volume, options=3),
            lambda: cleft.cleave(volume, None),
            lambda: cleft.improve(None, mesh),
            lambda: mesh.report(mesh),
            lambda: cleft.Sizing(None),
            lambda: cleft.Sizing.constant(volume, None),
            lambda: cleft.Mesher(threads="two"),
            lambda: cleft.Mesher(progress=3),
            lambda: cleft.strip_labels(volume),
        ):
            with self.assertRaises(TypeError):
                use()

    def test_wrong_meshes(self):
        points = np.eye(4, 3)
        for use in (
            lambda: cleft.Mesh(points, [[0, 1, 2, 4]]),
            lambda: cleft.Mesh(points, [[0, 1, 2, -1]]),
            lambda: cleft.Mesh(points, [[0, 1, 2, 3]], index_base=2),
            lambda: cleft.Mesh(points, [[0, 1, 2]]),
            lambda: cleft.Mesh(points * np.nan, [[0, 1, 2, 3]]),
            lambda: cleft.Mesh(points.T, [[0, 1, 2, 3]]),
            lambda: cleft.Mesh(points, [[0, 1, 2, 3]], [1, 2]),
            lambda: cleft.Mesh(points, [0, 1, 2, 3]),
            lambda: ball_mesh().copy_tets(3),
            lambda: ball_mesh().quadratic(-1),
        ):
            with self.assertRaises(ValueError):
                use()
        with self.assertRaises(TypeError):
            cleft.Mesh(points, [[0.0, 1.0, 2.0, 3.0]])
        with self.assertRaises(OverflowError):
            cleft.Mesh(points, [[0, 1, 2, 2**32 + 3]])

    def test_wrong_numbers(self):
        volume = ball_volume()
        for use in (
            lambda: cleft.Sizing.constant(volume, float("nan")),
            lambda: cleft.Sizing.constant(volume, 0),
            lambda: cleft.Sizing.constant(volume, -1),
            lambda: volume.sample([[0, np.nan, 0]]),
            lambda: volume.sample([0, 0, 0]),
            lambda: cleft.Mesher(threads=-1),
            lambda: cleft.Mesher(threads=10000),
            lambda: cleft.Sizing.constant(volume, 1).at((0, 0)),
        ):
            with self.assertRaises(ValueError):
                use()
        with self.assertRaises(OverflowError):
            cleft.Mesher(threads=2**40)
        for use, name in (
            (lambda: cleft.Sizing.constant(volume, "2"), "size"),
            (lambda: cleft.Sizing.constant(volume, None), "size"),
            (lambda: cleft.Sizing.from_values(volume, np.ones(volume.shape), combine="yes"), "combine"),
            (lambda: ball_mesh().validate(fills_box=3), "fills_box"),
            (lambda: setattr(volume, "label_names", ["a"]), "label_names"),
        ):
            with self.assertRaisesRegex(TypeError, name):
                use()

    def test_strict(self):
        labels = np.zeros((20, 20, 20), int)
        labels[10, 10, 10] = 1
        with self.assertRaises(cleft.LabelLost):
            cleft.mesh(cleft.Volume(labels), background="lattice", size=8.0, improve="off", snap="none", strict=True)

    def test_every_status_has_a_class(self):
        statuses = {number for name, number in vars(native).items() if name.startswith("CLEFT_ERROR_")}
        self.assertGreater(len(statuses), 14)
        for number in statuses:
            with self.assertRaises(cleft.CleftError) as raised:
                raise_for(number, "a sentence")
            self.assertEqual(raised.exception.status, number)
            self.assertEqual(str(raised.exception), "a sentence")
            self.assertIn(number, _CLASSES)
        for kind, natural in (
            (cleft.OutOfMemory, MemoryError),
            (cleft.InvalidArgument, ValueError),
            (cleft.FileError, OSError),
            (cleft.FileMissing, FileNotFoundError),
            (cleft.FileForbidden, PermissionError),
            (cleft.FileIsFolder, IsADirectoryError),
            (cleft.FolderIsFile, NotADirectoryError),
            (cleft.OptionError, ValueError),
        ):
            self.assertTrue(issubclass(kind, natural))

    def test_what_belongs_to_a_mesher_says_so(self):
        volume = cleft.Volume(np.ones((4, 4, 4), int))
        for name in ("progress", "threads", "log"):
            with self.assertRaisesRegex(TypeError, rf"'{name}' .* mesher=cleft.Mesher\({name}=...\)"):
                cleft.mesh(volume, **{name: True})

    def test_copies_and_pickles(self):
        mesh = ball_mesh()
        twin = copy.copy(mesh)
        mesh.close()
        self.assertGreater(len(twin.points), 0)
        with self.assertRaises(TypeError):
            pickle.dumps(twin)
        with self.assertRaises(TypeError):
            copy.deepcopy(twin)


class Views(unittest.TestCase):
    def test_views_are_no_copies_and_read_only(self):
        mesh = ball_mesh()
        self.assertEqual(mesh.points.ctypes.data, mesh.points.ctypes.data)
        self.assertFalse(mesh.points.flags.owndata)
        for array in (mesh.points, mesh.tets, mesh.labels, mesh.different_labels, mesh.surface().hull_sides):
            with self.assertRaises(ValueError):
                array[0] = 0
            with self.assertRaises(ValueError):
                array.flags.writeable = True

    def test_views_keep_the_memory(self):
        mesh = ball_mesh(24, size=1.5)
        points, wanted = mesh.points, mesh.points.copy()
        part = mesh.points[5:9].T
        mesh.close()
        del mesh
        others = [ball_mesh(24, size=1.5 + 0.01 * n) for n in range(3)]  # would go where the memory was
        self.assertTrue(np.array_equal(points, wanted))
        self.assertTrue(np.array_equal(part, wanted[5:9].T))
        self.assertEqual(len(others), 3)

    def test_empty_mesh(self):
        empty = cleft.Mesh(np.zeros((0, 3)), np.zeros((0, 4), int))
        self.assertEqual((empty.points.shape, empty.tets.shape, empty.labels.shape), ((0, 3), (0, 4), (0,)))
        self.assertFalse(empty.points.flags.writeable)

    def test_quick_options_are_options(self):
        self.assertTrue(cleft.Options(**QUICK))


if __name__ == "__main__":
    unittest.main()
