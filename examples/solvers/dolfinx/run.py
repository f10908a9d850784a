"""Meshes a ball in a box and has poisson.py solve on the mesh, both on several processes, with two lengths of edges.

Fails if the volumes of the labels are not those of the mesh, or if the error does not fall with the square of the edge
length.

    python3 run.py [mpirun -n 4]        with `cleft-mpi` in the PATH
"""
import os
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy

VOXELS = 56  # along each side of the box from (-1, -1, -1) to (1, 1, 1)
BALL_RADIUS = 0.55
MPIRUN = sys.argv[1:] or ["mpirun", "-n", "4"]


def write_volume(path):
    """A label map: 2 in the ball, 1 around it."""
    x = (numpy.arange(VOXELS) + 0.5) * 2 / VOXELS - 1
    inside = x**2 + x[:, None] ** 2 + x[:, None, None] ** 2 < BALL_RADIUS**2
    with h5py.File(path, "w") as file:
        labels = file.create_dataset("labels", data=numpy.where(inside, 2, 1).astype(numpy.uint8))
        labels.attrs["spacing"] = [2 / VOXELS] * 3
        labels.attrs["origin"] = [x[0]] * 3


def mesh_volumes(path):
    """The volume of each label, by the arrays of the file."""
    with h5py.File(path) as file:
        grid = file["VTKHDF"]
        corners = grid["Points"][:][grid["Connectivity"][:].reshape(-1, 4)]
        edges = corners[:, 1:] - corners[:, :1]
        return numpy.bincount(grid["CellData/material"][:], numpy.linalg.det(edges) / 6)[1:]


def error_of_size(folder, size):
    mesh = folder / f"{size}.vtkhdf"
    command = [os.environ.get("CLEFT_MPI", "cleft-mpi"), "mesh", folder / "ball.h5", "-o", mesh, "--size", str(size)]
    subprocess.run([*MPIRUN, *command, "--quiet"], check=True)
    solver = [sys.executable, pathlib.Path(__file__).with_name("poisson.py"), mesh]
    printed = subprocess.run([*MPIRUN, *solver], check=True, stdout=subprocess.PIPE, text=True).stdout
    *volumes, error = map(float, printed.split())
    print(f"edges of {size}: error {error:.6f}, volumes", *volumes)
    assert numpy.allclose(volumes, mesh_volumes(mesh), rtol=0, atol=1e-12)
    return error


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_volume(folder / "ball.h5")
        coarse, fine = (error_of_size(folder, size) for size in (0.24, 0.12))
        print(f"half the edges, and the error falls to {fine / coarse:.2f}")
        sys.exit(not (fine < 0.3 * coarse and fine < 0.005))


main()
