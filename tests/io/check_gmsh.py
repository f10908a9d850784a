"""Gmsh reads .msh (both versions) and .mesh, checks them and writes them again; points, elements and groups are
compared.
"""
import os
import subprocess

import numpy as np

from sample import corners, run_checks_with_all_labels, same

REWRITE = """Merge "%s";
Mesh.MshFileVersion = 2.2;
Mesh.Binary = 0;
Mesh.SaveAll = %d;
Save "%s";
"""


def rewrite(path, save_all=0):
    """The file as Gmsh writes it, as lists of the words of each line by section."""
    script, out = path + ".geo", path + ".rewritten.msh"
    with open(script, "w") as file:
        file.write(REWRITE % (path, save_all, out))
    run = subprocess.run(
        ["gmsh", script, "-check", "-parse_and_exit"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    faults = [line for line in run.stdout.splitlines() if "Error" in line or "Warning" in line]
    same((run.returncode, faults), (0, []), "complaints of Gmsh")
    sections, lines = {}, None
    for line in open(out):
        if line.startswith("$End"):
            lines = None
        elif line.startswith("$"):
            lines = sections.setdefault(line.strip(), [])
        else:
            lines.append(line.split())
    return sections


def point_numbers(sample, sections):
    """Number of Gmsh -> number of the point at the same place: Gmsh numbers anew and writes 16 digits."""
    numbers = {}
    for row in sections["$Nodes"][1:]:
        distances = np.abs(sample.points - [float(x) for x in row[1:]]).max(axis=1)
        assert distances.min() < 1e-11
        numbers[int(row[0])] = int(distances.argmin())
    same(sorted(numbers.values()), list(range(len(sample.points))), "points")
    return numbers


def groups_of(sample, sections, names):
    """Name of each group -> set of its cells."""
    numbers = point_numbers(sample, sections)
    groups = {}
    for row in sections["$Elements"][1:]:
        kind, tags = int(row[1]), int(row[2])
        cell = corners(*(numbers[int(p)] for p in row[3 + tags :]))
        groups.setdefault(names(3 if kind == 4 else 2, int(row[3]), int(row[4])), set()).add(cell)
    return groups


def check_msh(name):
    def check(sample):
        sections = rewrite(sample.path(name))
        names = {(int(row[0]), int(row[1])): row[2].strip('"') for row in sections["$PhysicalNames"][1:]}
        groups = groups_of(sample, sections, lambda dimension, physical, entity: names[dimension, physical])
        same(groups, {**sample.groups(), **sample.materials()}, "groups")

    check.__name__ = "gmsh reads " + name
    return check


def check_medit(sample):
    sections = rewrite(sample.path("medit.mesh"), save_all=1)
    groups = groups_of(sample, sections, lambda dimension, physical, entity: (dimension, entity))
    tets = {cell for (dimension, _), cells in groups.items() if dimension == 3 for cell in cells}
    same(tets, {corners(*tet) for tet in sample.tets}, "tetrahedra")
    triangles = [cells for (dimension, _), cells in sorted(groups.items()) if dimension == 2]
    same(triangles, list(sample.groups().values()), "triangles")


run_checks_with_all_labels(check_msh("msh41.msh"), check_msh("msh22.msh"), check_medit)
