#!/usr/bin/python3
"""Two kissing spheres in 64^3 voxels at several sizes: how many tetrahedra an accuracy takes. The third table of
docs/quality.md.

    benchmarks/accuracy.py [--cleft build/release/src/cli/cleft] [-o docs/quality.md]
"""
import math
import pathlib
import tempfile

import quality
import volumes

# Sizes at interfaces; the graded backgrounds are coarser away from them.
SIZES = (6, 4, 3, 2, 1.5)
COLUMNS = (
    "input",
    "edge length",
    "tetrahedra",
    "volume error",
    "from true surface: mean, greatest",
    "least angle",
    "CPU s",
)
INPUTS = {"labels": "kissing spheres, labels", "distances": "kissing spheres, distances"}


def volume_errors(report):
    exact = [4 / 3 * math.pi * radius**3 for _, radius in volumes.KISSING]
    return ["%+.2f %%" % (100 * (row["mesh_volume"] / v - 1)) for row, v in zip(report["labels"][1:], exact)]


def table(cleft, written):
    text = quality.line(COLUMNS) + quality.line(["---"] * len(COLUMNS))
    for kind, name in INPUTS.items():
        files, spheres = written[name]
        for size in SIZES:
            with tempfile.TemporaryDirectory() as folder:
                options = ["--size-min", size, "--interface-size", size, "--size-max", 16]
                report, surface = quality.mesh(cleft, files, options, pathlib.Path(folder))
                if not report:
                    raise SystemExit(surface)
                text += quality.line(
                    [
                        kind,
                        str(size),
                        "{:,}".format(report["mesh"]["tets"]),
                        ", ".join(volume_errors(report)),
                        quality.distance_to_spheres(surface, spheres),
                        "%.1f" % report["quality"]["min_dihedral"],
                        "%.1f" % report["cpu_seconds"],
                    ]
                )
            print(text.splitlines()[-1], flush=True)
    return text


if __name__ == "__main__":
    quality.run_table(__doc__, "accuracy", lambda arguments, generated: table(arguments.cleft, generated))
