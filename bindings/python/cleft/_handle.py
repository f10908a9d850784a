"""What owns the library's objects: a Handle, shared by the Python object and by the arrays that look into its memory.
"""
from __future__ import annotations

from typing import Any, Callable, TypeVar

import numpy as np

from .errors import Closed

_Self = TypeVar("_Self", bound="Owner")


class Handle:
    """The address of an object of the library, which is destroyed when the last reference to this handle is gone."""

    __slots__ = ("address", "_destroy", "__weakref__")

    def __init__(self, address: int, destroy: Callable[[Any], None]) -> None:
        self.address = address
        self._destroy = destroy

    def __del__(self) -> None:
        self._destroy(self)

    def __reduce__(self) -> Any:
        raise TypeError("objects of cleft cannot be pickled; take their arrays")


class Owner:
    """Base of the classes that own an object of the library: a context manager with close()."""

    _handle: Handle | None = None

    @property
    def _native(self) -> Handle:
        if self._handle is None:
            raise Closed(f"this {type(self).__name__} is closed")
        return self._handle

    @property
    def closed(self) -> bool:
        """Has close() been called?"""
        return self._handle is None

    def close(self) -> None:
        """Gives the object up. Its memory is freed when the last array that looks into it is gone too."""
        self._handle = None

    def __enter__(self: _Self) -> _Self:
        self._native  # closed objects cannot be entered
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()


def native_of(owner: Owner | None, kind: type[Owner], name: str) -> Handle | None:
    """The handle of an argument, or None for None; TypeError if it is something else."""
    if owner is None:
        return None
    if not isinstance(owner, kind):
        raise TypeError(f"{name} must be a {kind.__name__}, not {type(owner).__name__}")
    return owner._native


def required(owner: Owner, kind: type[Owner], name: str) -> Handle:
    """The handle of an argument that must be there."""
    handle = native_of(owner, kind, name)
    if handle is None:
        raise TypeError(f"{name} must be a {kind.__name__}, not None")
    return handle


class _Memory:
    """Memory of the library that numpy can look into; numpy keeps this, and this keeps the handle."""

    __slots__ = ("_handle", "__array_interface__")

    def __init__(self, handle: Handle, address: int, shape: tuple[int, ...], kind: Any) -> None:
        self._handle = handle
        self.__array_interface__ = {
            "version": 3,
            "data": (address, True),
            "shape": shape,
            "typestr": np.dtype(kind).str,
        }


def view(handle: Handle, address: int | None, shape: tuple[int, ...], kind: Any) -> np.ndarray[Any, Any]:
    """A read-only array over memory that the handle keeps alive, without a copy."""
    if not address or 0 in shape:
        array = np.empty(shape, kind)
        array.flags.writeable = False
        return array
    return np.asarray(_Memory(handle, address, shape, kind))
