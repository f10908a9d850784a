"""CalculiX runs a job of steady heat conduction on the .inp: between two sides of the box the flux is known exactly,
also through the surface of the interfaces, and every set and surface is used."""
import subprocess

import numpy as np

from sample import SIDES, run_checks_with_all_labels, same, word

CONDUCTIVITY = 2.0
JOB = """*INCLUDE, INPUT=abaqus.inp
*MATERIAL, NAME=ANY
*CONDUCTIVITY
%g
%s
*INITIAL CONDITIONS, TYPE=TEMPERATURE
ALL, 0
*STEP
*HEAT TRANSFER, STEADY STATE
*BOUNDARY
BOX_X_MIN, 11, 11, 0
BOX_X_MAX, 11, 11, 1
%s
*NODE PRINT, NSET=ALL
NT
%s
*END STEP
"""


def names_in(path, keyword, parameter):
    names = []
    for line in open(path):
        if line.startswith(keyword + ","):
            names += [item.split("=")[1].strip() for item in line.split(",") if item.strip().startswith(parameter)]
    return names


def total_fluxes(path):
    """Surface -> total heat flux out of its elements, as SECTION PRINT gives it."""
    lines = open(path).read().splitlines()
    return {
        line.split(" set ")[1].split()[0]: float(lines[i + 2])
        for i, line in enumerate(lines)
        if "total surface flux" in line
    }


def areas_along_x(sample):
    """Surface -> its area as seen from x."""
    areas = {}
    rows = [("INTERFACE_%s_%s" % (word(a), word(b)), t) for *t, a, b in sample.interface]
    rows += [(SIDES[side].upper(), t) for *t, label, side in sample.hull]
    for name, triangle in rows:
        a, b, c = sample.points[triangle]
        areas[name.upper()] = areas.get(name.upper(), 0) + np.cross(b - a, c - a)[0] / 2
    return areas


def check_heat_conduction(sample):
    inp = sample.path("abaqus.inp")
    groups = [name.upper() for name in sample.groups()]
    interfaces = {name for name in groups if name.startswith("INTERFACE")}
    sides = {name.rsplit("_", 1)[0] for name in groups if name.startswith("BOX")}
    same(set(names_in(inp, "*SURFACE", "NAME")), interfaces | sides, "surfaces")
    same(set(names_in(inp, "*NSET", "NSET")), interfaces | sides, "node sets")
    labels = set(sample.labels.tolist())
    same(
        set(names_in(inp, "*ELEMENT", "ELSET")), {"MATERIAL_" + word(label).upper() for label in labels}, "element sets"
    )
    same(names_in(inp, "*ELSET", "ELSET"), [sample.material(sample.named).upper()], "element sets by name")

    sections = "\n".join("*SOLID SECTION, MATERIAL=ANY, ELSET=" + name.upper() for name in sample.materials())
    fluxes = "\n".join(
        "*SECTION PRINT, SURFACE=%s, NAME=F%d\nFLUX" % (name, i) for i, name in enumerate(sorted(interfaces | sides))
    )
    node_sets = "\n".join("*NODE PRINT, NSET=%s\nNT" % name for name in sorted(interfaces))
    with open(sample.path("job.inp"), "w") as file:
        file.write(JOB % (CONDUCTIVITY, sections, node_sets, fluxes))
    run = subprocess.run(["ccx", "job"], cwd=sample.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    faults = [line for line in run.stdout.splitlines() if "ERROR" in line]
    same((run.returncode, faults), (0, []), "complaints of ccx")

    extent = sample.points.max(0) - sample.points.min(0)
    fluxes = total_fluxes(sample.path("job.dat"))
    areas = areas_along_x(sample)
    same(set(fluxes), set(areas), "surfaces with a flux")
    for name, area in areas.items():
        wanted = -CONDUCTIVITY / extent[0] * area  # from the warm side x_max to the cold side x_min
        assert abs(fluxes[name] - wanted) < 1e-5, (name, fluxes[name], wanted)


run_checks_with_all_labels(check_heat_conduction)
