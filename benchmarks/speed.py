#!/usr/bin/python3
"""CPU time of the stages of one run, and as multiples of TetGen's Delaunay tetrahedralization of the same points, which
says what the machine is worth at the moment. Runs with Cleft's own engine and with TetGen take turns.

    benchmarks/speed.py VOLUME... [--cleft build/release/src/cli/cleft] [--repeat 3]
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def run(cleft, files, options, threads=1):
    """The report of one run of the command."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        command = [cleft, "mesh", *files, "-o", pathlib.Path(folder) / "surface.ply", "--quiet", "--json", report]
        subprocess.run([*map(str, command), "--threads", str(threads), *map(str, options)], check=True)
        return json.loads(report.read_text())


def stages_of(report):
    """The names of all stages between the labels in memory and the mesh in memory, in their order. What the report has,
    so that a stage that is added later is not forgotten."""
    return [
        stage["name"]
        for stage in report["stages"]
        if stage["name"] == "volume" or stage["part_of"] in ("mesh", "background")
    ]


def without_parents(names):
    """Those that have no steps among the names: their times add up to that of the run."""
    return [name for name in names if not any(other.startswith(name + ".") for other in names)]


def measure(cleft, volume, repeat):
    """The fastest of the repeated runs, by stage."""
    turns = [[run(cleft, [volume], ["--delaunay", engine]) for engine in ("cleft", "tetgen")] for _ in range(repeat)]
    reports = [own for own, _ in turns]
    report = reports[0]
    stages = without_parents(stages_of(report))
    best = {stage: min(r["metrics"].get(stage + ".cpu_seconds", 0) for r in reports) for stage in stages}
    total = sum(best.values())
    tetgen = min(other["metrics"]["background.delaunay.cpu_seconds"] for _, other in turns)
    print(
        "%s: %d tetrahedra, %.1f CPU s, %.0f tetrahedra a CPU second, peak %.0f bytes a tetrahedron"
        % (
            volume,
            report["mesh"]["tets"],
            total,
            report["mesh"]["tets"] / total,
            report["peak_bytes"] / report["mesh"]["tets"],
        )
    )
    for stage in stages:
        print("  %-20s %7.2f s  %5.2f TetGens" % (stage, best[stage], best[stage] / tetgen if tetgen else 0))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("volumes", nargs="+")
    parser.add_argument("--cleft", default=ROOT / "build/release/src/cli/cleft")
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    for volume in arguments.volumes:
        measure(arguments.cleft, volume, arguments.repeat)


if __name__ == "__main__":
    main()
