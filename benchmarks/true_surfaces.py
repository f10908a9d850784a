#!/usr/bin/python3
"""How far interfaces are from the surfaces that the voxels are of, at points all over their triangles. A table of
docs/quality.md.

    benchmarks/true_surfaces.py [--cleft build/release/src/cli/cleft] [-o docs/quality.md]

Needs python3-numpy.
"""
import pathlib
import tempfile

import numpy as np

import interfaces
import quality
import volumes

COLUMNS = ("volume", "input", "tetrahedra", "mean", "99 %", "greatest", "allowed")
ALLOWED = {"distances": 0.5, "labels": 0.75}


def torus_distances():
    """Signed distances of the outside and the inside of a torus, positive inside."""
    away = from_torus(volumes.centres((48, 48, 48)))
    return [away, -away]


def from_torus(x):
    x = x - 24
    return np.hypot(np.hypot(x[..., 0], x[..., 1]) - 13, x[..., 2]) - 5


def from_spheres(spheres):
    def away(x):
        return np.min([np.abs(np.linalg.norm(x - centre, axis=-1) - radius) for centre, radius in spheres], axis=0)

    return away


SHAPES = {
    "kissing spheres": (volumes.sphere_distances((64, 64, 64), volumes.KISSING), volumes.KISSING),
    "unequal spheres": (volumes.sphere_distances((64, 64, 64), volumes.UNEQUAL), volumes.UNEQUAL),
    "torus": (torus_distances(), None),
}


def row(cleft, folder, name, kind, fields, spheres):
    written = [volumes.largest(fields)] if kind == "labels" else fields
    files = [folder / f"{number}.nrrd" for number in range(len(written))]
    for file, values in zip(files, written):
        volumes.write_nrrd(file, values, (1, 1, 1))
    report, surface = quality.mesh(cleft, files, [], folder)
    if not report:
        raise SystemExit(surface)
    x = interfaces.samples(interfaces.read_triangles(surface))
    away = from_spheres(spheres)(x) if spheres else np.abs(from_torus(x))
    return [
        name,
        kind,
        "{:,}".format(report["mesh"]["tets"]),
        *("%.3f" % value for value in (away.mean(), np.percentile(away, 99), away.max())),
        str(ALLOWED[kind]),
    ]


def make_table(arguments, _):
    text = quality.line(COLUMNS) + quality.line(["---"] * len(COLUMNS))
    for name, (fields, spheres) in SHAPES.items():
        for kind in ALLOWED:
            with tempfile.TemporaryDirectory() as folder:
                text += quality.line(row(arguments.cleft, pathlib.Path(folder), name, kind, fields, spheres))
            print(text.splitlines()[-1], flush=True)
    return text


if __name__ == "__main__":
    quality.run_table(__doc__, "true surfaces", make_table)
