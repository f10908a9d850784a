"""The triangles of a mesh: those between labels, and those of the hull."""
from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import native
from ._handle import Handle, Owner, view
from .mesher import Mesher

#: Names of the sides in `Surface.hull_sides`, in the axes of the voxels; "other": triangles in no side of the box.
SIDES = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max", "other")


class Surface(Owner):
    """Interfaces and hull of a mesh, as triangles that number its points: `mesh.surface()`. All arrays are views."""

    def __init__(self, mesh: Handle, mesher: Mesher) -> None:
        self._handle = Handle(mesher._call(native.cleft_surface_create, mesh), native.cleft_surface_destroy)

    def _interface(self, read: Any, width: int) -> npt.NDArray[np.int32]:
        handle = self._native
        return view(handle, read(handle), (native.cleft_surface_interface_count(handle), width), np.int32)

    @property
    def interface_triangles(self) -> npt.NDArray[np.int32]:
        """Triangles between different labels, shaped (n, 3); normals point from the first label to the second."""
        return self._interface(native.cleft_surface_interface_triangles, 3)

    @property
    def interface_labels(self) -> npt.NDArray[np.int32]:
        """The two labels of each, shaped (n, 2), the lower first; the triangles are sorted by them."""
        return self._interface(native.cleft_surface_interface_labels, 2)

    @property
    def hull_triangles(self) -> npt.NDArray[np.int32]:
        """Triangles of the hull, shaped (n, 3), normals outward, sorted by side, then by label."""
        handle = self._native
        shape = (native.cleft_surface_hull_count(handle), 3)
        return view(handle, native.cleft_surface_hull_triangles(handle), shape, np.int32)

    @property
    def hull_labels(self) -> npt.NDArray[np.int32]:
        """The label inside each triangle of the hull."""
        handle = self._native
        shape = (native.cleft_surface_hull_count(handle),)
        return view(handle, native.cleft_surface_hull_labels(handle), shape, np.int32)

    @property
    def hull_sides(self) -> npt.NDArray[np.int32]:
        """The side of the box of each triangle of the hull: an index into `cleft.SIDES`."""
        handle = self._native
        shape = (native.cleft_surface_hull_count(handle),)
        return view(handle, native.cleft_surface_hull_sides(handle), shape, np.int32)
