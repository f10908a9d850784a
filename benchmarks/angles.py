#!/usr/bin/python3
"""What a wanted least angle costs: the table of goals in docs/quality.md.

    benchmarks/angles.py [--cleft build/release/src/cli/cleft] [--only NAME] [-o docs/quality.md]
"""
import pathlib
import tempfile

import quality
import volumes

VOLUMES = (
    "mickey",
    "CIT168",
    "AAL",
    "JHU, 1 mm",
    "four indicators",
    "Voronoi grains",
    "one-voxel sheets",
    "one-voxel rods",
    "checkerboard",
)
BACKGROUNDS = ("particles", "octree", "lattice")
# The options of a goal, and its name in the table.
GOALS = (
    (["--min-angle", 20], "20"),
    (["--min-angle", 25], "25"),
    (["--min-angle", 30], "30"),
    (["--improve", "best"], "best, 32"),
)
COLUMNS = (
    "volume",
    "background",
    "goal",
    "tetrahedra",
    "least angle",
    "greatest angle",
    "missed by",
    "greatest radius ratio",
    "volume error of labels above 1,000 / 100 voxels",
    "improving, CPU s",
    "of all",
)


def row(report):
    metrics = report["metrics"]
    improving = metrics["improving.cpu_seconds"]
    return [
        *quality.angles(report)[:3],
        "{:,}".format(int(metrics["improving.tets_missed"])),
        "%.1f" % report["quality"]["radius_ratio_max"],
        quality.volume_errors(report),
        "%.2f" % improving,
        "%.0f %%" % (100 * improving / report["cpu_seconds"]),
    ]


def table(cleft, work):
    text = quality.line(COLUMNS) + quality.line(["---"] * len(COLUMNS))
    for name, (files, _) in work.items():
        first = None
        for background in BACKGROUNDS:
            for options, goal in GOALS:
                with tempfile.TemporaryDirectory() as folder:
                    every = quality.options_of(background, first) + options
                    report, result = quality.mesh(cleft, files, every, pathlib.Path(folder))
                    first = first or report
                    cells = row(report) if report else [result]
                text += quality.line([name, background, goal] + cells)
                print(text.splitlines()[-1], flush=True)
    return text


def add_arguments(parser):
    parser.add_argument("--data", help="a folder of further volumes")
    parser.add_argument("--only", default="", help="volumes whose name contains this text")


def make_table(arguments, generated):
    every = {**volumes.kept(), **generated, **(volumes.more(arguments.data) if arguments.data else {})}
    return table(arguments.cleft, {name: every[name] for name in VOLUMES if name in every and arguments.only in name})


if __name__ == "__main__":
    quality.run_table(__doc__, "angles", make_table, add_arguments)
