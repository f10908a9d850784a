#!/usr/bin/python3
"""Atlases as scans with thick slices: tetrahedra at several anisotropies, and how far their interfaces and volumes are
from the same atlas in its fine voxels. A table of docs/quality.md.

    benchmarks/thick.py [--cleft build/release/src/cli/cleft] [--only TEXT] [-o docs/quality.md]

Needs python3-numpy and python3-scipy; Debian's mricron-data for AAL.
"""
import json
import pathlib
import subprocess
import tempfile

import numpy as np
from scipy.spatial import cKDTree

import interfaces
import quality
import volumes

# A slice stands for so many of the atlas. The voxels get those of a scan: 0.3 x 0.3 in the slice.
ATLASES = {
    "CIT168": (volumes.DATA / "CIT168.nrrd", 5),
    "ellipsoids": (None, 16),
    "AAL": (volumes.ATLASES / "aal.nii.gz", 5),
}
IN_SLICE = 0.3
RATIOS = (1, 4, 8)
COLUMNS = (
    "shape",
    "voxels",
    "anisotropy",
    "tetrahedra",
    "least angle in the metric",
    "volumes: mean, worst",
    "from the fine interfaces: mean, 99 %",
    "fine interfaces from it: mean, 99 %",
    "lost or broken",
    "CPU s",
)


def ellipsoids():
    """Three smooth bodies, one within another."""
    x = volumes.centres((160, 128, 128)) - (64, 64, 80)
    labels = np.zeros(x.shape[:-1], np.uint8)
    for label, middle, radii in ((1, (0, 0, 0), (52, 44, 66)), (2, (-12, 6, 10), (24, 20, 34)), (3, (24, -8, -20), 14)):
        labels[(((x - middle) / radii) ** 2).sum(-1) < 1] = label
    return labels


def read(path, thick):
    """Labels whose slices are a multiple of the thick ones."""
    labels = ellipsoids() if path is None else volumes.read_labels(path)[0]
    numbers = np.unique(labels, return_inverse=True)[1].reshape(labels.shape).astype(np.uint8)
    return numbers[: len(numbers) // thick * thick]


def fine_interfaces(labels):
    """The middles of all voxel faces between two labels."""
    found = []
    for axis in range(3):
        first, second = np.moveaxis(labels, axis, 0)[:-1], np.moveaxis(labels, axis, 0)[1:]
        at = np.argwhere(first != second) + 0.5
        at[:, 0] += 0.5
        found.append(to_xyz(at, axis))
    return np.vstack(found) * IN_SLICE


def to_xyz(at, axis):
    """Places in the order of an array whose axis `axis` was brought to the front."""
    order = [axis] + [other for other in range(3) if other != axis]
    places = np.empty_like(at)
    places[:, order] = at
    return places[:, ::-1]


def volume_errors(labels, report):
    """Of labels of more than 1,000 fine voxels, in percent of the volume of those."""
    counts = np.bincount(labels.ravel())
    errors = [
        100 * (row["mesh_volume"] / (counts[row["label"]] * IN_SLICE**3) - 1)
        for row in report["labels"]
        if counts[row["label"]] > 1000
    ]
    return "%.2f %%, %+.2f %%" % (np.abs(errors).mean(), max(errors, key=abs))


def distances(places, tree, weights):
    """The mean, and below which 99 % of the weights are."""
    away = tree.query(places)[0] / IN_SLICE
    order = np.argsort(away)
    shares = np.cumsum(weights[order]) / weights.sum()
    return "%.2f, %.2f" % (away @ weights / weights.sum(), away[order][np.searchsorted(shares, 0.99)])


class Shape:
    """An atlas in fine voxels, and as a file of thick slices."""

    def __init__(self, name, folder):
        path, thick = ATLASES[name]
        self.name, self.fine = name, read(path, thick)
        self.spacing = (IN_SLICE, IN_SLICE, thick * IN_SLICE)
        self.file = folder / "thick.nrrd"
        slices = self.fine[thick // 2 :: thick]
        self.voxels = " x ".join(map(str, slices.shape[::-1])) + ", %g x %g x %g" % self.spacing
        volumes.write_nrrd(self.file, slices, self.spacing)
        self.places = fine_interfaces(self.fine)
        self.tree = cKDTree(self.places)

    def row(self, cleft, ratio, folder):
        report_file, surface = folder / "report.json", folder / "surface.ply"
        command = [cleft, "mesh", self.file, "-o", surface, "--json", report_file, "--anisotropy", ratio]
        command += ["--quiet", "--check", "--threads", "1"]
        subprocess.run([*map(str, command)], check=True)
        report = json.loads(report_file.read_text())
        triangles = interfaces.read_triangles(surface)
        # As many points on each triangle as its area asks for would need more of them than this.
        found = interfaces.samples(triangles, 15 if len(triangles) > 100000 else 66)
        bad = sum(row["large_components_lost"] + row["large_components_broken"] for row in report["labels"])
        angle = report["metrics"]["improving.min_angle_after"]
        return [
            self.name,
            self.voxels,
            str(ratio),
            "{:,}".format(report["mesh"]["tets"]),
            "%.1f" % angle,
            volume_errors(self.fine, report),
            distances(found, self.tree, np.repeat(interfaces.areas(triangles), len(found) // len(triangles))),
            distances(self.places, cKDTree(found), np.ones(len(self.places))),
            str(bad),
            "%.0f" % report["cpu_seconds"],
        ]


def make_table(arguments, _):
    text = quality.line(COLUMNS) + quality.line(["---"] * len(COLUMNS))
    for name in (name for name in ATLASES if arguments.only in name):
        with tempfile.TemporaryDirectory() as folder:
            shape = Shape(name, pathlib.Path(folder))
            for ratio in RATIOS:
                text += quality.line(shape.row(arguments.cleft, ratio, pathlib.Path(folder)))
                print(text.splitlines()[-1], flush=True)
    return text


def add_arguments(parser):
    parser.add_argument("--only", default="", help="shapes whose name contains this text")


if __name__ == "__main__":
    quality.run_table(__doc__, "thick", make_table, add_arguments)
