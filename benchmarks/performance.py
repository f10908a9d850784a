#!/usr/bin/python3
"""Measures Cleft side by side with what Debian ships: CGAL's Mesh_3 on the same labels, and TetGen's Delaunay
tetrahedra of the same points. Then it writes the tables and plots of docs/performance.md.

    benchmarks/performance.py [VOLUME...] [--quick] [-o docs/performance.md]

The programs take turns, and the least figure of the repeated turns counts. VOLUME is a file of labels of NRRD or NIfTI;
without one, CIT168 and the AAL atlas of Debian's mricron-data are measured. benchmarks/performance.sh installs and
builds what this needs.
"""
import argparse
import json
import os
import pathlib
import platform
import sys
import tempfile
import time

import numpy as np

import performance_page
import programs
import volumes

BUILD = pathlib.Path(__file__).resolve().parent.parent / "build" / "benchmarks"
BACKGROUNDS = ("particles", "octree", "lattice")
LEAST_SECONDS = 40  # of the turns of one volume: what disturbs for seconds is then not in all
SIDE = 96  # of a cube of grains, in world units


def say(*words):
    print(*words, file=sys.stderr, flush=True)


class Machine:
    """The programs to compare, and the threads to give them."""

    def __init__(self, arguments):
        self.cleft, self.cgal = arguments.cleft, arguments.cgal
        self.threads = arguments.threads
        self.has_cgal = pathlib.Path(self.cgal).exists()
        if not self.has_cgal:
            say("CGAL is left out: there is no %s" % self.cgal)

    def turn(self, case, thread_counts):
        """Every program once: {"NAME, THREADS": figures}."""
        found = {}
        for threads in thread_counts:
            for background in BACKGROUNDS:
                run = programs.run_cleft(self.cleft, case, background, threads)
                found["%s, %d" % (background, threads)] = run
            if case.is_real:
                found["%s, %d" % (programs.INDEPENDENT, threads)] = programs.run_independent(threads)
            if case.facets:
                names = (programs.REFINE, programs.OPTIMISE)
                runs = programs.run_cgal(self.cgal, case, case.facets, threads)
                found.update({"%s, %d" % (name, threads): run for name, run in zip(names, runs)})
        found["particles, TetGen, 1"] = programs.run_cleft(self.cleft, case, "particles", 1, "tetgen")
        for name, goals in programs.FEWER_GOALS.items() if case.is_real else ():
            for background in BACKGROUNDS:
                run = programs.run_cleft(self.cleft, case, background, 1, goals=goals)
                found["%s %s, 1" % (background, name)] = run
        return found

    def repeated(self, case, thread_counts, repeat):
        """The least of so many turns, and of more where they are short."""
        turns, begin = [], time.monotonic()
        while len(turns) < repeat or (repeat > 1 and time.monotonic() - begin < LEAST_SECONDS):
            say("%s: turn %d" % (case.name, len(turns) + 1))
            turns.append(self.turn(case, thread_counts))
        return programs.least(turns)

    def particles(self, case):
        """The number of tetrahedra that the others are to make."""
        say("%s: finding comparable sizes" % case.name)
        return programs.run_cleft(self.cleft, case, "particles", self.threads)["tets"]

    def matched_facets(self, case, target, first):
        if not self.has_cgal:
            return 0
        return programs.matched(
            lambda facets: programs.run_cgal(self.cgal, case, facets, self.threads)[0]["tets"], target, first
        )


def real_case(machine, name, path, folder):
    """A volume at Cleft's default sizes. The lattice and CGAL are given sizes for as many tetrahedra as `particles`
    makes."""
    case = programs.Case(name, path, dict.fromkeys(BACKGROUNDS, []))
    target = machine.particles(case)
    case.raw = programs.Raw.write(path, folder)
    spacing = float(np.prod(case.raw.spacing) ** (1 / 3))
    case.facets = machine.matched_facets(case, target, 1.5 * spacing)
    size = programs.matched(lambda size: programs.expected_lattice(machine.cleft, case, size), target, 2 * spacing)
    case.options["lattice"] = ["--size", size]
    case.is_real = True
    return case


