"""What a type checker makes of the package (mypy, strictly): its own code is sound, right use passes, wrong use is
seen.
"""
import os
import pathlib
import subprocess
import tempfile
import unittest

import cleft

PACKAGE = pathlib.Path(cleft.__file__).parent
RIGHT = """
import cleft
import numpy as np
import numpy.typing as npt

def show(fraction: float, stage: str) -> bool:
    return fraction < 0.5

options = cleft.Options(size_max=3.0, strip=[0])
volume = cleft.Volume(np.zeros((4, 4, 4), np.uint8), spacing=(1, 1, 2))
shown = cleft.Mesher(progress=True)
with cleft.mesh(volume, size=2.0, label_sizes={1: 0.5}, mesher=cleft.Mesher(threads=2, progress=show)) as mesh:
    points: npt.NDArray[np.float64] = mesh.points
    tets: npt.NDArray[np.int32] = mesh.tets
    least: float = mesh.quality().min_dihedral
cleaved: cleft.Mesh = cleft.cleave(volume, cleft.make_background(cleft.Sizing(volume)), options=options)
cleaved.write("mesh.vtu")
"""
WRONG = (
    "cleft.mesh(volume, sizemax=3.0)",
    'cleft.mesh(volume, size="two")',
    "cleft.mesh(3)",
    "cleft.Options(colour=1)",
    'cleft.Volume(labels, spacing="abc", smooth=2.5)',
    "cleft.Mesher(progress=lambda: True)",
    "cleft.Mesher(progress=1)",
    "mesh.quality().angle",
    "mesh.write(3)",
    'cleft.cleave(volume, background="octree")',
)


def checked(*arguments):
    """What mypy says."""
    environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent)}
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run(
            [
                "mypy",
                "--strict",
                "--no-error-summary",
                "--cache-dir",
                folder,
                "--ignore-missing-imports",
                "--enable-incomplete-feature=Unpack",
                *arguments,
            ],
            env=environment,
            stdout=subprocess.PIPE,
            text=True,
        ).stdout


class Types(unittest.TestCase):
    def test_everything(self):
        with tempfile.TemporaryDirectory() as folder:
            right, wrong = pathlib.Path(folder, "right.py"), pathlib.Path(folder, "wrong.py")
            right.write_text(RIGHT)
            head = RIGHT.splitlines()
            wrong.write_text("\n".join((*head, "labels = np.zeros((4, 4, 4), int)", *WRONG)))
            said = checked(str(right), str(wrong), str(PACKAGE / "__init__.py"))
            complaints = [line for line in said.splitlines() if ": error: " in line]
            places = {int(line.split(":")[1]) - len(head) - 2 for line in complaints if line.startswith(str(wrong))}
            self.assertEqual(places, set(range(len(WRONG))), said)
            self.assertEqual([line for line in complaints if not line.startswith(str(wrong))], [])


if __name__ == "__main__":
    unittest.main()
