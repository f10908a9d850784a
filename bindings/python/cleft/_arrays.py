"""What comes in: arrays of any order and type, turned into those that the library reads."""
from __future__ import annotations

import operator
from typing import Any, Sequence

import numpy as np

from . import native
from .errors import InvalidArgument, NotFinite

_TYPES = {
    np.dtype(np.uint8): native.CLEFT_TYPE_UINT8,
    np.dtype(np.uint16): native.CLEFT_TYPE_UINT16,
    np.dtype(np.int16): native.CLEFT_TYPE_INT16,
    np.dtype(np.uint32): native.CLEFT_TYPE_UINT32,
    np.dtype(np.int32): native.CLEFT_TYPE_INT32,
    np.dtype(np.float32): native.CLEFT_TYPE_FLOAT32,
    np.dtype(np.float64): native.CLEFT_TYPE_FLOAT64,
}
_BY_NAME = {
    "uint8": np.uint8,
    "uint16": np.uint16,
    "int16": np.int16,
    "uint32": np.uint32,
    "int32": np.int32,
    "float32": np.float32,
    "float64": np.float64,
}


def type_of(array: np.ndarray[Any, Any]) -> int:
    """The library's number for the type of an array."""
    return _TYPES[array.dtype]


def type_named(name: str) -> int:
    """The library's number for "uint8", "float32" ..."""
    if name not in _BY_NAME:
        raise InvalidArgument(f"type is {name!r}; it must be one of {', '.join(_BY_NAME)}")
    return _TYPES[np.dtype(_BY_NAME[name])]


def unmasked(values: Any, name: str) -> np.ndarray[Any, Any]:
    """An array; TypeError if something of it is masked."""
    if np.ma.is_masked(values):
        raise TypeError(f"{name} is masked; say what the masked values are, by {name}.filled()")
    return np.asarray(values)


def int32_array(values: Any, name: str) -> np.ndarray[Any, Any]:
    """Whole numbers as contiguous int32; OverflowError for those that do not fit."""
    array = unmasked(values, name)
    if array.size == 0:
        return np.zeros(array.shape, np.int32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} must be whole numbers, not {array.dtype}")
    limits = np.iinfo(np.int32)
    if array.dtype.itemsize >= 4 and (array.min() < limits.min or array.max() > limits.max):
        raise OverflowError(f"{name} must fit into 32 bits")
    return np.ascontiguousarray(array, np.int32)


def float_array(values: Any, name: str) -> np.ndarray[Any, Any]:
    """Numbers as contiguous double."""
    array = unmasked(values, name)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be real numbers, not {array.dtype}")
    return np.ascontiguousarray(array, np.float64)


def rows(array: np.ndarray[Any, Any], width: int, name: str) -> np.ndarray[Any, Any]:
    """The array, if it is shaped (n, width)."""
    if array.ndim != 2 or array.shape[1] != width:
        raise InvalidArgument(f"{name} has the shape {array.shape}; it must be (n, {width})")
    return array


def _volume_shaped(values: Any, name: str) -> np.ndarray[Any, Any]:
    array = unmasked(values, name)
    if array.dtype.kind not in "biuf":
        found = type(values).__name__ if array.ndim == 0 else f"an array of {array.dtype}"
        raise TypeError(f"{name} must be an array of real numbers, not {found}")
    if array.ndim == 2:
        raise InvalidArgument(f"{name} has two dimensions; {name}[:, :, None] makes one slice of a volume of it")
    if array.ndim != 3:
        raise InvalidArgument(f"{name} has {array.ndim} dimensions; it must have three: [i, j, k]")
    if 0 in array.shape:
        raise InvalidArgument(f"{name} has the shape {array.shape}: there are no voxels")
    return array


def _check_whole(array: np.ndarray[Any, Any]) -> None:
    """Labels may be stored as real numbers, as nibabel's get_fdata() does: each must then be a whole one."""
    wrong = ~np.isfinite(array) | (array != np.rint(array))
    if not wrong.any():
        return
    first = [int(n) for n in np.unravel_index(np.argmax(wrong), array.shape)]
    value = float(array[tuple(first)])
    if not np.isfinite(value):
        raise NotFinite(f"labels{first} is {value!r}; labels must be whole numbers")
    raise InvalidArgument(
        f"labels{first} is {value!r}, which is not whole: give numpy.rint(labels) if inexact storage made it so, or "
        "Volume.from_indicators([labels]) if it is a signed function"
    )


