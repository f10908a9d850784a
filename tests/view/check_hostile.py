"""Names that are HTML, and 10,000 labels: all of it is text, and the page stays as it is."""
import pathlib
import tempfile

from browser import run_script, skip_without_browser

skip_without_browser()

from support import cleft  # noqa: E402

LABELS = 10000
NAMES = {
    0: "<img src=x onerror=alert(1)>",
    1: "</script><script>alert(2)</script>",
    2: "\" onclick='alert(3)' & <b>bold</b> <!--",
    3: "javascript:alert(4) \u202eback\u2066 \\u003c ${alert(5)} `",
    4: "x" * 5000,
}


def write_mesh(path):
    """Tetrahedra that do not touch, each with a label of its own."""
    points, cells = [], []
    for label in range(LABELS):
        x, y = 2 * (label % 100), 2 * (label // 100)
        points += [f"{x} {y} 0", f"{x + 1} {y} 0", f"{x} {y + 1} 0", f"{x} {y} 1"]
        cells.append("4 " + " ".join(str(4 * label + corner) for corner in range(4)))
    lines = ["# vtk DataFile Version 3.0", "labels", "ASCII", "DATASET UNSTRUCTURED_GRID"]
    lines += [f"POINTS {len(points)} double", *points, f"CELLS {LABELS} {5 * LABELS}", *cells]
    lines += [f"CELL_TYPES {LABELS}", *["10"] * LABELS, f"CELL_DATA {LABELS}", "SCALARS material int 1"]
    lines += ["LOOKUP_TABLE default", *map(str, range(LABELS))]
    path.write_text("\n".join(lines) + "\n")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        mesh, page, names = folder / "<b>&.vtk", folder / "hostile.html", folder / "names.txt"
        write_mesh(mesh)
        names.write_text("".join(f"{label} {text}\n" for label, text in NAMES.items()))
        done = cleft("view", mesh, "-o", page, "--names", names, "-q")
        assert done.returncode == 0, done.stderr
        run_script("hostile", page=page, names=[text for _, text in sorted(NAMES.items())], labels=LABELS)


main()
