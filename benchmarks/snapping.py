#!/usr/bin/python3
"""What each rule of snapping gives, with improving and without: the second table of docs/quality.md.

    benchmarks/snapping.py [--cleft build/release/src/cli/cleft] [-o docs/quality.md]

Without improving nothing is fitted either: the volumes in those rows are what cleaving leaves.
"""
import pathlib
import tempfile

import quality
import volumes

VOLUMES = ("kissing spheres, distances", "four indicators", "Voronoi grains", "CIT168", "noise, 5 labels")
RULES = ("quality", "safe", "none")
LEFT_OUT = ("noise, 5 labels", "fast", "none")  # a million slivers to mend: minutes
COLUMNS = (
    "volume",
    "snap",
    "improve",
    "tetrahedra",
    "least angle",
    "greatest angle",
    "below 10, 15, 20",
    "volume error of labels above 1,000 / 100 voxels",
    "from true surface",
    "CPU s",
)


def row(report, surface, spheres):
    return [
        *quality.angles(report),
        quality.volume_errors(report),
        quality.distance_to_spheres(surface, spheres) if spheres else "",
        "%.1f" % report["cpu_seconds"],
    ]


def table(cleft, work):
    text = quality.line(COLUMNS) + quality.line(["---"] * len(COLUMNS))
    for name, (files, spheres) in work.items():
        for effort in ("off", "fast"):
            for rule in RULES:
                if (name, effort, rule) == LEFT_OUT:
                    continue
                with tempfile.TemporaryDirectory() as folder:
                    options = ["--snap", rule, "--improve", effort] + (["--size", 2] if spheres else [])
                    report, result = quality.mesh(cleft, files, options, pathlib.Path(folder))
                    cells = row(report, result, spheres) if report else [result]
                text += quality.line([name + (", size 2" if spheres else ""), rule, effort] + cells)
                print(text.splitlines()[-1], flush=True)
    return text


def make_table(arguments, generated):
    every = {**volumes.kept(), **generated}
    return table(arguments.cleft, {name: every[name] for name in VOLUMES})


if __name__ == "__main__":
    quality.run_table(__doc__, "snapping", make_table)
