"""Meshes, and the stages that make them."""
from __future__ import annotations

import os
import tempfile
from typing import TYPE_CHECKING, Any, Sequence, Unpack

import numpy as np
import numpy.typing as npt

from . import native
from ._arrays import float_array, int32_array, rows, true_or_false
from ._handle import Handle, native_of, required, view
from ._label_names import Named
from .errors import InvalidArgument, raise_for
from .mesher import Mesher, mesher_or_plain
from .options import OptionKeywords, Options, lists_options, options_of
from .results import Contact, Distance, Estimate, LabelReport, MetricQuality, Quality, Report, Validation, from_struct
from .sizing import Sizing
from .surface import Surface
from .views import View, write_view
from .volume import Volume

if TYPE_CHECKING:
    import meshio


class Mesh(Named):
    """Points, tetrahedra and their labels; a background mesh has the label 0 only. It never changes.

    Meshes come from `cleft.mesh()` and the other stages, or from arrays: Mesh(points, tets, labels). Those are copied;
    `index_base` is the number of the first point, 0 or 1.
    """

    _get_name = staticmethod(native.cleft_mesh_label_name)
    _set_name = staticmethod(native.cleft_mesh_set_label_name)
    _read_names = "cleft_io_read_mesh_names"

    def _own_labels(self) -> list[int]:
        return self.different_labels.tolist()

    def __init__(
        self,
        points: npt.ArrayLike,
        tets: npt.ArrayLike,
        labels: npt.ArrayLike | None = None,
        *,
        index_base: int = 0,
        mesher: Mesher | None = None,
    ) -> None:
        places = rows(float_array(points, "points"), 3, "points")
        corners = rows(int32_array(tets, "tets"), 4, "tets")
        names = None if labels is None else int32_array(labels, "labels")
        if names is not None and names.shape != (len(corners),):
            raise InvalidArgument(f"labels has the shape {names.shape}; there are {len(corners)} tetrahedra")
        self._handle = Handle(
            mesher_or_plain(mesher)._call(
                native.cleft_mesh_create, len(places), places, len(corners), corners, names, index_base
            ),
            native.cleft_mesh_destroy,
        )

    @classmethod
    def _adopt(cls, address: int) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._handle = Handle(address, native.cleft_mesh_destroy)
        return mesh

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """World coordinates, shaped (n, 3); a view: read-only, not a copy, and good as long as you hold it."""
        handle = self._native
        shape = (native.cleft_mesh_point_count(handle), 3)
        return view(handle, native.cleft_mesh_points(handle), shape, np.float64)

    @property
    def tets(self) -> npt.NDArray[np.int32]:
        """The corners of each tetrahedron, shaped (n, 4), counted from 0, positively oriented; a view."""
        handle = self._native
        return view(handle, native.cleft_mesh_tets(handle), (native.cleft_mesh_tet_count(handle), 4), np.int32)

    @property
    def labels(self) -> npt.NDArray[np.int32]:
        """The label of each tetrahedron, shaped (n,); a view."""
        handle = self._native
        return view(handle, native.cleft_mesh_tet_labels(handle), (native.cleft_mesh_tet_count(handle),), np.int32)

    @property
    def different_labels(self) -> npt.NDArray[np.int32]:
        """The labels that occur, ascending; a view."""
        handle = self._native
        return view(handle, native.cleft_mesh_labels(handle), (native.cleft_mesh_label_count(handle),), np.int32)

    def copy_tets(self, index_base: int = 0) -> npt.NDArray[np.int32]:
        """A copy of the corners, counted from `index_base`, 0 or 1."""
        handle = self._native
        corners = np.empty((native.cleft_mesh_tet_count(handle), 4), np.int32)
        raise_for(native.cleft_mesh_copy_tets(handle, index_base, corners, corners.size), "index_base must be 0 or 1")
        return corners

    def quadratic(self, index_base: int = 0) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int32]]:
        """Points and ten-node tetrahedra: after the corners the middles of the edges 01, 12, 02, 03, 13, 23."""
        handle = self._native
        count = np.zeros(1, np.int64)
        wrong = "index_base must be 0 or 1"
        raise_for(native.cleft_mesh_copy_quadratic(handle, index_base, None, 0, None, 0, count), wrong)
        points = np.empty((count[0], 3))
        tets = np.empty((native.cleft_mesh_tet_count(handle), 10), np.int32)
        raise_for(
            native.cleft_mesh_copy_quadratic(handle, index_base, points, points.size, tets, tets.size, count), wrong
        )
        return points, tets

    def quality(self, *, mesher: Mesher | None = None) -> Quality:
        """The shape of the tetrahedra in figures."""
        struct = native.NativeQuality()
        mesher_or_plain(mesher)._call(native.cleft_mesh_quality, self._native, struct)
        return from_struct(Quality, struct, dihedral_histogram=tuple(struct.histogram_bin(bin) for bin in range(36)))

    def metric_quality(self, sizing: Sizing, *, mesher: Mesher | None = None) -> MetricQuality:
        """How well the mesh meets the metric of a sizing field."""
        struct, metric = native.NativeMetricQuality(), required(sizing, Sizing, "sizing")
        mesher_or_plain(mesher)._call(native.cleft_mesh_metric_quality, self._native, metric, struct)
        histogram = tuple(struct.histogram_bin(bin) for bin in range(36))
        return from_struct(MetricQuality, struct, dihedral_histogram=histogram)

    def validate(self, *, fills_box: bool = False, mesher: Mesher | None = None) -> Validation:
        """Looks for faults. With `fills_box`, the mesh is also asked to fill its bounding box."""
        struct = native.NativeValidation()
        worker = mesher_or_plain(mesher)
        worker._call(native.cleft_mesh_validate, self._native, int(true_or_false(fills_box, "fills_box")), struct)
        return from_struct(Validation, struct, first_fault="" if struct.valid else worker._sentence())

    def surface(self, *, mesher: Mesher | None = None) -> Surface:
        """The triangles between labels, and those of the hull."""
        return Surface(self._native, mesher_or_plain(mesher))

    def report(self, volume: Volume, *, distances: bool = False, mesher: Mesher | None = None) -> Report:
        """What became of each label of the volume, and `contacts`; for a mesh that was not stripped.

        With `distances`, also how far each interface is from that of the volume.
        """
        with_distances = true_or_false(distances, "distances")
        create = native.cleft_report_create_with_distances if with_distances else native.cleft_report_create
        address = mesher_or_plain(mesher)._call(create, required(volume, Volume, "volume"), self._native)
        handle = Handle(address, native.cleft_report_destroy)
        report = Report()
        for index in range(native.cleft_report_count(handle)):
            struct = native.NativeLabelReport()
            raise_for(native.cleft_report_label(handle, index, struct), "no such row")
            report.append(from_struct(LabelReport, struct))
        for index in range(native.cleft_report_contact_count(handle)):
            struct = native.NativeContact()
            raise_for(native.cleft_report_contact(handle, index, struct), "no such contact")
            report.contacts.append(from_struct(Contact, struct))
        for index in range(native.cleft_report_distance_count(handle)):
            struct = native.NativeDistance()
            raise_for(native.cleft_report_distance(handle, index, struct), "no such distance")
            report.distances.append(from_struct(Distance, struct))
        return report

    def write(self, path: str | os.PathLike[str], format: str | None = None, *, mesher: Mesher | None = None) -> None:
        """Writes a file, all or nothing; `format` is one of `cleft.formats()`, or None for that of the extension."""
        from . import files

        files.write_mesh(self, path, format, mesher=mesher)

    def render(self, path: str | os.PathLike[str], **keywords: Any) -> None:
        """Draws the mesh as PNG, without a screen; the keywords are those of `cleft.write_picture()`."""
        from . import files

        files.write_picture(self, path, **keywords)

    def view(self, **keywords: Any) -> View:
        """A page that shows the mesh, in a notebook at once; the keywords are those of `cleft.write_view()`."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "view.html")
            write_view(self, path, **keywords)
            with open(path, encoding="utf-8", newline="") as file:
                return View(file.read())

    def to_meshio(self) -> meshio.Mesh:
        """A meshio.Mesh with the labels as the cell data "material"; needs meshio."""
        import meshio

        return meshio.Mesh(
            self.points.copy(), [("tetra", self.tets.copy())], cell_data={"material": [self.labels.copy()]}
        )

    def plot(self, labels: Sequence[int] | None = None, **keywords: Any) -> Any:
        """Draws the mesh with pyvista, or matplotlib, whichever there is; see `cleft.plotting.plot()`."""
        from . import plotting

        return plotting.plot(self, labels, **keywords)

    def __repr__(self) -> str:
        if self.closed:
            return "Mesh(closed)"
        return f"<Mesh of {len(self.points)} points, {len(self.tets)} tetrahedra, {len(self.different_labels)} labels>"


@lists_options
def mesh(
    volume: Volume,
    *,
    sizing: Sizing | None = None,
    background_mesh: Mesh | None = None,
    mesher: Mesher | None = None,
    options: Options | None = None,
    **keywords: Unpack[OptionKeywords],
) -> Mesh:
    """Meshes a volume: sizing (unless given), background mesh (unless given), cleaving, improving, stripping.

        mesh = cleft.mesh(volume, size_max=3.0, strip=[0])

    If both are given, the background mesh is adapted to the metric of the sizing field.
    `smooth` is an option of the volume: give it to Volume() or read_volume().
    """
    chosen = options_of(options, keywords)
    return Mesh._adopt(
        mesher_or_plain(mesher)._call(
            native.cleft_mesh_volume,
            required(volume, Volume, "volume"),
            native_of(sizing, Sizing, "sizing"),
            native_of(background_mesh, Mesh, "background_mesh"),
            chosen._native if chosen else None,
        )
    )


@lists_options
def estimate(
    volume: Volume,
    *,
    sizing: Sizing | None = None,
    background_mesh: Mesh | None = None,
    mesher: Mesher | None = None,
    options: Options | None = None,
    **keywords: Unpack[OptionKeywords],
) -> Estimate:
    """What mesh() will come to with the same arguments: tetrahedra, within 15 %, and memory. No mesh is made."""
    chosen = options_of(options, keywords)
    struct = native.NativeEstimate()
    mesher_or_plain(mesher)._call(
        native.cleft_mesh_estimate,
        required(volume, Volume, "volume"),
        native_of(sizing, Sizing, "sizing"),
        native_of(background_mesh, Mesh, "background_mesh"),
        chosen._native if chosen else None,
        struct,
    )
    return from_struct(Estimate, struct)


def make_background(
    sizing: Sizing, *, mesher: Mesher | None = None, options: Options | None = None, **keywords: Unpack[OptionKeywords]
) -> Mesh:
    """The background mesh of a sizing field, of the kind of the option `background`: it fills the box, all label 0."""
    chosen = options_of(options, keywords)
    return Mesh._adopt(
        mesher_or_plain(mesher)._call(
            native.cleft_background_create, required(sizing, Sizing, "sizing"), chosen._native if chosen else None
        )
    )


def cleave(
    volume: Volume,
    background_mesh: Mesh,
    *,
    mesher: Mesher | None = None,
    options: Options | None = None,
    **keywords: Unpack[OptionKeywords],
) -> Mesh:
    """Cleaves a background mesh along the interfaces of a volume."""
    chosen = options_of(options, keywords)
    return Mesh._adopt(
        mesher_or_plain(mesher)._call(
            native.cleft_mesh_cleave,
            required(volume, Volume, "volume"),
            required(background_mesh, Mesh, "background_mesh"),
            chosen._native if chosen else None,
        )
    )


def improve(
    volume: Volume,
    cleaved: Mesh,
    *,
    mesher: Mesher | None = None,
    options: Options | None = None,
    **keywords: Unpack[OptionKeywords],
) -> Mesh:
    """Raises the worst dihedral angles of a cleaved mesh of this volume."""
    chosen = options_of(options, keywords)
    return Mesh._adopt(
        mesher_or_plain(mesher)._call(
            native.cleft_mesh_improve,
            required(volume, Volume, "volume"),
            required(cleaved, Mesh, "cleaved"),
            chosen._native if chosen else None,
        )
    )


def strip_labels(
    whole: Mesh, *, mesher: Mesher | None = None, options: Options | None = None, **keywords: Unpack[OptionKeywords]
) -> Mesh:
    """The mesh without the labels that the options `strip` and `only` leave out."""
    chosen = options_of(options, keywords)
    return Mesh._adopt(
        mesher_or_plain(mesher)._call(
            native.cleft_mesh_strip, required(whole, Mesh, "whole"), chosen._native if chosen else None
        )
    )
