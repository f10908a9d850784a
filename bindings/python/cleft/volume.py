"""The labelled volume."""
from __future__ import annotations

from typing import Any, Sequence, Unpack

import numpy as np
import numpy.typing as npt

from . import native
from ._arrays import (
    affine_from,
    buffer_of,
    dims_of,
    field_list,
    float_array,
    int32_array,
    label_voxels,
    rows,
    type_of,
    world_matrix,
)
from ._handle import Handle, view
from ._label_names import Named
from .errors import InvalidArgument, raise_for
from .mesher import Mesher, mesher_or_plain
from .options import OptionKeywords, Options, options_of_volume


class Volume(Named):
    """A label map: Volume(labels, spacing=(0.5, 0.5, 2.0), origin=(0, 0, 0)).

    `labels[i, j, k]` is the label of voxel (i, j, k), in a numpy array of any memory order and type of whole numbers; a
    bool array has the labels 0 and 1, and real numbers are taken where all of them are whole. i runs along x: that is
    the order of nibabel and of affine matrices. Arrays in the order [k, j, i] (SimpleITK, imageio, tifffile) come as
    `labels.transpose(2, 1, 0)`, which costs nothing. The voxels are copied.

    Where the voxels are in the world: `affine`, a (3, 4) or (4, 4) matrix that maps indices to world coordinates, or
    `spacing` and `origin`, the centre of voxel (0, 0, 0). Without an origin the corner of the box is at zero.

    Of the options, `smooth` is read: Volume(labels, smooth=3), or the same `options` as the mesh's.

    `label_names` gives names to labels.
    """

    _get_name = staticmethod(native.cleft_volume_label_name)
    _set_name = staticmethod(native.cleft_volume_set_label_name)
    _read_names = "cleft_io_read_volume_names"

    def _own_labels(self) -> list[int]:
        return self.labels.tolist()

    def __init__(
        self,
        labels: npt.ArrayLike,
        *,
        spacing: Sequence[float] | None = None,
        origin: Sequence[float] | None = None,
        affine: npt.ArrayLike | None = None,
        mesher: Mesher | None = None,
        options: Options | None = None,
        **keywords: Unpack[OptionKeywords],
    ) -> None:
        voxels = label_voxels(labels)
        matrix = world_matrix(spacing, origin, affine)
        chosen = options_of_volume(options, keywords)
        address = mesher_or_plain(mesher)._call(
            native.cleft_volume_create_labels,
            type_of(voxels),
            buffer_of(voxels),
            dims_of(voxels),
            matrix,
            chosen._native if chosen else None,
        )
        self._handle = Handle(address, native.cleft_volume_destroy)

    @classmethod
    def _adopt(cls, address: int) -> Volume:
        volume = cls.__new__(cls)
        volume._handle = Handle(address, native.cleft_volume_destroy)
        return volume

    @classmethod
    def from_indicators(
        cls,
        fields: Sequence[npt.ArrayLike],
        labels: Sequence[int] | None = None,
        *,
        spacing: Sequence[float] | None = None,
        origin: Sequence[float] | None = None,
        affine: npt.ArrayLike | None = None,
        mesher: Mesher | None = None,
    ) -> Volume:
        """A volume of indicator functions, one array [i, j, k] of real numbers for each material; the greatest wins.

        A single one is a signed function, inside where it is above 0. `labels` are what the materials are called: as
        many as there are functions (two for a single one, the outside first); 0, 1, 2 ... without them.
        """
        arrays = field_list(fields)
        names = None if labels is None else int32_array(labels, "labels")
        wanted = len(arrays) if len(arrays) > 1 else 2
        if names is not None and names.shape != (wanted,):
            raise InvalidArgument(f"labels has the shape {names.shape}; there must be {wanted}")
        addresses = np.array([array.ctypes.data for array in arrays], np.uintp)
        return cls._adopt(
            mesher_or_plain(mesher)._call(
                native.cleft_volume_create_indicators,
                type_of(arrays[0]),
                addresses,
                dims_of(arrays[0]),
                world_matrix(spacing, origin, affine),
                names,
            )
        )

    @property
    def shape(self) -> tuple[int, int, int]:
        """Voxels along x, y and z."""
        dims = np.zeros(3, np.int64)
        raise_for(native.cleft_volume_dims(self._native, dims), "the volume cannot be read")
        return int(dims[0]), int(dims[1]), int(dims[2])

    @property
    def affine(self) -> npt.NDArray[np.float64]:
        """The 4 x 4 matrix from voxel indices to world coordinates."""
        handle = self._native
        return affine_from(lambda to: raise_for(native.cleft_volume_affine(handle, to), "the volume cannot be read"))

    @property
    def labels(self) -> npt.NDArray[np.int32]:
        """The label of each material; a view."""
        handle = self._native
        return view(handle, native.cleft_volume_labels(handle), (native.cleft_volume_label_count(handle),), np.int32)

    @property
    def indicator_count(self) -> int:
        """Indicator functions: 1 for a signed function, 0 for a label map. Tells what a file was taken for."""
        return int(native.cleft_volume_indicator_count(self._native))

    @property
    def voxel_counts(self) -> dict[int, int]:
        """How many voxels each label has."""
        labels = self.labels
        counts = np.zeros(len(labels), np.int64)
        raise_for(native.cleft_volume_copy_voxel_counts(self._native, counts, len(counts)), "no counts")
        return dict(zip(labels.tolist(), counts.tolist()))

    def sample(self, points: npt.ArrayLike) -> npt.NDArray[np.int32]:
        """The labels at world points, shaped (n, 3), as the mesh sees them."""
        places = rows(float_array(points, "points"), 3, "points")
        labels = np.zeros(len(places), np.int32)
        status = native.cleft_volume_sample(self._native, places, len(places), labels)
        raise_for(status, "points must be finite")
        return labels

    def __repr__(self) -> str:
        if self.closed:
            return "Volume(closed)"
        return f"<Volume of {' x '.join(map(str, self.shape))} voxels, {len(self.labels)} labels>"
