"""Pictures of meshes, with pyvista or matplotlib, whichever there is."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import numpy as np

if TYPE_CHECKING:
    from .meshes import Mesh


def plot(mesh: Mesh, labels: Sequence[int] | None = None, *, backend: str | None = None, **keywords: Any) -> Any:
    """Draws the outside of the tetrahedra of `labels` (all without), coloured by label.

    `backend` is "pyvista" or "matplotlib"; without it, pyvista if it is there, else matplotlib. Answers a
    pyvista.Plotter or the matplotlib axes; call show() or savefig() on them. Other keywords go to add_mesh() or to
    Poly3DCollection(); `axes` gives the matplotlib axes to draw in.
    """
    if backend not in (None, "pyvista", "matplotlib"):
        raise ValueError(f"backend is {backend!r}; it must be 'pyvista' or 'matplotlib'")
    if backend != "matplotlib":
        try:
            return _with_pyvista(mesh, labels, keywords)
        except ImportError:
            if backend == "pyvista":
                raise
    return _with_matplotlib(mesh, labels, keywords)


def _kept(mesh: Mesh, labels: Sequence[int] | None) -> Any:
    return np.ones(len(mesh.labels), bool) if labels is None else np.isin(mesh.labels, labels)


def _outside(mesh: Mesh, kept: Any) -> tuple[Any, Any]:
    """The triangles of the kept tetrahedra that no other kept one of the same label shares, and their labels."""
    tets, names = mesh.tets[kept], mesh.labels[kept]
    faces = tets[:, [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]]].reshape(-1, 3)
    owner = np.repeat(names, 4)
    keys = np.column_stack((np.sort(faces, axis=1), owner))
    _, first, count = np.unique(keys, axis=0, return_index=True, return_counts=True)
    outside = first[count == 1]
    return faces[outside], owner[outside]


def _with_pyvista(mesh: Mesh, labels: Sequence[int] | None, keywords: dict[str, Any]) -> Any:
    import pyvista

    kept = _kept(mesh, labels)
    grid = pyvista.UnstructuredGrid({pyvista.CellType.TETRA: mesh.tets[kept]}, mesh.points.copy())
    grid.cell_data["material"] = mesh.labels[kept]
    plotter = pyvista.Plotter()
    plotter.add_mesh(grid, **{"scalars": "material", "show_edges": True, **keywords})
    return plotter


def _with_matplotlib(mesh: Mesh, labels: Sequence[int] | None, keywords: dict[str, Any]) -> Any:
    import matplotlib.pyplot as pyplot
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    triangles, owner = _outside(mesh, _kept(mesh, labels))
    axes = keywords.pop("axes", None)
    if axes is None:
        axes = pyplot.figure().add_subplot(projection="3d")
    colors = pyplot.get_cmap("tab20")(np.searchsorted(mesh.different_labels, owner) % 20)
    corners = mesh.points[triangles]
    axes.add_collection3d(
        Poly3DCollection(corners, **{"facecolors": colors, "edgecolors": "black", "linewidths": 0.2, **keywords})
    )
    low, high = (corners.reshape(-1, 3).min(0), corners.reshape(-1, 3).max(0)) if len(corners) else ((0,) * 3, (1,) * 3)
    for name, least, greatest in zip("xyz", low, high):
        getattr(axes, f"set_{name}lim")(least, greatest)
        getattr(axes, f"set_{name}label")(name)
    axes.set_box_aspect(np.subtract(high, low))
    return axes
