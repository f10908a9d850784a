#!/usr/bin/python3
"""Makes docs/gallery.md anew, and the meshes of docs/guide.md that show metrics: runs the commands of these pages, and
puts their figures into them and their pictures into docs/images/gallery and docs/images/metrics.

    benchmarks/gallery.py                       # all, in three minutes
    benchmarks/gallery.py --only grains weave   # some of the meshes
    benchmarks/gallery.py --check               # changes nothing, but tells what would change, CPU time aside
    benchmarks/gallery.py --views FOLDER        # also puts the views there, for tools/site/build.py --views FOLDER
    benchmarks/gallery.py --volumes out         # writes the generated volumes into a folder, and does nothing else

Needs python3-numpy, and Debian's mricron-data for the brain.
"""
import argparse
import json
import math
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import zlib

import gallery_volumes
import quality

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Each with the folder of its pictures.
PAGES = {ROOT / "docs/gallery.md": ROOT / "docs/images/gallery", ROOT / "docs/guide.md": ROOT / "docs/images/metrics"}
COMMAND = re.compile(r"^    (cleft (?:mesh|render) (?:.*\\\n)*.*)", re.MULTILINE)
FIGURES = re.compile(r"<!-- figures of ([\w -]+) -->\n(?:.*\n)*?<!-- /figures -->\n")
COLUMNS = ("mesh", "voxels", "labels", "tetrahedra", "dihedral angles", "worst label", "CPU")


def commands(page):
    """The commands of the page: {mesh: [(subcommand, line), ...]}, in their order."""
    found = {}
    for match in COMMAND.finditer(page):
        line = re.sub(r"\\\n +", "", match[1])
        mesh = re.search(r"out/([\w-]+)\.vtu", line)[1]
        found.setdefault(mesh, []).append((line.split()[1], line))
    return found


