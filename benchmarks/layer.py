#!/usr/bin/python3
"""How many vertices tanh(50 (z - 0.5)) takes in the unit cube, for an error of 0.001 in the L2 norm of its linear
interpolation: with sizes, and with a metric. A table of docs/quality.md.

    benchmarks/layer.py [--cleft build/release/src/cli/cleft] [-o docs/quality.md]

Needs python3-numpy.
"""
import itertools
import json
import pathlib
import subprocess
import tempfile

import numpy as np

import quality
import volumes

STEEP, WANTED, VOXELS = 50, 1e-3, 1001
COARSEST = 0.25  # edges are no longer, in any direction
COLUMNS = ("lengths", "vertices", "tetrahedra", "L2 error", "shortest and longest wanted edge", "CPU s")


def function(z):
    return np.tanh(STEEP * (z - 0.5))


def bounded(sizes, gradation):
    """No size is above the coarsest, or grows faster than `gradation` along z."""
    grown = gradation * np.arange(VOXELS) / VOXELS
    for way in (1, -1):
        sizes = (np.minimum.accumulate(sizes[::way] - grown) + grown)[::way]
    return np.minimum(sizes, COARSEST)


def curvature():
    z = (np.arange(VOXELS) + 0.5) / VOXELS
    return np.abs(2 * STEEP**2 * function(z) * (1 - function(z) ** 2)) + 1e-9


def round_field(factor):
    """Of all sizes with the same error, the integral of h^-3 is least where h is the -1/4th power of the curvature."""
    sizes = bounded(factor * curvature() ** -0.25, 0.3)
    return np.repeat(sizes, 9).reshape(VOXELS, 3, 3), sizes


def flat_field(factor):
    """Across the layer alone, the integral of 1/h is least where h is the -2/5th power of the curvature."""
    sizes = bounded(factor * curvature() ** -0.4, 0.3)
    tensors = np.zeros((VOXELS, 3, 3, 6))
    tensors[..., 0] = tensors[..., 3] = COARSEST**-2
    tensors[..., 5] = sizes[:, None, None] ** -2
    return tensors, sizes


def write_tensors(path, tensors, spacing):
    directions = "none (%r,0,0) (0,%r,0) (0,0,%r)" % spacing
    path.write_bytes(
        (
            "NRRD0005\ntype: double\ndimension: 4\nspace: left-posterior-superior\nsizes: 6 3 3 %d\n"
            "space directions: %s\nkinds: 3D-symmetric-matrix domain domain domain\nendian: little\nencoding: raw\n"
            "space origin: (%r,%r,%r)\n\n" % (VOXELS, directions, *(s / 2 for s in spacing))
        ).encode()
        + tensors.tobytes()
    )


def read_numbers(path, columns):
    """A table of TetGen without its first column."""
    head, _, body = path.read_text().partition("\n")
    return np.fromstring(body, sep=" ", count=int(head.split()[0]) * columns).reshape(-1, columns)[:, 1:]


def interpolation_error(stem):
    points = read_numbers(stem.with_suffix(".node"), 4)
    tets = read_numbers(stem.with_suffix(".ele"), 6)[:, :4].astype(int) - 1
    x = points[tets]
    volume = np.abs(np.linalg.det(x[:, 1:] - x[:, :1])) / 6
    ends, values = x[:, :, 2], function(x[:, :, 2])
    # Points on a regular lattice in each tetrahedron.
    places = [(np.array(c) + 0.25) / 5 for c in itertools.product(range(5), repeat=4) if sum(c) == 4]
    square = sum(volume @ (values @ place - function(ends @ place)) ** 2 for place in places) / len(places)
    return np.sqrt(square / volume.sum())


def mesh(cleft, folder, option, field):
    report, stem = folder / "report.json", folder / "mesh"
    command = [cleft, "mesh", folder / "cube.nrrd", option, field, "-o", f"{stem}.ele", "--max-tets", 0, "--quiet"]
    subprocess.run([*map(str, command), "--threads", "1", "--json", report], check=True)
    return json.loads(report.read_text()), interpolation_error(stem)


def row(cleft, folder, name, make_field):
    """The error falls with the square of the lengths: a few steps find those that have it."""
    spacing = (1 / 3, 1 / 3, 1 / VOXELS)
    factor, error = 0.05, 0
    while abs(error / WANTED - 1) > 0.03:
        factor *= (WANTED / error) ** 0.5 if error else 1
        values, sizes = make_field(factor)
        field = folder / "field.nrrd"
        if values.ndim == 4:
            write_tensors(field, values, spacing)
        else:
            volumes.write_nrrd(field, values, spacing)
        report, error = mesh(cleft, folder, "--metric" if values.ndim == 4 else "--sizing", field)
        print(name, factor, report["mesh"]["points"], error, flush=True)
    return [
        name,
        "{:,}".format(report["mesh"]["points"]),
        "{:,}".format(report["mesh"]["tets"]),
        "%.2e" % error,
        "%.4f, %.3f" % (sizes.min(), COARSEST),
        "%.1f" % report["cpu_seconds"],
    ]


def make_table(arguments, _):
    text = quality.line(COLUMNS) + quality.line(["---"] * len(COLUMNS))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        cube = np.ones((VOXELS, 3, 3), np.uint8)
        volumes.write_nrrd(folder / "cube.nrrd", cube, (1 / 3, 1 / 3, 1 / VOXELS))
        for name, make_field in (("a metric", flat_field), ("sizes", round_field)):
            text += quality.line(row(arguments.cleft, folder, name, make_field))
            print(text.splitlines()[-1], flush=True)
    return text


if __name__ == "__main__":
    quality.run_table(__doc__, "layer", make_table)
