"""The sizing field: how long the edges are to be, at each point."""
from __future__ import annotations

from typing import Any, Sequence, Unpack

import numpy as np
import numpy.typing as npt

from . import native
from ._arrays import affine_from, buffer_of, real_number, real_voxels, triple, true_or_false, type_of
from ._handle import Handle, Owner, required, view
from ._tensors import metric_tensors
from .errors import InvalidArgument, raise_for
from .mesher import Mesher, mesher_or_plain
from .options import OptionKeywords, Options, options_of
from .volume import Volume


class Sizing(Owner):
    """The wanted edge length at each point, computed from the features of a volume: Sizing(volume, size_max=4.0).

    The options of sizes are read, and `tets`.
    """

    def __init__(
        self,
        volume: Volume,
        *,
        mesher: Mesher | None = None,
        options: Options | None = None,
        **keywords: Unpack[OptionKeywords],
    ) -> None:
        chosen = options_of(options, keywords)
        self._handle = Handle(
            mesher_or_plain(mesher)._call(
                native.cleft_sizing_create, required(volume, Volume, "volume"), chosen._native if chosen else None
            ),
            native.cleft_sizing_destroy,
        )

    @classmethod
    def _adopt(cls, address: int) -> Sizing:
        sizing = cls.__new__(cls)
        sizing._handle = Handle(address, native.cleft_sizing_destroy)
        return sizing

    @classmethod
    def constant(cls, volume: Volume, size: float, *, mesher: Mesher | None = None) -> Sizing:
        """One size everywhere."""
        return cls._adopt(
            mesher_or_plain(mesher)._call(
                native.cleft_sizing_create_constant, required(volume, Volume, "volume"), real_number(size, "size")
            )
        )

    @classmethod
    def from_values(
        cls,
        volume: Volume,
        values: npt.ArrayLike,
        *,
        combine: bool = False,
        mesher: Mesher | None = None,
        options: Options | None = None,
        **keywords: Unpack[OptionKeywords],
    ) -> Sizing:
        """A field of your own: `values[i, j, k]` above 0, one for each voxel of the volume.

        With `combine`, the lesser of it and of the computed field, for which the options are read.
        """
        handle = required(volume, Volume, "volume")
        array = real_voxels(values, "values")
        if array.shape != volume.shape:
            raise InvalidArgument(f"values has the shape {array.shape}; the volume has {volume.shape}")
        chosen = options_of(options, keywords)
        return cls._adopt(
            mesher_or_plain(mesher)._call(
                native.cleft_sizing_create_values,
                handle,
                type_of(array),
                buffer_of(array),
                int(true_or_false(combine, "combine")),
                chosen._native if chosen else None,
            )
        )

    @classmethod
    def constant_metric(cls, volume: Volume, metric: npt.ArrayLike, *, mesher: Mesher | None = None) -> Sizing:
        """One metric everywhere: xx, xy, xz, yy, yz, zz of the symmetric tensor, or its 3 x 3 matrix."""
        handle = required(volume, Volume, "volume")
        tensor = metric_tensors(metric, "metric", ()).astype(np.float64)
        return cls._adopt(mesher_or_plain(mesher)._call(native.cleft_sizing_create_constant_metric, handle, tensor))

    @classmethod
    def from_metric(
        cls,
        volume: Volume,
        metric: npt.ArrayLike,
        *,
        combine: bool = False,
        mesher: Mesher | None = None,
        options: Options | None = None,
        **keywords: Unpack[OptionKeywords],
    ) -> Sizing:
        """Wanted lengths that depend on the direction: an edge v is to have v @ M @ v = 1.

        `metric[i, j, k]` has xx, xy, xz, yy, yz, zz of the symmetric M of a voxel, or its 3 x 3 matrix. With `combine`,
        no length is greater than that of the computed field, for which the options are read.
        """
        handle = required(volume, Volume, "volume")
        tensors = metric_tensors(metric, "metric", volume.shape)
        chosen = options_of(options, keywords)
        return cls._adopt(
            mesher_or_plain(mesher)._call(
                native.cleft_sizing_create_metric,
                handle,
                type_of(tensors),
                tensors,
                int(true_or_false(combine, "combine")),
                chosen._native if chosen else None,
            )
        )

    @property
    def has_metric(self) -> bool:
        """Whether the wanted lengths depend on the direction."""
        return bool(native.cleft_sizing_has_metric(self._native))

    @property
    def metric(self) -> npt.NDArray[np.float32]:
        """metric[i, j, k] has xx, xy, xz, yy, yz, zz; a copy. InvalidArgument if the field has no metric."""
        tensors = np.zeros(self.shape[::-1] + (6,), np.float32)
        raise_for(native.cleft_sizing_copy_metric(self._native, tensors, tensors.size), "the field has no metric")
        return tensors.transpose(2, 1, 0, 3)

    @property
    def shape(self) -> tuple[int, int, int]:
        """Values along x, y and z."""
        dims = np.zeros(3, np.int64)
        raise_for(native.cleft_sizing_dims(self._native, dims), "the sizing field cannot be read")
        return int(dims[0]), int(dims[1]), int(dims[2])

    @property
    def affine(self) -> npt.NDArray[np.float64]:
        """The 4 x 4 matrix from indices to world coordinates."""
        handle = self._native
        return affine_from(lambda to: raise_for(native.cleft_sizing_affine(handle, to), "the field cannot be read"))

    @property
    def values(self) -> npt.NDArray[np.float32]:
        """values[i, j, k]; a view. With a metric, the lengths of regular tetrahedra that are as large."""
        handle = self._native
        return view(handle, native.cleft_sizing_values(handle), self.shape[::-1], np.float32).T

    @property
    def expected_tets(self) -> float:
        """Tetrahedra that a background of this field will have, within some 10 %."""
        return float(native.cleft_sizing_expected_tets(self._native))

    def at(self, point: Sequence[float]) -> float:
        """The field at a world point."""
        size = np.zeros(1)
        raise_for(native.cleft_sizing_at(self._native, triple(point, "point"), size), "the field cannot be read there")
        return float(size[0])

    def __repr__(self) -> str:
        return "Sizing(closed)" if self.closed else f"<Sizing of about {self.expected_tets:.0f} tetrahedra>"
