"""Are the figures of README.md beside other programs those of docs/performance.md, and is its first mesh that of the
gallery?

check_readme.py. Commands make the figures of both pages; README.md repeats some.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text()


def rows(text):
    """The cells of all rows of tables."""
    return [
        [cell.strip() for cell in line.strip("| ").split("|")] for line in text.splitlines() if line.startswith("|")
    ]


def measured():
    """Program -> tetrahedra, least angle, CPU time and memory of AAL on one thread, in the order of README.md."""
    part = (ROOT / "docs/performance.md").read_text().split("<!-- programs -->")[1]
    table = [dict(zip(rows(part)[0], row)) for row in rows(part)]
    columns = ("tetrahedra", "least angle", "CPU time a tetrahedron", "memory a tetrahedron")
    one_thread = [row for row in table if row["volume"] == "AAL" and row["threads"] == "1"]
    return {row["program"]: [row[column] for column in columns] for row in one_thread}


def repeated():
    """The same of README.md."""
    part = re.search(r"^## Beside others$(.*?)^## ", README, re.DOTALL | re.MULTILINE)[1]
    names = {row[0]: re.sub(r"^Cleft, `(\w+)`.*|^CGAL [\d.]+ Mesh_3", r"\1", row[0]) for row in rows(part)}
    names = {name: "CGAL" + short if short.startswith(",") else short for name, short in names.items()}
    return {names[row[0]]: row[1:] for row in rows(part) if len(row) == 5 and names[row[0]] in measured()}


def check_filling():
    """The rows of CIT168 are those of docs/quality.md."""
    part = (ROOT / "docs/quality.md").read_text().split("<!-- filling -->")[1]
    for _, program, tets, least, greatest, below, _, seconds in [row for row in rows(part) if row[0] == "CIT168"]:
        end = f"| {tets} | {least} to {greatest} | {int(below.split(',')[0]):,} | {seconds} s |"
        if end not in README and "O9/7" not in program:
            sys.exit(f"README.md has no row of {program} with {end}")


def main():
    if repeated() != measured():
        sys.exit(f"README.md has\n{repeated()}\ndocs/performance.md has\n{measured()}")
    check_filling()
    (tets,) = re.findall(
        r"^\| brain \| .* \| ([\d,]+) \| [\d.]+ to", (ROOT / "docs/gallery.md").read_text(), re.MULTILINE
    )
    millions = "%.1f million tetrahedra" % (int(tets.replace(",", "")) / 1e6)
    if millions not in README:
        sys.exit(f"README.md does not say that the first mesh has {millions}")


main()
