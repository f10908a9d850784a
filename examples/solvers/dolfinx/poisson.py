"""dolfinx on a mesh that cleft-mpi wrote: the potential about a ball that conducts better, against the exact solution.

Each rank reads its share of the one file and keeps it. Tetrahedra lie in the file as neighbours in space do, so that
shares of equal length are good ones. Prints the volume of each label and the error in the L2 norm.

    mpirun -n 4 python3 poisson.py ball.vtkhdf
"""
import sys

import dolfinx
import h5py
import numpy
import ufl
from dolfinx import fem
from dolfinx.fem.petsc import LinearProblem
from mpi4py import MPI

BALL_RADIUS = 0.55
CONDUCTIVITY = {1: 1.0, 2: 10.0}  # by label: around, ball
COMM = MPI.COMM_WORLD


def share(rows):
    """The rows of this rank."""
    return slice(rows * COMM.rank // COMM.size, rows * (COMM.rank + 1) // COMM.size)


def keep_cells(comm, parts, neighbours, ghosting):
    """A partitioner that leaves each cell where it is, given the neighbours of each across its faces. dolfinx 0.5 finds
    the points that ranks share by the cells on both sides, so a cell also goes to the ranks of its neighbours."""
    count = neighbours.num_nodes
    first = numpy.cumsum([0, *COMM.allgather(count)])
    owners = numpy.searchsorted(first, neighbours.array, "right") - 1
    cells = numpy.repeat(numpy.arange(count), numpy.diff(neighbours.offsets))
    others = numpy.unique(numpy.stack([cells, owners], 1)[owners != COMM.rank], axis=0)
    # The owner comes first for each cell: the sort is stable.
    pairs = numpy.concatenate([numpy.stack([numpy.arange(count), numpy.full(count, COMM.rank)], 1), others])
    pairs = pairs[numpy.argsort(pairs[:, 0], kind="stable")]
    offsets = numpy.searchsorted(pairs[:, 0], numpy.arange(count + 1))
    return dolfinx.cpp.graph.AdjacencyList_int32(pairs[:, 1].astype(numpy.int32), offsets.astype(numpy.int32))


def read(path):
    """The mesh, and the label of each of its cells on this rank."""
    with h5py.File(path) as file:
        grid = file["VTKHDF"]
        labels = grid["CellData/material"]
        mine = share(len(labels))
        corners = grid["Connectivity"][4 * mine.start : 4 * mine.stop].reshape(-1, 4)
        points = grid["Points"][share(len(grid["Points"]))]
        labels = labels[mine]
    element = ufl.VectorElement("Lagrange", ufl.tetrahedron, 1)
    # Without a partitioner of ours, dolfinx distributes the cells by SCOTCH.
    partitioner = dolfinx.cpp.mesh.create_cell_partitioner(keep_cells)
    mesh = dolfinx.mesh.create_mesh(COMM, corners, points, ufl.Mesh(element), dolfinx.mesh.GhostMode.none, partitioner)
    # The numbers that the cells of this rank have in the file, in the order of dolfinx.
    return mesh, labels[numpy.array(mesh.topology.original_cell_index) - mine.start]


def exact(x, where, root):
    k = CONDUCTIVITY[2]
    r = root(x[0] ** 2 + x[1] ** 2 + x[2] ** 2)
    return where(r < BALL_RADIUS, 3 / (k + 2) * x[2], x[2] * (1 - (k - 1) / (k + 2) * (BALL_RADIUS / r) ** 3))


def cell_values(mesh, values):
    function = fem.Function(fem.FunctionSpace(mesh, ("DG", 0)))
    function.x.array[:] = values
    return function


def integral(integrand, degree):
    form = fem.form(integrand * ufl.dx(metadata={"quadrature_degree": degree}))
    return COMM.allreduce(fem.assemble_scalar(form), MPI.SUM)


def solve(mesh, labels):
    space = fem.FunctionSpace(mesh, ("Lagrange", 1))
    conductivity = cell_values(mesh, numpy.vectorize(CONDUCTIVITY.get)(labels))
    mesh.topology.create_connectivity(2, 3)
    hull = fem.locate_dofs_topological(space, 2, dolfinx.mesh.exterior_facet_indices(mesh.topology))
    held = fem.Function(space)
    held.interpolate(lambda x: exact(x, numpy.where, numpy.sqrt))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    problem = LinearProblem(
        ufl.inner(conductivity * ufl.grad(u), ufl.grad(v)) * ufl.dx,
        ufl.inner(fem.Constant(mesh, 0.0), v) * ufl.dx,
        [fem.dirichletbc(held, hull)],
        petsc_options={"ksp_type": "cg", "pc_type": "gamg", "ksp_rtol": 1e-10, "ksp_error_if_not_converged": True},
    )
    return problem.solve()


def main():
    mesh, labels = read(sys.argv[1])
    volumes = [integral(cell_values(mesh, labels == label), 0) for label in CONDUCTIVITY]
    difference = solve(mesh, labels) - exact(ufl.SpatialCoordinate(mesh), ufl.conditional, ufl.sqrt)
    error = integral(difference**2, 5) ** 0.5
    if COMM.rank == 0:
        print(*volumes, error)


main()
