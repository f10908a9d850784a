"""A page that shows a mesh, in a notebook or in a file."""
from __future__ import annotations

import html
import json
import os
from typing import TYPE_CHECKING, Any, Mapping

from ._arrays import real_number, whole_number
from ._handle import native_of, required
from ._paths import Path, path_bytes, writing
from .errors import InvalidArgument
from .mesher import Mesher, mesher_or_plain

if TYPE_CHECKING:
    from .meshes import Mesh


class View:
    """A page of HTML, which a notebook shows. It needs no network."""

    def __init__(self, page: str) -> None:
        self.html = page

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the page into a file, for a browser."""
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(self.html)

    def _repr_html_(self) -> str:
        # In a frame of its own, so that the page and the notebook do not change each other.
        return (
            f'<iframe srcdoc="{html.escape(self.html)}" sandbox="allow-scripts allow-downloads" title="Mesh" '
            'width="100%" height="640" style="border: 0"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<View: a page of {len(self.html) / 1e6:.1f} MB>"


def write_view(
    mesh: Mesh,
    path: Path,
    *,
    title: str = "",
    report: Mapping[str, Any] | str | None = None,
    names: Path | None = None,
    goal: float = 0,
    max_tets: int = 0,
    other: Mesh | None = None,
    other_title: str = "",
    other_report: Mapping[str, Any] | str | None = None,
    mesher: Mesher | None = None,
) -> None:
    """Writes a page of HTML that shows a mesh in any browser, in one file that needs no network.

    `report`: what `cleft mesh --json` reported, as text or as read by json. `names`: a table of the names of labels.
    `goal`: the least dihedral angle that is marked, in degrees; 0 for that of the report, else 25. `max_tets`: how many
    tetrahedra the page has at most; 0 for 3,000,000. `other`: a second mesh to compare with.
    """
    from .files import _io
    from .meshes import Mesh

    arguments = (
        required(mesh, Mesh, "mesh"),
        whole_number(max_tets, "max_tets", 0, 2**62),
        real_number(goal, "goal"),
        _closed(title, "title"),
        _closed(_json(report), "report"),
        b"\0" if names is None else path_bytes(names),
        native_of(other, Mesh, "other"),
        _closed(other_title, "other_title"),
        _closed(_json(other_report), "other_report"),
    )
    with writing(path):
        mesher_or_plain(mesher)._call(_io().cleft_io_write_view, *arguments, path_bytes(path))


def _json(report: Mapping[str, Any] | str | None) -> str:
    return "" if report is None else report if isinstance(report, str) else json.dumps(report)


def _closed(text: str, name: str) -> bytes:
    """A text as the library reads it."""
    if not isinstance(text, str):
        raise TypeError(f"{name} must be a text, not {type(text).__name__}")
    if "\0" in text:
        raise InvalidArgument(f"{name} has a zero character in it")
    return text.encode("utf-8", "replace") + b"\0"
