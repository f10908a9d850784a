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
STAGES = (
    "volume",
    "sizing",
    "background.seed",
    "background.relax",
    "background.delaunay",
    "background.repair",
    "cleaving",
    "improving",
    "fitting",
    "finish",
)


def run(cleft, files, options, threads=1):
    """The report of one run of the command."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        command = [cleft, "mesh", *files, "-o", pathlib.Path(folder) / "surface.ply", "--quiet", "--json", report]
        subprocess.run([*map(str, command), "--threads", str(threads), *map(str, options)], check=True)
        return json.loads(report.read_text())


def measure(cleft, volume, repeat):
    """The fastest of the repeated runs, by stage."""
    turns = [[run(cleft, [volume], ["--delaunay", engine]) for engine in ("cleft", "tetgen")] for _ in range(repeat)]
    reports = [own for own, _ in turns]
    best = {stage: min(r["metrics"].get(stage + ".cpu_seconds", 0) for r in reports) for stage in STAGES}
    report = reports[0]
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
    for stage in STAGES:
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
