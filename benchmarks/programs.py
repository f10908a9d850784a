"""Runs Cleft and CGAL's Mesh_3 on the same labels, and gives the figures of both in one form:

    {"tets": ..., "min_dihedral": ..., "seconds": ..., "cpu_seconds": ..., "peak_bytes": ...,
     "stages": {name: {"seconds": ..., "cpu_seconds": ..., "peak_bytes": ..., "serial_seconds": ...}}}

Both begin with labels in memory and end with a mesh in memory: reading, reports and writing are left out. Serial
seconds are those outside of loops that threads can share. CGAL does not tell them.
"""
import dataclasses
import json
import pathlib
import subprocess
import sys
import time

import numpy as np

import speed
import volumes

KINDS = ("seconds", "cpu_seconds", "peak_bytes", "serial_seconds")
REFINE = "CGAL, refine"
OPTIMISE = "CGAL, refine + perturb + exude"
MESHERS = ("particles", "octree", "lattice", REFINE, OPTIMISE)
INDEPENDENT = "independent"
# What Cleft does by default beyond conforming tetrahedra, left out step by step.
FEWER_GOALS = {
    "without surface_error": ["--surface-error", 0],
    "and 20 degrees": ["--surface-error", 0, "--min-angle", 20],
}


@dataclasses.dataclass
class Case:
    """Labels, and the sizes with which each program makes about as many tetrahedra of them."""

    name: str
    path: pathlib.Path
    options: dict  # of each background
    facets: float = 0  # the greatest of CGAL's; 0: CGAL is left out
    raw: "Raw" = None
    is_real: bool = False  # is meshed with FEWER_GOALS too, beside independent work


@dataclasses.dataclass
class Raw:
    """Labels as the program of CGAL reads them: from 1 upward, so that it meshes all of them."""

    path: pathlib.Path
    dims: list
    spacing: list

    @classmethod
    def write(cls, path, folder):
        labels, spacing = volumes.read_labels(path)
        numbers = np.unique(labels, return_inverse=True)[1].reshape(labels.shape) + 1
        raw = pathlib.Path(folder) / (pathlib.Path(path).name + ".raw")
        numbers.astype("<u2").tofile(raw)
        return cls(raw, list(labels.shape[::-1]), spacing)


def figures_of_stages(metrics, stages):
    found = {}
    for stage in stages:
        figures = {kind: metrics[stage + "." + kind] for kind in KINDS if stage + "." + kind in metrics}
        if figures:
            found[stage] = figures
    return found


def sums(stages):
    """Of consecutive stages: their times, and the peak of the last."""
    total = {kind: sum(stage[kind] for stage in stages) for kind in ("seconds", "cpu_seconds")}
    return {**total, "peak_bytes": stages[-1]["peak_bytes"]}


def serial_seconds(whole, report):
    """Of a whole run on one thread: what is not in a shared loop of one of its stages, between the stages too."""
    metrics = report["metrics"]
    # The steps of a stage are in its own figures.
    parts = ["volume"] + [stage["name"] for stage in report["stages"] if stage["part_of"] == "mesh"]
    shared = [metrics[part + ".cpu_seconds"] - metrics[part + ".serial_seconds"] for part in parts]
    return whole["cpu_seconds"] - sum(shared)


def run_cleft(cleft, case, background, threads, engine="cleft", goals=()):
    options = ["--background", background, "--delaunay", engine, *case.options[background], *goals]
    report = speed.run(cleft, [case.path], options, threads)
    metrics = report["metrics"]
    stages = {stage["name"]: stage for stage in report["stages"]}
    whole = sums([stages["volume"], stages["mesh"]])
    return {
        "tets": report["mesh"]["tets"],
        "points": metrics["background.points"],
        "min_dihedral": report["quality"]["min_dihedral"],
        **whole,
        "serial_seconds": serial_seconds(whole, report),
        "stages": figures_of_stages(metrics, speed.stages_of(report)),
    }


def run_independent(threads):
    """The same work in as many processes: the seconds that one of these works takes of all, so the best that threads
    could reach."""
    work = "total = 0\nfor i in range(15_000_000):\n    total += i * i"
    begin = time.monotonic()
    for process in [subprocess.Popen([sys.executable, "-c", work]) for _ in range(threads)]:
        if process.wait() != 0:
            raise RuntimeError("a loop of independent work failed")
    return {"seconds": (time.monotonic() - begin) / threads}


def run_cgal(program, case, facets, threads):
    """The figures after refining, and those after perturbing and exuding too. Cells are twice as large as facets, which
    keep to the labels within a quarter of their size."""
    raw = case.raw
    sizes = (facets, facets / 4, 2 * facets)
    command = [program, raw.path, *raw.dims, *raw.spacing, *sizes, threads]
    found = json.loads(subprocess.run(list(map(str, command)), check=True, stdout=subprocess.PIPE, text=True).stdout)
    stages = {name: found[name] for name in ("refine", "perturb", "exude")}
    angles = {"refine": found["refined_min_dihedral"], "exude": found["min_dihedral"]}
    answer = []
    for last, names in (("refine", ("refine",)), ("exude", tuple(stages))):
        figures = {name: {kind: stages[name][kind] for kind in KINDS[:3]} for name in names}
        shape = {"tets": stages[last]["tets"], "min_dihedral": angles[last]}
        answer.append({**shape, **sums(list(figures.values())), "stages": figures})
    return answer


def matched(count, target, size):
    """A size with which `count` gives about `target` tetrahedra, within a tenth if three tries suffice."""
    for _ in range(3):
        found = count(size)
        if abs(found / target - 1) < 0.1:
            break
        size = round(size * (found / target) ** (1 / 2.8), 3)  # near the cube root; surfaces grow by the square
    return size


def expected_lattice(cleft, case, size):
    """The number of tetrahedra that the command expects beforehand of a lattice."""
    command = [
        cleft,
        "mesh",
        case.path,
        "--background",
        "lattice",
        "--size",
        size,
        "--estimate",
        "--quiet",
        "--json",
        "-",
    ]
    done = subprocess.run(list(map(str, command)), check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(done.stdout)["estimate"]["tets"]


def least(runs):
    """The least of each figure in repeated runs."""
    if not isinstance(runs[0], dict):
        return min(runs)
    return {key: least([run[key] for run in runs]) for key in runs[0]}
