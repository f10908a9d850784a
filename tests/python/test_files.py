"""Reading and writing."""
import errno
import os
import pathlib
import pickle
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

    def test_tables_of_names(self):
        table = self.folder / "names.txt"
        table.write_text("1 heart\n7\tslab\n")
        volume = ball_volume()
        volume.read_label_names(table)
        self.assertEqual(volume.label_names, {1: "heart", 7: "slab"})
        mesh = ball_mesh()
        mesh.read_label_names(str(table), mesher=cleft.Mesher())
        self.assertEqual(mesh.label_names, {1: "heart", 7: "slab"})
        table.write_text("7 plate\n")
        with self.assertWarnsRegex(cleft.CleftWarning, "calls label 7 'plate'"):
            mesh.read_label_names(table)
        table.write_text("plate 7\n")
        with self.assertRaises(cleft.FormatError):
            mesh.read_label_names(table)
        with self.assertRaises(FileNotFoundError):
            mesh.read_label_names(self.folder / "none.txt")

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

    def test_scale(self):
        plain, small = (cleft.read_volume(DATA / "mickey.nrrd", scale=scale) for scale in (None, 0.001))
        self.assertTrue(np.allclose(small.affine[:3], plain.affine[:3] / 1000, rtol=1e-12))
        for wrong in (0, -1, float("nan"), float("inf")):
            with self.assertRaises(ValueError):
                cleft.read_volume(DATA / "mickey.nrrd", scale=wrong)
        cleft.write_sizing(cleft.Sizing.constant(plain, 2.0), self.folder / "sizes.nrrd")
        self.assertAlmostEqual(cleft.read_sizing(self.folder / "sizes.nrrd", small, scale=0.001).values.max(), 0.002, 9)
        self.assertTrue(np.allclose(cleft.read_field(self.folder / "sizes.nrrd", scale=0.001)[1], small.affine))
        with self.assertRaises(ValueError):
            cleft.read_sizing(self.folder / "sizes.nrrd", small)

    def test_raw(self):
        labels = ball_labels(kind=np.uint16)
        path = self.folder / "labels.raw"
        path.write_bytes(b"head" + labels.astype(">u2").tobytes(order="F"))
        volume = cleft.read_raw(path, labels.shape, "uint16", big_endian=True, skip=4, spacing=(1, 1, 1))
        self.assertTrue(same_mesh(cleft.mesh(volume, **QUICK), ball_mesh()))
        with self.assertRaises(cleft.CleftError):
            cleft.read_raw(path, (1, 1, 1), "uint16")
        for wrong in (((1, 1), "uint16"), (None, "uint16"), ("abc", "uint16"), ((1, 1, 1), "uint17")):
            with self.assertRaises(ValueError):
                cleft.read_raw(path, *wrong)
        for wrong in ((0, 0, 0), (1, 0, 1), (1, 1, -1), (1, 1, np.nan), (1, 1)):
            with self.assertRaisesRegex(ValueError, "spacing"):
                cleft.read_raw(path, labels.shape, "uint16", big_endian=True, skip=4, spacing=wrong)

    def test_kind_of_raw_voxels(self):
        one, two = self.folder / "one.raw", self.folder / "two.raw"
        voxels = np.indices((2, 2, 2))[0].astype("<f4")
        one.write_bytes(voxels.tobytes(order="F"))
        two.write_bytes((1 - voxels).tobytes(order="F"))
        for kind, functions in (("auto", 0), ("labels", 0), ("indicators", 1)):
            volume = cleft.read_raw(one, (2, 2, 2), "float32", kind=kind)
            self.assertEqual(volume.indicator_count, functions, kind)
            both = cleft.read_raw([one, two], (2, 2, 2), "float32", kind=kind)
            self.assertEqual(both.indicator_count, 2 * functions, kind)
        with self.assertRaisesRegex(ValueError, "kind is 'masks'; it must be one of auto, labels, indicators"):
            cleft.read_raw(one, (2, 2, 2), "float32", kind="masks")

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

    def test_metric_there_and_back(self):
        volume = ball_volume()
        tensors = np.tile((0.3, 0.01, -0.02, 0.4, 0.03, 0.5), volume.shape + (1,))
        tensors[..., 5] += np.arange(volume.shape[2]) / 100
        metric = cleft.Sizing.from_metric(volume, tensors).metric
        for name in ("metric.nrrd", "metric.vtk"):
            cleft.write_sizing(cleft.Sizing.from_metric(volume, tensors), self.folder / name)
            for given in (volume, None):
                again = cleft.read_metric(self.folder / name, given)
                self.assertLess(np.abs(again.metric - metric).max(), 1e-5)
            finer = cleft.read_metric(self.folder / name, volume, size_max=1.0)
            self.assertGreater(np.linalg.eigvalsh(finer.metric[..., [[0, 1, 2], [1, 3, 4], [2, 4, 5]]]).min(), 1 - 1e-5)
        with self.assertRaisesRegex(ValueError, "order is 'mmg'; it must be one of file, nrrd, vtk, nifti"):
            cleft.read_metric(self.folder / "metric.nrrd", volume, order="mmg")
        with self.assertRaises(TypeError):
            cleft.read_metric(self.folder / "metric.nrrd", tensors)
        with self.assertRaises(FileNotFoundError):
            cleft.read_metric(self.folder / "nothing.nrrd", volume)

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
        for use in (
            lambda: ball_mesh().write(self.folder / "a.xyz"),
            lambda: ball_mesh().write("a.vtu", "jpeg"),
            lambda: cleft.read_volume([]),
            lambda: cleft.read_mesh("a\0b.vtu"),
            lambda: cleft.read_volume(DATA / "mickey.nrrd", world="XYZ"),
            lambda: cleft.read_volume(DATA / "mickey.nrrd", spacing=(1, np.nan, 1)),
        ):
            with self.assertRaises(ValueError):
                use()
        for use in (
            lambda: cleft.read_mesh(None),
            lambda: cleft.read_volume(3),
            lambda: cleft.read_volume([None]),
            lambda: cleft.write_mesh(None, "a.vtu"),
        ):
            with self.assertRaises(TypeError):
                use()

    def failure(self, use, kind):
        """The exception of `use`, which must be of this class, of cleft's and of Python's."""
        with self.assertRaises(kind) as raised:
            use()
        self.assertIsInstance(raised.exception, cleft.FileError)
        self.assertIsInstance(raised.exception, OSError)
        self.assertEqual(raised.exception.status, -13)
        self.assertNotIn("[Errno", str(raised.exception))  # it is the library's sentence
        return raised.exception

    def test_files_that_are_not_there(self):
        there, volume = self.folder / "there.vtu", ball_volume()
        ball_mesh().write(there)
        (self.folder / "half.node").write_text("0 3 0 0\n")
        gone = self.folder / "gone.nii"
        for use, name in (
            (lambda: cleft.read_volume(gone), gone),
            (lambda: cleft.read_volume(str(gone)), gone),
            (lambda: cleft.read_volume([DATA / "mickey.nrrd", gone]), gone),
            (lambda: cleft.read_volume(self.folder / "slice*.png"), self.folder / "slice*.png"),
            (lambda: cleft.read_volume(self.folder / "slice%03d.png"), self.folder / "slice%03d.png"),
            (lambda: cleft.read_raw(gone, (2, 2, 2), "uint8"), gone),
            (lambda: cleft.read_field(gone), gone),
            (lambda: cleft.read_sizing(gone, volume), gone),
            (lambda: cleft.read_mesh(self.folder / "gone.vtu"), self.folder / "gone.vtu"),
            (lambda: cleft.read_mesh(self.folder / "half.node"), self.folder / "half.ele"),
            (lambda: ball_mesh().write(self.folder / "none" / "a.vtu"), self.folder / "none" / "a.vtu"),
            (
                lambda: cleft.write_sizing(cleft.Sizing(volume), self.folder / "none" / "a.nrrd"),
                self.folder / "none" / "a.nrrd",
            ),
        ):
            error = self.failure(use, FileNotFoundError)
            self.assertEqual((error.errno, error.filename), (errno.ENOENT, str(name)))
            again = pickle.loads(pickle.dumps(error))
            self.assertEqual((type(again), str(again), again.errno), (type(error), str(error), error.errno))

    def test_files_and_folders_that_cannot_be_used(self):
        (self.folder / "a.vtu").mkdir()
        for use in (lambda: cleft.read_mesh(self.folder / "a.vtu"), lambda: ball_mesh().write(self.folder / "a.vtu")):
            error = self.failure(use, IsADirectoryError)
            self.assertEqual((error.errno, error.filename), (errno.EISDIR, str(self.folder / "a.vtu")))
        (self.folder / "file").write_text("text")
        error = self.failure(lambda: ball_mesh().write(self.folder / "file" / "a.vtu"), NotADirectoryError)
        self.assertEqual(error.errno, errno.ENOTDIR)
        (self.folder / "noise.nii").write_bytes(b"noise")  # it is there, and can be read: the system has no number
        with self.assertRaises(cleft.CleftError) as raised:
            cleft.read_volume(self.folder / "noise.nii")
        self.assertNotIsInstance(raised.exception, FileNotFoundError)
        self.assertNotIn("Errno", str(raised.exception))
        if isinstance(raised.exception, cleft.FileError):
            self.assertEqual(raised.exception.filename, str(self.folder / "noise.nii"))
        if os.path.exists("/dev/full"):
            self.failure(lambda: ball_mesh().write("/dev/full", "vtu"), cleft.FileError)

    def test_files_without_permission(self):
        locked, path = self.folder / "locked", self.folder / "locked" / "a.vtu"
        locked.mkdir()
        ball_mesh().write(path)
        script = (
            "import cleft, errno, sys\n"
            "for use in (lambda: cleft.read_mesh(sys.argv[1]),\n"
            "            lambda: cleft.write_mesh(cleft.Mesh([], []), sys.argv[1])):\n"
            "    try: use()\n"
            "    except PermissionError as error: assert error.errno == errno.EACCES, error\n"
            "    else: sys.exit('allowed')\n"
        )
        script = script.replace(
            "cleft.Mesh([], [])", "cleft.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3]])"
        )
        path.chmod(0)
        locked.chmod(0o555)
        if os.geteuid() == 0:  # whom permissions do not stop
            self.folder.chmod(0o755)
            command = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
        else:
            command = []
        subprocess.run([*command, sys.executable, "-c", script, str(path)], check=True)
        locked.chmod(0o755)

    def test_shapes_are_whole_numbers(self):
        path = self.folder / "labels.raw"
        path.write_bytes(bytes(27))
        for shape, skip in (((3.7, 3, 3), 0), ((3, 3, 3), 0.5)):
            with self.assertRaises(TypeError):
                cleft.read_raw(path, shape, "uint8", skip=skip)
        self.assertEqual(cleft.read_raw(path, np.array([3, 3, 3]), "uint8").shape, (3, 3, 3))

    def test_pictures(self):
        mesh = ball_mesh()
        path = self.folder / "a.png"
        mesh.render(path, size=(64, 48), cut={"x": 0.5, "z": 0.5}, by="angle", legend=True, background="none")
        start = path.read_bytes()[:26]
        self.assertEqual(start[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(start[16:], bytes([0, 0, 0, 64, 0, 0, 0, 48, 8, 6]))
        cleft.write_picture(mesh, path, size=np.array([8, 8]), view=(0, 0, 1), up=(1, 0, 0), range=(0, 90), by="ratio")
        self.assertEqual(path.read_bytes()[16:26], bytes([0, 0, 0, 8, 0, 0, 0, 8, 8, 2]))
        mesh.render(path, strip=mesh.different_labels[:1], whole=[mesh.different_labels[1]], zoom=2, line_width=2)
        for wrong in (
            {"by": "colour"},
            {"background": "red"},
            {"cut": {"w": 0.5}},
            {"cut": {"x": 1.5}},
            {"size": (3,)},
            {"range": (1, 2, 3)},
            {"range": (2, 1)},
            {"zoom": 51},
            {"strip": mesh.different_labels},
        ):
            with self.assertRaises(cleft.InvalidArgument, msg=str(wrong)):
                mesh.render(path, **wrong)
        for wrong in ({"legend": "yes"}, {"strip": [0.5]}, {"zoom": "2"}, {"size": (3.5, 2)}):
            with self.assertRaises(TypeError, msg=str(wrong)):
                mesh.render(path, **wrong)
        with self.assertRaises(cleft.InvalidArgument):
            mesh.render(self.folder / "a.jpg")
        with self.assertRaises(FileNotFoundError):
            mesh.render(self.folder / "none" / "a.png")

    def test_views(self):
        mesh = ball_mesh()
        page = mesh.view(title="<ball>", report={"options": {"min_angle": 20}}, goal=15)
        self.assertTrue(page.html.startswith("<!DOCTYPE html>"))
        self.assertIn("<title>&#60;ball&#62;</title>", page.html)
        self.assertIn('{"options": {"min_angle": 20}}', page.html)
        self.assertIn('"goal":15,', page.html)
        page.write(self.folder / "a.html")
        names = self.folder / "names.txt"
        names.write_text("1 inner\n")
        cleft.write_view(mesh, self.folder / "b.html", title="<ball>", report='{"options": {"min_angle": 20}}', goal=15)
        self.assertEqual((self.folder / "a.html").read_bytes(), (self.folder / "b.html").read_bytes())
        both = mesh.view(other=mesh, title="a", other_title="b", names=names, max_tets=5).html
        for part in ("<title>a | b</title>", '"name":"inner"', '"shown_tets":5,', 'id="points-1"'):
            self.assertIn(part, both)
        frame = page._repr_html_()
        self.assertTrue(frame.startswith('<iframe srcdoc="&lt;!DOCTYPE html&gt;') and frame.endswith("></iframe>"))
        self.assertEqual(frame.count("<"), 2)
        self.assertRegex(repr(page), r"^<View: a page of [0-9.]+ MB>$")
        for wrong in ({"goal": 91}, {"title": "a\0"}):
            with self.assertRaises(cleft.InvalidArgument, msg=str(wrong)):
                mesh.view(**wrong)
        for wrong in ({"title": 1}, {"other": "mesh"}, {"goal": "20"}):
            with self.assertRaises(TypeError, msg=str(wrong)):
                mesh.view(**wrong)
        names.write_text("inner 1\n")
        with self.assertRaises(cleft.FormatError):
            mesh.view(names=names)
        with self.assertRaises(FileNotFoundError):
            cleft.write_view(mesh, self.folder / "none" / "a.html")

    def test_files_are_loaded_late(self):
        script = (
            "import sys, cleft; assert 'cleft.native_io' not in sys.modules; cleft.formats(); "
            "assert 'cleft.native_io' in sys.modules"
        )
        subprocess.run([sys.executable, "-c", script], check=True)


if __name__ == "__main__":
    unittest.main()
