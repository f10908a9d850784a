#!/usr/bin/python3
"""Meshes every volume on every background and writes the table of docs/quality.md. The lattice has one size everywhere:
in volumes of more than 20,000 voxels it is given as many tetrahedra as the first background made.

    benchmarks/quality.py [--cleft build/release/src/cli/cleft] [--data FOLDER] [--only TEXT] [-o docs/quality.md]

Needs python3-numpy; Debian's mricron-data for the atlases. Each mesh is validated (--check).
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile

import numpy as np

import volumes

ROOT = pathlib.Path(__file__).resolve().parent.parent
LARGE = 20000  # voxels
COLUMNS = (
    "tetrahedra",
    "least angle",
    "greatest angle",
    "below 10, 15, 20",
    "radius ratio 95 %",
    "volume error of labels above 1,000 / 100 voxels",
    "pieces above 30 voxels lost",
    "from true surface",
    "CPU s",
    "estimate: tetrahedra, memory",
)


def mesh(cleft, files, options, folder):
    """The report of the command and its surface, or None and what it said."""
    report, surface = folder / "report.json", folder / "surface.ply"
    command = [
        cleft,
        "mesh",
        *files,
        "-o",
        surface,
        "--json",
        report,
        "--quiet",
        "--check",
        "--threads",
        "1",
        *map(str, options),
    ]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        return None, (done.stderr.strip() or "ended by %d" % done.returncode).splitlines()[-1]
    found = json.loads(report.read_text())
    command = [cleft, "mesh", *files, "--estimate", "--json", report, "--quiet", *map(str, options)]
    subprocess.run(command, check=True)
    found["estimate"] = json.loads(report.read_text())["estimate"]
    return found, surface


def options_of(background, first):
    """`first`: the report of the first background. The lattice is as fine as the field's least everywhere: too much for
    all but small volumes."""
    is_large = first and sum(row["voxels"] for row in first["labels"]) > LARGE
    like_the_first = ["--tets", first["mesh"]["tets"]] if background == "lattice" and is_large else []
    return ["--background", background, *like_the_first]


def worst_error(report, least_voxels):
    errors = [row["difference_percent"] for row in report["labels"] if row["voxels"] > least_voxels]
    return "%+.2f" % max(errors, key=abs) if errors else "-"


def median_error(report):
    errors = [abs(row["difference_percent"]) for row in report["labels"] if row["voxels"] > 100]
    return "%.2f" % statistics.median(errors) if errors else "-"


def vertices(ply):
    """The vertices of a binary PLY file whose vertices are x, y, z as doubles."""
    data = ply.read_bytes()
    header, _, body = data.partition(b"end_header\n")
    count = int(header.split(b"element vertex ")[1].split()[0])
    return np.frombuffer(body, "<f8", 3 * count).reshape(count, 3)


def distance_to_spheres(surface, spheres):
    """Mean and greatest distance, in voxels, of interface vertices from the nearest sphere."""
    points = vertices(surface)
    inner = ((points > 1e-6) & (points < 64 - 1e-6)).all(1)
    points = points[inner]
    away = [np.abs(np.linalg.norm(points - centre, axis=1) - radius) for centre, radius in spheres]
    away = np.min(away, axis=0)
    return "%.3f, %.2f" % (away.mean(), away.max())


def angles(report):
    """Four cells: tetrahedra, least and greatest angle, tetrahedra below 10, 15 and 20 degrees."""
    q = report["quality"]
    return [
        "{:,}".format(report["mesh"]["tets"]),
        "%.1f" % q["min_dihedral"],
        "%.1f" % q["max_dihedral"],
        "%d, %d, %d" % (q["tets_below_10"], q["tets_below_15"], q["tets_below_20"]),
    ]


def volume_errors(report):
    return "%s / %s %% (median %s)" % (worst_error(report, 1000), worst_error(report, 100), median_error(report))


def estimate(report):
    """The estimated number over the true one, and the estimated memory over the peak when the mesh was there."""
    peak = next(stage["peak_bytes"] for stage in report["stages"] if stage["name"] == "result_check")
    rough = "roughly " if report["estimate"]["is_rough"] else ""
    return "%s%+.0f %%, %.2f" % (
        rough,
        100 * report["estimate"]["tets"] / report["mesh"]["tets"] - 100,
        report["estimate"]["peak_bytes"] / peak,
    )


def row(report, surface, spheres):
    lost = sum(r["large_components_lost"] for r in report["labels"])
    return [
        *angles(report),
        "%.2f" % report["quality"]["radius_ratio_95"],
        volume_errors(report),
        str(lost),
        distance_to_spheres(surface, spheres) if spheres else "",
        "%.1f" % report["cpu_seconds"],
        estimate(report),
    ]


def line(cells):
    return "| " + " | ".join(cells) + " |\n"


def table(cleft, work, backgrounds):
    text = line(("volume", "background") + COLUMNS) + line(["---"] * (2 + len(COLUMNS)))
    for name, (files, spheres) in work.items():
        first = None
        for background in backgrounds:
            with tempfile.TemporaryDirectory() as folder:
                report, result = mesh(cleft, files, options_of(background, first), pathlib.Path(folder))
                first = first or report
                cells = row(report, result, spheres) if report else [result] + [""] * (len(COLUMNS) - 1)
            text += line([name, background] + cells)
            print(text.splitlines()[-1], flush=True)
    return text


def write_into(page, mark, text):
    """Replaces what is between the two lines <!-- mark --> of a Markdown page."""
    mark = "<!-- %s -->\n" % mark
    before, _, rest = page.read_text().partition(mark)
    page.write_text(before + mark + text + mark + rest.partition(mark)[2])


def run_table(description, mark, make_table, add_arguments=lambda parser: None):
    """The command of a table: make_table(arguments, the generated volumes) makes its text, which goes into a page if
    one is given."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cleft", default=ROOT / "build/release/src/cli/cleft")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="a Markdown file with a line <!-- %s -->" % mark)
    add_arguments(parser)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        text = make_table(arguments, volumes.write_generated(pathlib.Path(folder)))
    if arguments.output:
        write_into(arguments.output, mark, text)


def add_arguments(parser):
    parser.add_argument("--data", help="a folder of further volumes")
    parser.add_argument("--only", default="", help="volumes whose name contains this text")
    parser.add_argument("--backgrounds", default="particles,octree,lattice")


def make_table(arguments, generated):
    work = {**volumes.kept(), **generated, **(volumes.more(arguments.data) if arguments.data else {})}
    work = {name: found for name, found in work.items() if arguments.only in name}
    return table(arguments.cleft, work, arguments.backgrounds.split(","))


if __name__ == "__main__":
    run_table(__doc__, "table", make_table, add_arguments)
