#!/usr/bin/python3
"""Heat through a laminate of thin layers, by linear finite elements of its own, against the exact solution:

    laminate.py

Two layers of glue, each two voxels thick, lie between thicker ones of metal. They conduct badly and make heat; both
ends of the stack are held at temperature 0. The temperature is a parabola in each layer of glue. So the error depends
on how long elements are across the layers, and not along them. With an anisotropy of 8, a mesh with a tenth of the
tetrahedra has less of an error. The program fails if that is not so. It needs numpy.
"""
import numpy as np

import cleft

METAL, GLUE = 1, 2
CONDUCTIVITY = {METAL: 10.0, GLUE: 0.1}
HEAT = {METAL: 0.0, GLUE: 1.0}  # made in a unit of volume
LAYERS = ((METAL, 6), (GLUE, 2), (METAL, 8), (GLUE, 2), (METAL, 6))  # and how many voxels they are thick
SPACING = 0.1
WIDTH = 24  # voxels


class Exact:
    """The temperature and the heat flow at a height z: pieces of second and first degree."""

    def __init__(self):
        self.below = SPACING * np.concatenate([[0], np.cumsum([voxels for _, voxels in LAYERS])])
        self.k = np.array([CONDUCTIVITY[label] for label, _ in LAYERS])
        self.q = np.array([HEAT[label] for label, _ in LAYERS])
        thick = np.diff(self.below)
        made = np.concatenate([[0], np.cumsum(self.q * thick)[:-1]])  # in the layers below
        # The flow that enters below is such that the temperature is 0 at both ends.
        falls = (made * thick + self.q * thick**2 / 2) / self.k
        entering = -falls.sum() / (thick / self.k).sum()
        self.flow_below = entering + made
        falls += entering * thick / self.k
        self.at_below = -np.concatenate([[0], np.cumsum(falls)[:-1]])

    def at(self, z):
        layer = np.clip(np.searchsorted(self.below, z, side="right") - 1, 0, len(LAYERS) - 1)
        up = z - self.below[layer]
        flow = self.flow_below[layer] + self.q[layer] * up
        return self.at_below[layer] - (self.flow_below[layer] * up + self.q[layer] * up**2 / 2) / self.k[layer], flow


def make_mesh(anisotropy, tets):
    labels = np.repeat([label for label, _ in LAYERS], [voxels for _, voxels in LAYERS]).astype(np.uint8)
    labels = np.broadcast_to(labels, (WIDTH, WIDTH, len(labels)))  # labels[i, j, k], i along x
    volume = cleft.Volume(labels, spacing=(SPACING,) * 3, origin=(SPACING / 2,) * 3)
    return cleft.mesh(volume, anisotropy=anisotropy, tets=tets)


def elements(mesh):
    """Volumes, and gradients of the four shape functions, of all tetrahedra."""
    corners = mesh.points[mesh.tets]
    edges = corners[:, 1:] - corners[:, :1]
    gradients = np.empty((len(corners), 4, 3))
    gradients[:, 1:] = np.linalg.inv(edges).transpose(0, 2, 1)
    gradients[:, 0] = -gradients[:, 1:].sum(axis=1)
    return np.linalg.det(edges) / 6, gradients


def solve(mesh, volumes, gradients):
    """Conjugate gradients with the diagonal as preconditioner. Both ends stay at 0."""
    tets, count = mesh.tets, len(mesh.points)
    k, q = (np.array([table[label] for label in mesh.labels]) for table in (CONDUCTIVITY, HEAT))
    matrices = np.einsum("t,tad,tbd->tab", k * volumes, gradients, gradients)

    def gathered(values):
        return np.bincount(tets.ravel(), values.ravel(), count)

    z = mesh.points[:, 2]
    free = (z > z.min()) & (z < z.max())
    diagonal = gathered(np.einsum("taa->ta", matrices))
    temperature = np.zeros(count)
    rest = free * gathered(np.repeat(q * volumes / 4, 4))
    way = next_way = rest / diagonal
    left = first = rest @ next_way
    while left > 1e-18 * first:
        pull = free * gathered(np.einsum("tab,tb->ta", matrices, way[tets]))
        step = left / (way @ pull)
        temperature += step * way
        rest = rest - step * pull
        next_way = rest / diagonal
        left, before = rest @ next_way, left
        way = next_way + left / before * way
    return temperature


def errors(mesh, temperature, volumes, gradients):
    """Of the temperature in the L2 norm, and of the heat flow in the energy norm, relative."""
    exact = Exact()
    k = np.array([CONDUCTIVITY[label] for label in mesh.labels])
    slopes = np.einsum("ta,tad->td", temperature[mesh.tets], gradients)
    sums = np.zeros(4)
    weights = np.full((4, 4), 0.1381966011250105) + np.diag([0.4472135954999580] * 4)  # a quadrature of degree 2
    for weight in weights:
        truth, flow = exact.at(mesh.points[mesh.tets][:, :, 2] @ weight)
        wrong_flow = (-k[:, None] * slopes - np.outer(flow, (0, 0, 1))) ** 2
        sums += (
            volumes @ (temperature[mesh.tets] @ weight - truth) ** 2,
            volumes @ truth**2,
            volumes @ (wrong_flow.sum(axis=1) / k),
            volumes @ (flow**2 / k),
        )
    return np.sqrt(sums[0] / sums[1]), np.sqrt(sums[2] / sums[3])


found = []
print("anisotropy  tetrahedra  temperature  heat flow")
for ratio, wanted in ((1, 0), (8, 0), (8, 5000)):  # 0: as many as the sizes ask for
    mesh = make_mesh(ratio, wanted)
    volumes, gradients = elements(mesh)
    found.append((len(mesh.tets), *errors(mesh, solve(mesh, volumes, gradients), volumes, gradients)))
    print("%10d %11d %12.2e %10.2e" % (ratio, *found[-1]))

round_ones, _, flat = found
assert flat[1] < round_ones[1] and flat[2] < round_ones[2], "the errors grew"
assert 10 * flat[0] < round_ones[0], "hardly any tetrahedra were saved"
