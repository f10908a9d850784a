"""FreeFEM: heat conduction in a ball of two materials, on the MEDIT file, against the exact solution.

The regions of heat.edp are the labels; a comment of the file says the number of the free surface.

    python3 freefem.py             with `cleft` and `FreeFem++-nw` in the PATH
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from ball import make_mesh


def main():
    with tempfile.TemporaryDirectory() as name:
        mesh = pathlib.Path(name, "ball.mesh")
        make_mesh(name, mesh, size=0.1)
        surface = re.search(r"^#\s*(\d+) = hull_1$", mesh.read_text(), re.M).group(1)
        script = pathlib.Path(__file__).with_name("heat.edp")
        output = subprocess.run(
            ["FreeFem++-nw", "-v", "0", script, mesh, surface], cwd=name, check=True, capture_output=True, text=True
        ).stdout
    print(output.strip())
    core, shell, error = (float(re.search(rf"{what}: (\S+)", output).group(1)) for what in ("core", "shell", "error"))
    # An eighth of the volumes of core and shell, and the temperature in the L2 norm.
    sys.exit(not (abs(core / 0.0654498 - 1) < 0.02 and abs(shell / 0.4581489 - 1) < 0.02 and error < 0.01))


main()
