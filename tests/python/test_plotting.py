"""Pictures: what is drawn with matplotlib, and what is handed to pyvista, for which a stand-in is here."""
import io
import sys
import types
import unittest
from unittest import mock

import matplotlib.pyplot as pyplot
import numpy as np

import cleft
from support import ball_mesh


class Grid:
    """Of pyvista's UnstructuredGrid, how it is made and its cell data."""

    def __init__(self, cells, points):
        self.cells, self.points, self.cell_data = cells, points, {}


class Plotter:
    """Of pyvista's Plotter, what it is given."""

    def __init__(self):
        self.added = []

    def add_mesh(self, grid, **keywords):
        self.added.append((grid, keywords))


PYVISTA = types.SimpleNamespace(UnstructuredGrid=Grid, CellType=types.SimpleNamespace(TETRA=10), Plotter=Plotter)


class Matplotlib(unittest.TestCase):
    def tearDown(self):
        pyplot.close("all")

    def test_the_outside_of_the_labels_is_drawn(self):
        mesh = ball_mesh()
        axes = mesh.plot([1, 7], backend="matplotlib", linewidths=0.5)
        (triangles,) = axes.collections
        surface = mesh.surface()
        touching = np.isin(surface.interface_labels, [1, 7]).sum() + np.isin(surface.hull_labels, [1, 7]).sum()
        self.assertEqual(len(triangles.get_facecolor()), touching)
        self.assertEqual(len(np.unique(triangles.get_facecolor(), axis=0)), 2)
        self.assertEqual(list(triangles.get_linewidth()), [0.5])
        picture = io.BytesIO()
        axes.figure.savefig(picture, format="png")
        self.assertTrue(picture.getvalue().startswith(b"\x89PNG"))

    def test_axes_of_the_caller(self):
        axes = pyplot.figure().add_subplot(projection="3d")
        self.assertIs(ball_mesh().plot(backend="matplotlib", axes=axes), axes)
        self.assertIs(ball_mesh().plot([12345], backend="matplotlib", axes=axes), axes)  # nothing to draw

    def test_without_pyvista(self):
        with mock.patch.dict(sys.modules, pyvista=None):  # import pyvista fails
            self.assertEqual(len(ball_mesh().plot().collections), 1)
            with self.assertRaises(ImportError):
                ball_mesh().plot(backend="pyvista")

    def test_wrong_use(self):
        with self.assertRaises(ValueError):
            ball_mesh().plot(backend="crayons")
        mesh = ball_mesh()
        mesh.close()
        with self.assertRaises(cleft.Closed):
            mesh.plot(backend="matplotlib")


class Pyvista(unittest.TestCase):
    def test_what_it_is_given(self):
        mesh = ball_mesh()
        with mock.patch.dict(sys.modules, pyvista=PYVISTA):
            for backend in (None, "pyvista"):
                ((grid, keywords),) = mesh.plot([7], backend=backend, opacity=0.5).added
                self.assertTrue(np.array_equal(grid.cells[10], mesh.tets[mesh.labels == 7]))
                self.assertTrue(np.array_equal(grid.points, mesh.points))
                self.assertTrue(grid.points.flags.writeable)
                self.assertEqual(set(grid.cell_data["material"]), {7})
                self.assertEqual(keywords, {"scalars": "material", "show_edges": True, "opacity": 0.5})


if __name__ == "__main__":
    unittest.main()
