"""The wheel and the install tree are whole: away from the build they work, and say the truth about themselves."""
import base64
import hashlib
import importlib.metadata
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

BUILD = sys.argv.pop(1)
(WHEEL,) = pathlib.Path(BUILD, "bindings/python").glob("cleft-*.whl")
USE = """
import cleft, numpy, pathlib
mesh = cleft.mesh(cleft.Volume(numpy.ones((4, 4, 4), int)), background="lattice", size=2.0)
assert mesh.validate(fills_box=True)
maps = pathlib.Path("/proc/self/maps").read_text()
lines = [line.split()[-1] for line in maps.splitlines() if "libcleft" in line]
assert lines and all(line.startswith(HERE) for line in lines), lines
"""


def distribution(folder):
    (found,) = importlib.metadata.distributions(name="cleft", path=[str(folder)])
    return found


def check_metadata(test, folder):
    """What `pip show` and indexes report about the package that is in a folder."""
    metadata = distribution(folder).metadata
    for field in ("Summary", "Author", "License", "Keywords", "License-File", "Requires-Python"):
        test.assertTrue(metadata[field], field)
    test.assertEqual(metadata["Version"], WHEEL.name.split("-")[1])
    test.assertIn("numpy", distribution(folder).requires)
    test.assertIn("Typing :: Typed", metadata.get_all("Classifier"))
    test.assertEqual(metadata["Description-Content-Type"], "text/markdown")
    test.assertIn("# Cleft from Python", metadata.get_payload())
    test.assertTrue((pathlib.Path(folder) / "cleft" / "py.typed").exists())


class Wheel(unittest.TestCase):
    def test_works_where_it_is_unpacked(self):
        with tempfile.TemporaryDirectory() as folder:
            zipfile.ZipFile(WHEEL).extractall(folder)
            environment = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
            environment["PYTHONPATH"] = folder
            subprocess.run([sys.executable, "-c", f"HERE = {folder!r}{USE}"], check=True, env=environment, cwd=folder)

    def test_what_is_missing_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            packages = pathlib.Path(folder, "a", "b", "c")
            for library, use, words in (
                ("libcleft_io.so.0", "cleft.formats()", ("Unsupported", "libcleft_io.so.0", "libgdcm3.0", "zlib1g")),
                ("libcleft.so.0", "", ("ImportError", "libcleft.so.0", "libtet1.5")),
            ):
                zipfile.ZipFile(WHEEL).extractall(packages)
                (packages / "cleft" / library).unlink()
                failed = subprocess.run(
                    [sys.executable, "-c", f"import cleft; {use}"],
                    cwd=packages,
                    text=True,
                    env={"PYTHONPATH": str(packages)},
                    stderr=subprocess.PIPE,
                )
                self.assertNotEqual(failed.returncode, 0)
                for word in words:
                    self.assertIn(word, failed.stderr.splitlines()[-1])

    def test_record(self):
        with zipfile.ZipFile(WHEEL) as wheel:
            names = set(wheel.namelist())
            record = next(name for name in names if name.endswith("/RECORD"))
            lines = [line.split(",") for line in wheel.read(record).decode().splitlines()]
            self.assertEqual({line[0] for line in lines}, names)
            for name, digest, size in lines:
                if name != record:
                    found = base64.urlsafe_b64encode(hashlib.sha256(wheel.read(name)).digest()).rstrip(b"=").decode()
                    self.assertEqual((digest, int(size)), (f"sha256={found}", len(wheel.read(name))))
            self.assertIn("cleft/libcleft.so.0", names)
            self.assertIn("cleft/py.typed", names)
            self.assertIn(record.replace("RECORD", "LICENSE"), names)

    def test_metadata(self):
        with tempfile.TemporaryDirectory() as folder:
            zipfile.ZipFile(WHEEL).extractall(folder)
            check_metadata(self, folder)

    def test_pip_installs_it(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(
                [
                    sys.executable,
                    "-m",
                    "pip",
                    "install",
                    "--quiet",
                    "--no-index",
                    "--no-deps",
                    "--no-compile",
                    "--root-user-action=ignore",
                    "--target",
                    folder,
                    str(WHEEL),
                ],
                check=True,
            )
            check_metadata(self, folder)
            self.assertEqual(distribution(folder).read_text("INSTALLER").strip(), "pip")


class Installed(unittest.TestCase):
    def test_the_install_tree_tells_of_itself(self):
        with tempfile.TemporaryDirectory() as folder:
            for component in ("runtime", "io", "python"):
                subprocess.run(
                    ["cmake", "--install", BUILD, "--component", component, "--prefix", "tree"],
                    check=True,
                    cwd=folder,
                    stdout=subprocess.DEVNULL,
                )
            (package,) = pathlib.Path(folder).rglob("cleft/__init__.py")
            packages = package.parent.parent
            check_metadata(self, packages)
            self.assertEqual(distribution(packages).read_text("INSTALLER").strip(), "cmake")
            for file in distribution(packages).files:
                data = (packages / file).read_bytes()
                if file.hash:
                    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
                    self.assertEqual((file.hash.value, file.size), (digest, len(data)), file)
            named = {str(file) for file in distribution(packages).files}
            self.assertEqual(named, {str(path.relative_to(packages)) for path in packages.rglob("*") if path.is_file()})
            script = "import cleft, importlib.metadata as m; assert m.version('cleft') == cleft.__version__"
            subprocess.run(
                [sys.executable, "-c", script],
                check=True,
                cwd=folder,
                env={**os.environ, "PYTHONPATH": str(packages), "PYTHONDONTWRITEBYTECODE": "1"},
            )


if __name__ == "__main__":
    unittest.main()