def label_voxels(values: Any) -> np.ndarray[Any, Any]:
    """A label map as the library reads it: one of its whole-number types, native byte order, x fastest in memory."""
    array = _volume_shaped(values, "labels")
    kind = array.dtype.newbyteorder("=")
    if kind == bool:
        kind = np.dtype(np.uint8)
    elif kind == np.int8:
        kind = np.dtype(np.int16)
    elif kind.kind == "f" or kind not in _TYPES:
        if kind.kind == "f":
            _check_whole(array)
        limits = np.iinfo(np.int32)
        if array.min() < limits.min or array.max() > limits.max:
            raise OverflowError("labels must fit into 32 bits")
        kind = np.dtype(np.int32)
    return np.asfortranarray(array, kind)


def real_voxels(values: Any, name: str) -> np.ndarray[Any, Any]:
    """A field of real numbers as the library reads it: float or double, x fastest in memory."""
    array = _volume_shaped(values, name)
    return np.asfortranarray(
        array, np.float32 if array.dtype.itemsize <= 2 or array.dtype == np.float32 else np.float64
    )


def field_list(fields: Any) -> list[np.ndarray[Any, Any]]:
    """The arrays of indicator functions, of one shape and type."""
    if isinstance(fields, np.ndarray):
        raise TypeError(
            f"fields must be a list of arrays [i, j, k], not an array of {fields.ndim} dimensions: list(fields) if its "
            "first index counts functions, list(numpy.moveaxis(fields, -1, 0)) if its last does, [fields] for a single "
            "one"
        )
    arrays = [real_voxels(field, f"fields[{n}]") for n, field in enumerate(fields)]
    if not arrays:
        raise InvalidArgument("fields is empty; there must be at least one indicator function")
    for n, array in enumerate(arrays):
        if array.shape != arrays[0].shape:
            raise InvalidArgument(f"fields[{n}] has the shape {array.shape}, but fields[0] has {arrays[0].shape}")
    if any(array.dtype != arrays[0].dtype for array in arrays):
        arrays = [array.astype(np.float64, order="F") for array in arrays]
    return arrays


def whole_number(value: Any, name: str, least: int, greatest: int) -> int:
    """A whole number for the library, which has so many bits for it; OverflowError beyond."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be a whole number, not {value!r}") from None
    if not least <= number <= greatest:
        raise OverflowError(f"{name} is {number}, which is not within {least} to {greatest}")
    return number


def dims_of(array: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """The numbers of voxels, for the library."""
    return np.array(array.shape, np.int64)


def buffer_of(array: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """The same memory, seen in C order, as a buffer must be."""
    return array.T


def world_matrix(spacing: Sequence[float] | None, origin: Sequence[float] | None, affine: Any) -> Any:
    """The 3 x 4 matrix from voxel indices to the world, or None for the library's default."""
    if affine is not None:
        if spacing is not None or origin is not None:
            raise TypeError("give either affine, or spacing and origin")
        matrix = float_array(affine, "affine")
        if matrix.shape not in ((3, 4), (4, 4)):
            raise InvalidArgument(f"affine has the shape {matrix.shape}; it must be (3, 4) or (4, 4)")
        if not np.isfinite(matrix).all():
            raise NotFinite("affine must be finite")
        if matrix.shape == (4, 4) and not np.array_equal(matrix[3], (0, 0, 0, 1)):
            raise InvalidArgument("the last row of affine must be 0 0 0 1")
        return np.ascontiguousarray(matrix[:3])
    if spacing is None and origin is None:
        return None
    lengths = triple((1, 1, 1) if spacing is None else spacing, "spacing")
    if not (lengths > 0).all():
        raise InvalidArgument("spacing must be above 0 along each axis")
    first = lengths / 2 if origin is None else triple(origin, "origin")
    return np.column_stack((np.diag(lengths), first))


def real_number(value: Any, name: str) -> float:
    """A single number; TypeError, which names the argument, for what is none, texts among them."""
    try:
        if not isinstance(value, (str, bytes)) and np.ndim(value) == 0:
            return float(value)
    except TypeError:
        pass
    raise TypeError(f"{name} must be a number, not {value!r}")


def true_or_false(value: Any, name: str) -> bool:
    """A truth value of Python or of numpy, or 1 or 0."""
    if isinstance(value, (bool, np.bool_)) or isinstance(value, (int, np.integer)) and value in (0, 1):
        return bool(value)
    raise TypeError(f"{name} must be True or False, not {value!r}")


def triple(values: Any, name: str) -> np.ndarray[Any, Any]:
    """Three finite numbers."""
    array = float_array(values, name)
    if array.shape != (3,):
        raise InvalidArgument(f"{name} must be three numbers")
    if not np.isfinite(array).all():
        raise NotFinite(f"{name} must be finite")
    return array


def affine_from(read: Any) -> np.ndarray[Any, Any]:
    """The 4 x 4 matrix of an object of the library, read by `read(buffer)`."""
    matrix = np.eye(4)
    upper = np.zeros((3, 4))
    read(upper)
    matrix[:3] = upper
    return matrix
