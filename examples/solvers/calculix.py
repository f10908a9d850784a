"""CalculiX: a pressure between the two materials of a ball, against the exact solution.

The mesh comes from `cleft mesh -o ball.inp`. The job takes the materials by their ELSET, the planes of symmetry by the
NSET of the box's sides, and the load by the SURFACE of the interface: a fluid film between core and shell would press
like this.

    python3 calculix.py            with `cleft` and `ccx` in the PATH
"""
import pathlib
import subprocess
import sys
import tempfile

from ball import CORE_RADIUS, RADIUS, make_mesh

PRESSURE = 1.0
YOUNG = {"core": 300.0, "shell": 100.0}
POISSON = 0.3

JOB = f"""*INCLUDE, INPUT=ball.inp
*MATERIAL, NAME=SHELL
*ELASTIC
{YOUNG['shell']}, {POISSON}
*MATERIAL, NAME=CORE
*ELASTIC
{YOUNG['core']}, {POISSON}
*SOLID SECTION, ELSET=MATERIAL_1, MATERIAL=SHELL
*SOLID SECTION, ELSET=MATERIAL_2, MATERIAL=CORE
*BOUNDARY
BOX_X_MIN, 1, 1
BOX_Y_MIN, 2, 2
BOX_Z_MIN, 3, 3
*STEP
*STATIC
*DSLOAD
INTERFACE_1_2, P, {PRESSURE}
*NODE PRINT, NSET=INTERFACE_1_2
U
*NODE PRINT, NSET=HULL
U
*END STEP
"""


def exact():
    """Radial displacements of the interface and of the surface: Lame's solution, u = A r in the core, B r + C / r^2 in
    the shell; continuous, without traction at the surface, with a jump of the traction by the pressure at the
    interface."""
    a, b = CORE_RADIUS, RADIUS
    bulk = {part: young / (1 - 2 * POISSON) for part, young in YOUNG.items()}  # three times the bulk modulus
    shear = YOUNG["shell"] / (2 * (1 + POISSON))
    # With C = bulk b^3 B / (4 shear) and A = B + C / a^3, what is left is one equation for B.
    c = bulk["shell"] * b**3 / (4 * shear)
    B = PRESSURE / (bulk["core"] * (1 + c / a**3) - bulk["shell"] + 4 * shear * c / a**3)
    return B * a + B * c / a**2, B * b + B * c / b**2


def read_nodes(path):
    """Number -> coordinates, from the .inp."""
    nodes, reading = {}, False
    for line in path.read_text().splitlines():
        if line.startswith("*"):
            reading = line.upper().startswith("*NODE")
        elif reading:
            number, *coordinates = line.split(",")
            nodes[int(number)] = [float(c) for c in coordinates]
    return nodes


def mean_radial(path, node_set, nodes):
    """The mean radial displacement over a set, from the .dat."""
    radial, reading = [], False
    for line in path.read_text().splitlines():
        if "displacements" in line:
            reading = f" {node_set} " in line
        elif reading and line.strip():
            number, *u = line.split()
            x = nodes[int(number)]
            radial.append(sum(float(d) * c for d, c in zip(u, x)) / sum(c * c for c in x) ** 0.5)
    return sum(radial) / len(radial)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        make_mesh(folder, folder / "ball.inp", size=0.1)
        (folder / "job.inp").write_text(JOB)
        subprocess.run(["ccx", "job"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        nodes = read_nodes(folder / "ball.inp")
        failed = False
        for node_set, truth in zip(("INTERFACE_1_2", "HULL"), exact()):
            found = mean_radial(folder / "job.dat", node_set, nodes)
            print(f"{node_set:14} moves outward by {found:.6f}, exactly {truth:.6f}: {found / truth - 1:+.2%}")
            failed = failed or not abs(found / truth - 1) < 0.03
        sys.exit(failed)


main()
