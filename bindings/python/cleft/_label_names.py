"""Names of labels, which volumes and meshes may have."""
from __future__ import annotations

import types
import unicodedata
from typing import Any, Callable, ClassVar, Mapping

from ._handle import Owner
from ._paths import Path, path_bytes, reading
from .errors import InvalidArgument, raise_for
from .mesher import Mesher, mesher_or_plain


class Named(Owner):
    """Base of what has labels with names."""

    _get_name: ClassVar[Callable[[Any, int], str]]
    _set_name: ClassVar[Callable[[Any, int, str], int]]
    _read_names: ClassVar[str]  # a function of native_io

    def _own_labels(self) -> list[int]:
        raise NotImplementedError

    @property
    def label_names(self) -> Mapping[int, str]:
        """{label: name} of the labels that have a name. Assign another dictionary to replace all names.

        A name is one line of text. Files keep names where their format can, and meshes have those of their volume.
        """
        handle, get = self._native, type(self)._get_name
        names = {label: get(handle, label) for label in self._own_labels()}
        return types.MappingProxyType({label: name for label, name in names.items() if name})

    @label_names.setter
    def label_names(self, names: Mapping[int, str]) -> None:
        handle, put = self._native, type(self)._set_name
        if not isinstance(names, Mapping):
            raise TypeError(f"label_names must be a dictionary from labels to names, not {names!r}")
        known = self._own_labels()
        for label, name in names.items():
            if not isinstance(name, str):
                raise TypeError(f"the name of label {label} must be a text, not {type(name).__name__}")
            if label not in known:
                raise InvalidArgument(f"there is no label {label}, which is to be called {name!r}")
            if any(unicodedata.category(letter) in ("Cc", "Cs") for letter in name):
                raise InvalidArgument(
                    f"the name of label {label} must be one line without control characters: {name!r}"
                )
        for label in known:
            raise_for(put(handle, label, names.get(label, "")), f"label {label} cannot be called {names.get(label)!r}")

    def read_label_names(self, path: Path, *, mesher: Mesher | None = None) -> None:
        """Names the labels by a table: label and name a line, or a table of ITK-SNAP, FreeSurfer, MRIcron or BIDS.

        Labels that are not in the table keep their names.
        """
        from .files import _io

        handle, name = self._native, path_bytes(path)
        with reading(path):
            mesher_or_plain(mesher)._call(getattr(_io(), type(self)._read_names), name, handle)
