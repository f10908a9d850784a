#!/usr/bin/python3
"""What each rule of snapping gives, with improving and without: the second table of docs/quality.md.

    benchmarks/snapping.py [--cleft build/release/src/cli/cleft] [-o docs/quality.md]

Without improving nothing is fitted either: the volumes in those rows are what cleaving leaves.
"""
import argparse
import pathlib
import tempfile

import quality
import volumes

VOLUMES = ("kissing spheres, distances", "four indicators", "Voronoi grains", "CIT168", "noise, 5 labels")
RULES = ("quality", "safe", "none")
LEFT_OUT = ("noise, 5 labels", "fast", "none")  # a million slivers to mend: minutes
COLUMNS = ("volume", "snap", "improve", "tetrahedra", "least angle", "greatest angle", "below 10, 15, 20",
           "volume error of labels above 1,000 / 100 voxels", "from true surface", "CPU s")


def cells_of(report, surface, spheres):
    q = report["quality"]
    return ["{:,}".format(report["mesh"]["tets"]), "%.1f" % q["min_dihedral"], "%.1f" % q["max_dihedral"],
            "%d, %d, %d" % (q["tets_below_10"], q["tets_below_15"], q["tets_below_20"]),
            "%s / %s %% (median %s)" % (quality.worst_error(report, 1000), quality.worst_error(report, 100),
                                        quality.median_error(report)),
            quality.distance_to_spheres(surface, spheres) if spheres else "", "%.1f" % report["cpu_seconds"]]


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
                    cells = cells_of(report, result, spheres) if report else [result]
                text += quality.line([name + (", size 2" if spheres else ""), rule, effort] + cells)
                print(text.splitlines()[-1], flush=True)
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cleft", default=quality.ROOT / "build/release/src/cli/cleft")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="a Markdown file with a line <!-- snapping -->")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        every = {**{name: (files, None) for name, files in volumes.kept().items()},
                 **volumes.write_generated(pathlib.Path(folder))}
        text = table(arguments.cleft, {name: every[name] for name in VOLUMES})
    if arguments.output:
        quality.write_into(arguments.output, "snapping", text)


if __name__ == "__main__":
    main()
