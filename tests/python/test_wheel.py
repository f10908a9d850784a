"""The wheel is whole: unpacked anywhere, away from the build, it works, and RECORD tells the truth."""
import base64
import hashlib
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

WHEEL, = pathlib.Path(sys.argv.pop(1)).glob("cleft-*.whl")
USE = """
import cleft, numpy, pathlib
mesh = cleft.mesh(cleft.Volume(numpy.ones((4, 4, 4), int)), background="lattice", size=2.0)
assert mesh.validate(fills_box=True)
maps = pathlib.Path("/proc/self/maps").read_text()
lines = [line.split()[-1] for line in maps.splitlines() if "libcleft" in line]
assert lines and all(line.startswith(HERE) for line in lines), lines
"""


class Wheel(unittest.TestCase):
    def test_works_where_it_is_unpacked(self):
        with tempfile.TemporaryDirectory() as folder:
            zipfile.ZipFile(WHEEL).extractall(folder)
            environment = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
            environment["PYTHONPATH"] = folder
            subprocess.run([sys.executable, "-c", f"HERE = {folder!r}{USE}"], check=True, env=environment, cwd=folder)

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


if __name__ == "__main__":
    unittest.main()
