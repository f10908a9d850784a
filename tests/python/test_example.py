"""The example runs, from a NIfTI file to pictures."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

EXAMPLE = sys.argv.pop(1)


def write_nifti(path, labels):
    """A NIfTI file of bytes: the header has 348 bytes, and 4 to say that no extension follows."""
    header = np.zeros(
        1,
        np.dtype(
            {
                "names": [
                    "size",
                    "dim",
                    "datatype",
                    "bitpix",
                    "pixdim",
                    "offset",
                    "sform",
                    "rows",
                    "magic",
                    "extension",
                ],
                "formats": ["<i4", ("<i2", 8), "<i2", "<i2", ("<f4", 8), "<f4", "<i2", ("<f4", (3, 4)), "S4", "S4"],
                "offsets": [0, 40, 70, 72, 76, 108, 254, 280, 344, 348],
            }
        ),
    )
    header["size"], header["datatype"], header["bitpix"], header["offset"], header["magic"] = 348, 2, 8, 352, b"n+1"
    header["dim"], header["pixdim"] = (3, *labels.shape, 1, 1, 1, 1), (1, 2, 2, 2, 0, 0, 0, 0)
    header["sform"], header["rows"] = 1, np.diag((2.0, 2, 2, 1))[:3]
    path.write_bytes(header.tobytes() + labels.tobytes(order="F"))


class Example(unittest.TestCase):
    def test_from_nifti_to_picture(self):
        labels = np.zeros((14, 12, 10), np.uint8)
        labels[3:11, 3:9, 3:7] = 4
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            write_nifti(path / "labels.nii", labels)
            done = subprocess.run(
                [sys.executable, EXAMPLE, path / "labels.nii", folder], capture_output=True, text=True
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("valid: True", done.stdout)
            for name in ("mesh.vtu", "mesh.png", "sizing.png"):
                self.assertGreater((path / name).stat().st_size, 1000)


if __name__ == "__main__":
    unittest.main()