def shell(line, cleft):
    # The command of this build, whatever the path has.
    line = re.sub(r"^cleft", shlex.quote(str(cleft)), line)
    done = subprocess.run(["bash", "-c", line], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{line}\n{done.stderr}")


def generated(work):
    """The names of the generated volumes that are read."""
    lines = " ".join(line for lines in work.values() for _, line in lines)
    return set(re.findall(r" out/([a-z]+)\d?\.nrrd", lines))


def is_here(line):
    """Are the files from outside of the repository there?"""
    return all(pathlib.Path(path).exists() for path in re.findall(r" (/usr/share/\S+)", line))


def make(mesh, lines, cleft):
    """Runs the commands of one mesh; answers the report."""
    for subcommand, line in lines:
        more = f" --check --threads 1 --json out/{mesh}.json" if subcommand == "mesh" else ""
        shell(f"{line} -q{more}", cleft)
    return json.loads(pathlib.Path(f"out/{mesh}.json").read_text())


def worst_label(mesh, report):
    """In percent: against the voxels, or the ball of a sphere whose distances are known."""
    if mesh not in gallery_volumes.SPHERES:
        return quality.worst_error(report, 1000) + " %"
    balls = [4 / 3 * math.pi * radius**3 for _, radius in gallery_volumes.SPHERES[mesh]]
    volumes = [row["mesh_volume"] for row in report["labels"] if row["label"] > 0]
    return "%+.2f %%" % max((100 * volume / ball - 100 for volume, ball in zip(volumes, balls)), key=abs)


def row(mesh, report):
    dims, shape, seconds = report["volume"]["dims"], report["quality"], report["cpu_seconds"]
    return (
        mesh,
        " x ".join(map(str, dims)),
        str(len(report["labels"])),
        "{:,}".format(report["mesh"]["tets"]),
        "%.1f to %.1f" % (shape["min_dihedral"], shape["max_dihedral"]),
        worst_label(mesh, report),
        "%.0f s" % seconds if seconds > 1 else "below 1 s",
    )


def with_figures(page, reports):
    """The page with the figures of these reports; those of other meshes stay."""

    def table(match):
        old = {line.split(" | ")[0][2:]: line for line in match[0].splitlines(keepends=True)}
        new = {mesh: quality.line(row(mesh, report)) for mesh, report in reports.items()}
        rows = [new.get(mesh) or old.get(mesh, "") for mesh in match[1].split(" and ")]
        text = quality.line(COLUMNS) + quality.line(["---"] * len(COLUMNS)) + "".join(rows)
        return f"<!-- figures of {match[1]} -->\n{text}<!-- /figures -->\n"

    return FIGURES.sub(table, page)


def without_times(page):
    return re.sub(r"\| [^|]* s \|$", "|", page, flags=re.MULTILINE)


def unpacked(picture):
    """The header and the rows of a PNG. Another version of zlib packs the same rows into other bytes."""
    data, at, parts = picture.read_bytes(), 8, {}
    while at < len(data):
        end = at + 8 + int.from_bytes(data[at : at + 4], "big")
        kind = data[at + 4 : at + 8]
        parts[kind] = parts.get(kind, b"") + data[at + 8 : end]
        at = end + 4
    return parts[b"IHDR"], zlib.decompress(parts[b"IDAT"])


def drawn_anew(work, kept):
    """The pictures of these meshes that are not those that are kept."""
    lines = " ".join(line for lines in work.values() for _, line in lines)
    pictures = [pathlib.Path(path) for path in re.findall(r"-o (out/\S+\.png)", lines)]
    return [
        p for p in pictures if p.exists() and (not (kept / p.name).exists() or unpacked(kept / p.name) != unpacked(p))
    ]


def differences(page, new_page, work, pictures):
    """What would change: lines of the page, and pictures."""
    lines = zip(without_times(page).splitlines(), without_times(new_page).splitlines())
    found = [f"the page has  {old}\nit would have {new}" for old, new in lines if old != new]
    return found + [f"the picture {picture.name} is another one" for picture in drawn_anew(work, pictures)]


def finish(arguments, file, work, reports):
    page, pictures = file.read_text(), PAGES[file]
    new_page = with_figures(page, reports)
    if arguments.check:
        found = differences(page, new_page, work, pictures)
        if found:
            sys.exit("\n".join([*found, "benchmarks/gallery.py makes the gallery anew"]))
        return
    file.write_text(new_page)
    pictures.mkdir(exist_ok=True)
    for picture in drawn_anew(work, pictures):
        shutil.copy(picture, pictures)
    if arguments.views:
        arguments.views.mkdir(parents=True, exist_ok=True)
        for view in pathlib.Path("out").glob("*.html"):
            shutil.copy(view, arguments.views)


def make_all(arguments):
    pathlib.Path("out").mkdir()
    pathlib.Path("tests").symlink_to(ROOT / "tests")
    every = {file: commands(file.read_text()) for file in PAGES}
    unknown = set(arguments.only) - {mesh for work in every.values() for mesh in work}
    if unknown:
        sys.exit(f"no page has the meshes {unknown}")
    for file, work in every.items():
        make_page(arguments, file, {mesh: work[mesh] for mesh in work if not arguments.only or mesh in arguments.only})


def make_page(arguments, file, work):
    gallery_volumes.write(pathlib.Path("out"), generated(work))
    reports = {}
    for mesh, lines in work.items():
        if all(is_here(line) for _, line in lines):
            reports[mesh] = make(mesh, lines, arguments.cleft)
            print(" | ".join(row(mesh, reports[mesh])), flush=True)
        else:
            print(f"{mesh} is left out: a file of it is not here", flush=True)
    finish(arguments, file, work, reports)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cleft", type=pathlib.Path, default=ROOT / "build/release/src/cli/cleft")
    parser.add_argument("--only", nargs="+", default=[], metavar="MESH")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--views", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--volumes", type=pathlib.Path, metavar="FOLDER")
    arguments = parser.parse_args()
    if arguments.volumes:
        arguments.volumes.mkdir(parents=True, exist_ok=True)
        return gallery_volumes.write(arguments.volumes)
    arguments.cleft = arguments.cleft.resolve()
    arguments.views = arguments.views and arguments.views.resolve()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        make_all(arguments)
        os.chdir(ROOT)


if __name__ == "__main__":
    main()
