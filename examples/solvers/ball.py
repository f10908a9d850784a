"""The volume of the solver examples: an eighth of a ball of two materials, as three indicator functions on a grid.

Label 2 is the core (radius 0.5), label 1 the shell around it (radius 1), label 0 the rest of the box. The sides of the
box through the centre are planes of symmetry.
"""
import array
import os
import subprocess

CORE_RADIUS, RADIUS = 0.5, 1.0
VOXELS, SPACING = 24, 0.05


def indicators(r):
    """How far inside each material a point at distance r from the centre is."""
    return r - RADIUS, min(RADIUS - r, r - CORE_RADIUS), CORE_RADIUS - r


def write_volume(folder):
    """Three files of raw 32-bit numbers, x fastest; the corner of the box is the centre of the ball."""
    places = [(i + 0.5) * SPACING for i in range(VOXELS)]
    values = [indicators((x * x + y * y + z * z) ** 0.5) for z in places for y in places for x in places]
    paths = []
    for material, column in enumerate(zip(*values)):
        paths.append(os.path.join(folder, f"material{material}.raw"))
        with open(paths[-1], "wb") as file:
            array.array("f", column).tofile(file)
    return paths


def make_mesh(folder, output, size):
    """Meshes core and shell with the command; without label 0, so that the ball has a free surface."""
    subprocess.run(
        [
            os.environ.get("CLEFT", "cleft"),
            "mesh",
            *write_volume(folder),
            "--type",
            "float32",
            "--dims",
            *[str(VOXELS)] * 3,
            "--spacing",
            *[str(SPACING)] * 3,
            "--size",
            str(size),
            "--strip",
            "0",
            "--quiet",
            "--output",
            output,
        ],
        check=True,
    )
