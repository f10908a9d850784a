"""How pages open: long meshes, backgrounds that leave a side of the box, and two meshes in different places."""
import pathlib
import tempfile

from browser import run_script, skip_without_browser

skip_without_browser()

from support import cleft, write_nrrd  # noqa: E402


def volume_of(dims, label):
    return [label(x, y, z) for z in range(dims[2]) for y in range(dims[1]) for x in range(dims[0])]


def standing(x, y, z):
    """A column of label 2 on the floor of the box."""
    return 2 if (x - 7.5) ** 2 + (y - 7.5) ** 2 < 16 and z < 11 else 0


def uniform(path):
    """Tetrahedra of one size, whose coordinates have rounding."""
    points, cells = [], []
    for i in range(20):
        x, y, z = 100 + i / 3, 200 + (i % 3) / 7, i / 11
        points += [f"{x} {y} {z}", f"{x + 0.1} {y} {z}", f"{x} {y + 0.1} {z}", f"{x} {y} {z + 0.1}"]
        cells.append("4 " + " ".join(str(4 * i + corner) for corner in range(4)))
    lines = ["# vtk DataFile Version 3.0", "uniform", "ASCII", "DATASET UNSTRUCTURED_GRID"]
    lines += [f"POINTS {len(points)} double", *points, f"CELLS 20 {5 * 20}", *cells, "CELL_TYPES 20", *["10"] * 20]
    path.write_text("\n".join(lines) + "\n")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def run(*arguments):
            done = cleft(*arguments, "-q")
            assert done.returncode == 0, done.stderr

        def mesh(name, dims, label, *options, origin=(0, 0, 0)):
            write_nrrd(folder / f"{name}.nrrd", dims, volume_of(dims, label), origin=origin)
            run("mesh", folder / f"{name}.nrrd", "-o", folder / f"{name}.vtu", *options)

        def view(page, *meshes):
            run("view", *(folder / mesh for mesh in meshes), "-o", folder / page)
            return folder / page

        long = []
        for axis in range(3):
            dims = [40 if axis == other else 4 for other in range(3)]
            mesh(f"long{axis}", dims, lambda x, y, z: 1)
            long.append(str(view(f"long{axis}.html", f"long{axis}.vtu")))
        mesh("standing", (16, 16, 16), standing)
        mesh("far", (16, 16, 16), standing, origin=(0, -60, 0))
        mesh("halves", (8, 8, 8), lambda x, y, z: int(z > 3))
        run("convert", folder / "standing.vtu", folder / "stripped.vtu", "--strip", "0")
        uniform(folder / "uniform.vtk")
        run_script(
            "first_view",
            long=long,
            standing=view("standing.html", "standing.vtu"),
            apart=view("apart.html", "standing.vtu", "far.vtu"),
            halves=view("halves.html", "halves.vtu"),
            stripped=view("stripped.html", "stripped.vtu", "standing.vtu"),
            uniform=view("uniform.html", "uniform.vtk"),
        )


main()
