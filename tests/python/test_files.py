"""Reading and writing."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import cleft
from support import QUICK, ball_labels, ball_mesh, ball_volume, same_mesh

DATA = pathlib.Path(os.environ["TEST_DATA"])


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_meshes_there_and_back(self):
        mesh = ball_mesh()
        for name in ("ä ö.vtu", "a.msh", "a.mesh"):
            mesh.write(self.folder / name)
            again = cleft.read_mesh(self.folder / name)
            self.assertEqual(len(again.tets), len(mesh.tets))
            self.assertAlmostEqual(again.quality().total_volume, mesh.quality().total_volume, 9)
            self.assertEqual(cleft.guess(self.folder / name), "mesh")
        mesh.write(str(self.folder / "b.dat"), "msh22")
        self.assertIn(b"2.2", (self.folder / "b.dat").read_bytes()[:100])

    def test_formats(self):
        table = {row.name: row for row in cleft.formats()}
        self.assertTrue(table["vtu"].writes_mesh and table["vtu"].reads_mesh)
        self.assertTrue(any(".nii.gz" in row.extensions and row.reads_volume for row in table.values()))

    def test_reading_a_volume(self):
        volume = cleft.read_volume(DATA / "mickey.nrrd")
        self.assertGreater(len(volume.labels), 1)
        self.assertEqual(cleft.guess(DATA / "mickey.nrrd"), "volume")
        other = cleft.read_volume([str(DATA / "mickey.nrrd")], world="RAS", kind="labels", spacing=(0, 0, 9))
        self.assertTrue(np.allclose(np.linalg.norm(other.affine[:3, 2]), 9))
        self.assertTrue(np.allclose(other.affine[:2, 0], -volume.affine[:2, 0]))

    def test_raw(self):
        labels = ball_labels(kind=np.uint16)
        path = self.folder / "labels.raw"
        path.write_bytes(b"head" + labels.astype(">u2").tobytes(order="F"))
        volume = cleft.read_raw(path, labels.shape, "uint16", big_endian=True, skip=4, spacing=(1, 1, 1))
        self.assertTrue(same_mesh(cleft.mesh(volume, **QUICK), ball_mesh()))
        with self.assertRaises(cleft.CleftError):
            cleft.read_raw(path, (1, 1, 1), "uint16")
        for wrong in (((1, 1), "uint16"), ((1, 1, 1), "uint17")):
            with self.assertRaises(ValueError):
                cleft.read_raw(path, *wrong)

    def test_sizing_there_and_back(self):
        volume = ball_volume()
        sizing = cleft.Sizing(volume, size=2.5)
        cleft.write_sizing(sizing, self.folder / "sizes.nrrd")
        again = cleft.read_sizing(self.folder / "sizes.nrrd", volume)
        self.assertTrue(np.array_equal(again.values, sizing.values))
        values, affine = cleft.read_field(self.folder / "sizes.nrrd")
        self.assertEqual(values.shape, volume.shape)
        self.assertTrue(np.array_equal(values, sizing.values))
        self.assertTrue(np.allclose(affine, volume.affine))

    def test_failures(self):
        with self.assertRaises(OSError):
            cleft.read_volume(self.folder / "nothing.nii")
        with self.assertRaises(cleft.FileError):
            cleft.read_mesh(self.folder / "nothing.vtu")
        with self.assertRaises(OSError):
            ball_mesh().write(self.folder / "no such folder" / "a.vtu")
        (self.folder / "broken.vtu").write_text("not XML")
        with self.assertRaises(cleft.FormatError):
            cleft.read_mesh(self.folder / "broken.vtu")
        for use in (lambda: ball_mesh().write(self.folder / "a.xyz"), lambda: ball_mesh().write("a.vtu", "jpeg"),
                    lambda: cleft.read_volume([]), lambda: cleft.read_mesh("a\0b.vtu"),
                    lambda: cleft.read_volume(DATA / "mickey.nrrd", world="XYZ"),
                    lambda: cleft.read_volume(DATA / "mickey.nrrd", spacing=(1, np.nan, 1))):
            with self.assertRaises(ValueError):
                use()
        for use in (lambda: cleft.read_mesh(None), lambda: cleft.read_volume(3), lambda: cleft.read_volume([None]),
                    lambda: cleft.write_mesh(None, "a.vtu")):
            with self.assertRaises(TypeError):
                use()

    def test_files_are_loaded_late(self):
        script = "import sys, cleft; assert 'cleft.native_io' not in sys.modules; cleft.formats(); " \
                 "assert 'cleft.native_io' in sys.modules"
        subprocess.run([sys.executable, "-c", script], check=True)


if __name__ == "__main__":
    unittest.main()
