"""meshio reads every format that it knows: .vtu, .vtk, .mesh, .msh (both), .node/.ele, .inp, .stl."""
import meshio
import numpy as np

from sample import corners, run_checks_with_all_labels, same


def tets_of(mesh, key):
    """All tetrahedra with their numbers, blocks in a row."""
    blocks = [i for i, block in enumerate(mesh.cells) if block.type == "tetra"]
    tets = np.concatenate([mesh.cells[i].data for i in blocks])
    return tets, np.concatenate([mesh.cell_data[key][i] for i in blocks])


def check_with_labels(name, key):
    def check(sample):
        mesh = meshio.read(sample.path(name))
        sample.check_tets(mesh.points, *tets_of(mesh, key))

    check.__name__ = "meshio reads " + name
    return check


def check_triangles_of_medit(sample):
    mesh = meshio.read(sample.path("medit.mesh"))
    names = {}
    with open(sample.path("medit.mesh")) as file:
        for line in file:
            if line.startswith("# ") and " = " in line and not line.startswith("# material"):
                number, name = line[2:].split(" = ")
                names[int(number)] = name.strip()
    groups = {}
    for block, references in zip(mesh.cells, mesh.cell_data["medit:ref"]):
        if block.type == "triangle":
            for triangle, reference in zip(block.data, references):
                groups.setdefault(names[reference], set()).add(corners(*triangle))
    same(groups, sample.groups(), "triangles")


def check_gmsh(name):
    def check(sample):
        mesh = meshio.read(sample.path(name))
        names = {(dimension, number): group for group, (number, dimension) in mesh.field_data.items()}
        groups, materials = {}, {}
        point_of = {tuple(point): i for i, point in enumerate(sample.points.tolist())}  # 4.1 orders points by entity
        for block, numbers in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
            for cell, number in zip(mesh.points[block.data], numbers):
                named = materials if block.type == "tetra" else groups
                group = names[3 if block.type == "tetra" else 2, number]
                named.setdefault(group, set()).add(corners(*(point_of[tuple(point)] for point in cell.tolist())))
        same(groups, sample.groups(), "triangles")
        same(materials, sample.materials(), "tetrahedra")

    check.__name__ = "meshio reads " + name
    return check


def check_tetgen(sample):
    mesh = meshio.read(sample.path("tetgen.node"))
    sample.check_tets(mesh.points, *tets_of(mesh, [k for k in mesh.cell_data if "ref" in k][0]))


def check_abaqus(sample):
    mesh = meshio.read(sample.path("abaqus.inp"))
    tets = np.concatenate([block.data for block in mesh.cells if block.type == "tetra"])
    same(mesh.points.tobytes(), sample.points.tobytes(), "points")
    same(sorted(corners(*t) for t in tets), sorted(corners(*t) for t in sample.tets), "tetrahedra")
    wanted = {name.upper(): set(sum(group, ())) for name, group in sample.groups().items() if "interface" in name}
    got = {name: set(points.tolist()) for name, points in mesh.point_sets.items() if "INTERFACE" in name}
    same(got, wanted, "node sets of interfaces")


def check_stl(sample):
    mesh = meshio.read(sample.path("stl.stl"))
    triangles = mesh.points[mesh.cells_dict["triangle"]]
    same(triangles.tolist(), sample.points[sample.interface[:, :3]].astype("f4").tolist(), "triangles")


run_checks_with_all_labels(
    check_with_labels("vtu.vtu", "material"),
    check_with_labels("vtk.vtk", "material"),
    check_with_labels("medit.mesh", "medit:ref"),
    check_triangles_of_medit,
    check_gmsh("msh22.msh"),
    check_gmsh("msh41.msh"),
    check_tetgen,
    check_abaqus,
    check_stl,
)
