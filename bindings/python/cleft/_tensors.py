"""Tensors of metrics that come in, turned into the six numbers each that the library reads."""
from __future__ import annotations

from typing import Any

import numpy as np

from ._arrays import unmasked
from .errors import InvalidArgument

# How far opposite entries may differ, relative to the greatest one: what rounding in single precision makes.
_ROUNDING = 1e-5


def metric_tensors(values: Any, name: str, shape: tuple[int, ...]) -> np.ndarray[Any, Any]:
    """Six numbers for each voxel, x fastest, in the memory order of the library. `shape` is () for a single tensor."""
    array = unmasked(values, name)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be real numbers, not {array.dtype}")
    if array.shape not in (shape + (6,), shape + (3, 3)):
        raise InvalidArgument(f"{name} has the shape {array.shape}; it must be {shape + (6,)} or {shape + (3, 3)}")
    array = np.asarray(array, np.float32 if array.dtype in (np.float16, np.float32) else np.float64)
    if array.shape == shape + (3, 3):
        _check_symmetric(array, name)
        array = array[..., (0, 0, 0, 1, 1, 2), (0, 1, 2, 1, 2, 2)]
    return np.ascontiguousarray(array.transpose(tuple(range(len(shape)))[::-1] + (-1,)))


def _check_symmetric(matrices: np.ndarray[Any, Any], name: str) -> None:
    """NaN and infinity pass: the library names their voxel."""
    for row, column in ((0, 1), (0, 2), (1, 2)):
        upper, lower = matrices[..., row, column], matrices[..., column, row]
        with np.errstate(invalid="ignore"):
            wrong = np.abs(upper - lower) > _ROUNDING * np.abs(matrices).max(axis=(-2, -1))
        if wrong.any():
            first = [int(n) for n in np.unravel_index(np.argmax(wrong), wrong.shape)]
            one, other = float(upper[tuple(first)]), float(lower[tuple(first)])
            raise InvalidArgument(
                f"{name}{first or ''} is not symmetric: "
                f"its [{row}, {column}] is {one!r}, but [{column}, {row}] is {other!r}"
            )
