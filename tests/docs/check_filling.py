"""Does benchmarks/filling.py have every program fill the surfaces of a small mesh, and are all meshes sound?

check_filling.py CLEFT
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main():
    command = (sys.executable, "-B", ROOT / "benchmarks/filling.py", "--cleft", sys.argv[1], "--only", "mickey")
    printed = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    rows = [[cell.strip() for cell in line.strip("| ").split("|")] for line in printed.splitlines()]
    if len(rows) != 5 or any(row[6] != "yes" for row in rows):
        sys.exit(f"a program made no sound mesh:\n{printed}")


main()
