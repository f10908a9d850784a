"""A page that shows a mesh, in a notebook or in a file."""
from __future__ import annotations

import html
import os


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
