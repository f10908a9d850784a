"""Conforming multi-material tetrahedral meshes from labelled volumes, by mesh cleaving.

    import cleft, numpy as np
    labels = np.zeros((32, 32, 32), np.uint8)           # labels[i, j, k], i along x
    labels[8:24, 8:24, 8:24] = 1
    mesh = cleft.mesh(cleft.Volume(labels, spacing=(1, 1, 2)), size_max=4.0)
    mesh.points, mesh.tets, mesh.labels                 # numpy arrays that look into the mesh
    mesh.write("cube.vtu")
"""
from __future__ import annotations

try:
    from . import native as _native
except ImportError as _error:
    raise ImportError(
        f"the native library of cleft cannot be loaded: {_error}; it needs the Debian package libtet1.5"
    ) from _error
from .errors import (
    Busy,
    Cancelled,
    CleftError,
    CleftWarning,
    Closed,
    FileError,
    FileForbidden,
    FileIsFolder,
    FileMissing,
    FolderIsFile,
    FormatError,
    InternalError,
    InvalidArgument,
    InvalidMesh,
    LabelLost,
    NotFinite,
    OptionError,
    OutOfMemory,
    TooLarge,
    Unsupported,
)
from .files import (
    Format,
    formats,
    guess,
    read_field,
    read_mesh,
    read_raw,
    read_metric,
    read_sizing,
    read_volume,
    write_mesh,
    write_picture,
    write_sizing,
)
from .meshes import Mesh, cleave, estimate, improve, make_background, mesh, strip_labels
from .mesher import Mesher
from .options import OptionDescription, OptionKeywords, Options, option_table
from .results import Contact, Distance, Estimate, LabelReport, MetricQuality, Quality, Report, Validation
from .sizing import Sizing
from .surface import SIDES, Surface
from .views import View, write_view
from .volume import Volume

__version__: str = _native.cleft_version(None, None, None)
#: Is TetGen in this build, so that delaunay="tetgen" can be chosen?
has_tetgen: bool = bool(_native.cleft_has_tetgen())

__all__ = [
    "SIDES",
    "Busy",
    "Cancelled",
    "CleftError",
    "CleftWarning",
    "Closed",
    "Contact",
    "Distance",
    "Estimate",
    "FileError",
    "FileForbidden",
    "FileIsFolder",
    "FileMissing",
    "FolderIsFile",
    "Format",
    "FormatError",
    "InternalError",
    "InvalidArgument",
    "InvalidMesh",
    "LabelLost",
    "LabelReport",
    "Mesh",
    "Mesher",
    "MetricQuality",
    "NotFinite",
    "OptionDescription",
    "OptionError",
    "OptionKeywords",
    "Options",
    "OutOfMemory",
    "Quality",
    "Report",
    "Sizing",
    "Surface",
    "TooLarge",
    "Unsupported",
    "Validation",
    "View",
    "Volume",
    "cleave",
    "estimate",
    "formats",
    "guess",
    "has_tetgen",
    "improve",
    "make_background",
    "mesh",
    "option_table",
    "read_field",
    "read_mesh",
    "read_raw",
    "read_metric",
    "read_sizing",
    "read_volume",
    "strip_labels",
    "write_mesh",
    "write_picture",
    "write_sizing",
    "write_view",
]