def series_of(voxels):
    """Voxels along the side of a cube of grains, and the edge length at interfaces. It doubles inside of grains. The
    second volume has eightfold voxels, the third eightfold tetrahedra."""
    size = 3 * SIDE / voxels
    return {"base": (voxels, size), "voxels": (2 * voxels, size), "tets": (voxels, size / 2)}


def grains(name, voxels, size, folder):
    path = pathlib.Path(folder) / ("grains_%d.nrrd" % voxels)
    if not path.exists():
        volumes.write_nrrd(path, volumes.voronoi_grains(voxels), [SIDE / voxels] * 3)
    sizes = ["--size-min", size, "--interface-size", size, "--size-max", 2 * size]
    case = programs.Case("grains, " + name, path, dict.fromkeys(BACKGROUNDS, sizes))
    case.raw = programs.Raw.write(path, folder)
    return case


def measure_series(machine, series, repeat, folder):
    """CPU time of one thread: growth is a question of work, not of cores."""
    cases = {name: grains(name, voxels, size, folder) for name, (voxels, size) in series.items()}
    base = cases["base"]
    facets = machine.matched_facets(base, machine.particles(base), series["base"][1] / 2)
    for name, case in cases.items():
        case.facets = facets * series[name][1] / series["base"][1]
    return {name: machine.repeated(case, [1], repeat) for name, case in cases.items()}


def describe(case):
    return {"name": case.name, "dims": case.raw.dims, "labels": int(np.fromfile(case.raw.path, "<u2").max())}


def measure(arguments):
    machine = Machine(arguments)
    counts = sorted({1, machine.threads})
    with tempfile.TemporaryDirectory() as folder:
        measured = []
        for name, path in chosen_volumes(arguments).items():
            case = real_case(machine, name, path, folder)
            runs = machine.repeated(case, counts, arguments.repeat)
            measured.append({**describe(case), "facets": case.facets, "runs": runs})
        series = series_of(arguments.side or (48 if arguments.quick else 96))
        growth = measure_series(machine, series, arguments.repeat, folder)
    return {
        "threads": machine.threads,
        "processor": processor(),
        "repeat": arguments.repeat,
        "volumes": measured,
        "series": series,
        "growth": growth,
    }


def chosen_volumes(arguments):
    if arguments.volumes:
        return {path.name.split(".")[0]: path for path in map(pathlib.Path, arguments.volumes)}
    kept = volumes.kept()
    return {name: kept[name][0][0] for name in (("CIT168",) if arguments.quick else ("CIT168", "AAL")) if name in kept}


def processor():
    found = [line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")]
    return found[0] if found else platform.machine()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("volumes", nargs="*", metavar="VOLUME")
    parser.add_argument("--quick", action="store_true", help="a look in two minutes: one turn, CIT168, small grains")
    parser.add_argument(
        "--repeat", type=int, help="least number of turns of which the least figures count (2; quick: 1)"
    )
    parser.add_argument("--side", type=int, help="voxels along the side of the least cube of grains (96; quick: 48)")
    parser.add_argument(
        "--threads", type=int, default=len(os.sched_getaffinity(0)), help="all threads (default: cores)"
    )
    parser.add_argument("--cleft", default=BUILD / "src/cli/cleft")
    parser.add_argument("--cgal", default=BUILD / "benchmarks/cgal_mesh")
    parser.add_argument("--figures", type=pathlib.Path, help="keep the figures here; if it exists, measure nothing")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="docs/performance.md, or a page with its marks")
    arguments = parser.parse_args()
    arguments.repeat = arguments.repeat or (1 if arguments.quick else 2)
    if arguments.figures and arguments.figures.exists():
        data = json.loads(arguments.figures.read_text())
    else:
        data = measure(arguments)
        if arguments.figures:
            arguments.figures.write_text(json.dumps(data, indent=1))
    performance_page.write(data, arguments.output)


if __name__ == "__main__":
    main()
