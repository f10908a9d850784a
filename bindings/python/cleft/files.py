"""Reading and writing files. The file component is loaded when the first of these functions is called."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Mapping, Sequence, Unpack

import numpy as np
import numpy.typing as npt

from . import native
from ._arrays import affine_from, int32_array, real_number, triple, true_or_false, type_named, whole_number
from ._handle import Handle, native_of, required, view
from ._paths import Path, path_bytes, path_list, reading, writing
from .errors import InvalidArgument, Unsupported, raise_for
from .mesher import Mesher, mesher_or_plain
from .options import OptionKeywords, Options, options_of, options_of_volume
from .sizing import Sizing
from .volume import Volume

if TYPE_CHECKING:
    from .meshes import Mesh


@dataclass(frozen=True)
class Format:
    """One row of the table of file formats."""

    name: str
    extensions: tuple[str, ...]
    text: str
    number: int
    reads_mesh: bool
    writes_mesh: bool
    reads_volume: bool
    writes_sizing: bool


def _io() -> Any:
    try:
        from . import native_io
    except ImportError as error:
        raise Unsupported(
            f"the file component cannot be loaded: {error}; it needs the Debian packages libgdcm3.0, libtiff6, "
            "libpng16-16, libjpeg62-turbo, libdeflate0 and zlib1g"
        ) from error
    return native_io


def formats() -> list[Format]:
    """The file formats that are read and written."""
    io = _io()
    table = []
    for index in range(io.cleft_io_format_count()):
        row = io.NativeFormatDescription()
        raise_for(io.cleft_io_format_info(index, row), "no such format")
        table.append(
            Format(
                row.name,
                tuple(row.extensions.split()),
                row.text,
                row.format,
                *(
                    bool(row.directions & bit)
                    for bit in (
                        io.CLEFT_IO_READS_MESH,
                        io.CLEFT_IO_WRITES_MESH,
                        io.CLEFT_IO_READS_VOLUME,
                        io.CLEFT_IO_WRITES_SIZING,
                    )
                ),
            )
        )
    return table


def guess(path: Path) -> str:
    """What a file most likely holds: "volume", "mesh" or "unknown"."""
    io = _io()
    kinds = {io.CLEFT_IO_VOLUME: "volume", io.CLEFT_IO_MESH: "mesh"}
    return kinds.get(io.cleft_io_guess(path_bytes(path)), "unknown")


def read_volume(
    path: Path | Sequence[Path],
    *,
    world: str = "LPS",
    kind: str = "auto",
    spacing: Sequence[float] | None = None,
    scale: float | None = None,
    mesher: Mesher | None = None,
    options: Options | None = None,
    **keywords: Unpack[OptionKeywords],
) -> Volume:
    """Reads a volume: NIfTI, NRRD, MetaImage, TIFF, a folder with a DICOM series ...; several paths: one a material.

    `world`: coordinates come out as "LPS" (ITK, DICOM, 3D Slicer's files) or "RAS" (NIfTI, nibabel). `kind`: "labels",
    "indicators" or "auto". `scale` multiplies the origin and the spacing of the file together: 0.001 makes metres of
    millimetres. `spacing`: lengths taken instead of the file's, 0 for the file's; the origin stays as it is.
    """
    io = _io()
    chosen = options_of_volume(options, keywords)
    paths = path_list(path)
    how = _reading(world, kind, spacing, scale)
    with reading(*paths, folders=True):
        return Volume._adopt(
            mesher_or_plain(mesher)._call(
                io.cleft_io_read_volume, chosen._native if chosen else None, b"".join(map(path_bytes, paths)), how
            )
        )


def read_raw(
    path: Path | Sequence[Path],
    shape: Sequence[int],
    type: str,
    *,
    big_endian: bool = False,
    skip: int = 0,
    spacing: Sequence[float] | None = None,
    kind: str = "auto",
    mesher: Mesher | None = None,
    options: Options | None = None,
    **keywords: Unpack[OptionKeywords],
) -> Volume:
    """Reads voxels without a header, x fastest; several paths: one a material.

    `type` is "uint8", "int16", "float32" ..., `skip` counts bytes. `kind` and several paths: as in read_volume().
    """
    io = _io()
    raw = io.NativeRaw()
    raw.type = type_named(type)
    raw.big_endian = int(true_or_false(big_endian, "big_endian"))
    raw.kind = _kind(kind)
    raw.skip = whole_number(skip, "skip", 0, 2**63 - 1)
    lengths = np.ones(3) if spacing is None else triple(spacing, "spacing")
    if not (lengths > 0).all():
        raise InvalidArgument(f"spacing is {spacing!r}; all three must be above 0")
    if np.shape(shape) != (3,):
        raise InvalidArgument(f"shape is {shape!r}; it must be three numbers of voxels")
    for axis in range(3):
        raw.set_axis(axis, whole_number(shape[axis], "shape", 1, 2**31 - 1), float(lengths[axis]))
    chosen = options_of_volume(options, keywords)
    paths = path_list(path)
    with reading(*paths):
        return Volume._adopt(
            mesher_or_plain(mesher)._call(
                io.cleft_io_read_raw, chosen._native if chosen else None, b"".join(map(path_bytes, paths)), raw
            )
        )


def read_field(
    path: Path,
    *,
    world: str = "LPS",
    spacing: Sequence[float] | None = None,
    scale: float | None = None,
    mesher: Mesher | None = None,
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Reads one number a voxel: values[i, j, k], and the 4 x 4 matrix from indices to the world."""
    io = _io()
    dims = np.zeros(3, np.int64)
    address: list[int] = []
    how = _reading(world, "auto", spacing, scale)

    def read(matrix: Any) -> None:
        address.append(mesher_or_plain(mesher)._call(io.cleft_io_read_field, path_bytes(path), how, dims, matrix))

    with reading(path, folders=True):
        affine = affine_from(read)
    handle = Handle(address[0], io.cleft_io_free)
    return view(handle, address[0], tuple(dims.tolist()[::-1]), np.float64).T, affine


def read_sizing(
    path: Path,
    volume: Volume,
    *,
    combine: bool = False,
    world: str = "LPS",
    spacing: Sequence[float] | None = None,
    scale: float | None = None,
    mesher: Mesher | None = None,
    options: Options | None = None,
    **keywords: Unpack[OptionKeywords],
) -> Sizing:
    """Reads a sizing field of your own from a file with the same voxels as the volume; see Sizing.from_values().

    Give the `world`, `spacing` and `scale` with which the volume was read. `scale` multiplies the edge lengths too.
    """
    io = _io()
    chosen = options_of(options, keywords)
    how = _reading(world, "auto", spacing, scale)
    with reading(path, folders=True):
        return Sizing._adopt(
            mesher_or_plain(mesher)._call(
                io.cleft_io_read_sizing,
                required(volume, Volume, "volume"),
                path_bytes(path),
                how,
                int(true_or_false(combine, "combine")),
                chosen._native if chosen else None,
            )
        )


def read_metric(
    path: Path,
    volume: Volume | None = None,
    *,
    order: str = "file",
    combine: bool = False,
    world: str = "LPS",
    spacing: Sequence[float] | None = None,
    scale: float | None = None,
    mesher: Mesher | None = None,
    options: Options | None = None,
    **keywords: Unpack[OptionKeywords],
) -> Sizing:
    """Reads a metric of your own from a file with the same voxels as the volume; see Sizing.from_metric().

    Without a volume, the field has the voxels of the file. `order` says how the numbers of a tensor follow each other:
    "file" (as the file says), "nrrd" (xx xy xz yy yz zz), "vtk" (xx yy zz xy yz xz) or "nifti" (xx xy yy xz yz zz).
    Give the `world`, `spacing` and `scale` with which the volume was read. `scale` multiplies the wanted lengths too.
    """
    io = _io()
    chosen = options_of(options, keywords)
    how = _reading(world, "auto", spacing, scale)
    with reading(path, folders=True):
        return Sizing._adopt(
            mesher_or_plain(mesher)._call(
                io.cleft_io_read_metric,
                native_of(volume, Volume, "volume"),
                path_bytes(path),
                how,
                _order(order),
                int(true_or_false(combine, "combine")),
                chosen._native if chosen else None,
            )
        )


def write_sizing(sizing: Sizing, path: Path, *, world: str = "LPS", mesher: Mesher | None = None) -> None:
    """Writes a sizing field as a volume of numbers, or of tensors; `world` is the one in which the volume was read."""
    io = _io()
    with writing(path):
        mesher_or_plain(mesher)._call(
            io.cleft_io_write_sizing, required(sizing, Sizing, "sizing"), path_bytes(path), _world(world)
        )


def read_mesh(path: Path, *, mesher: Mesher | None = None) -> Mesh:
    """Reads a mesh of tetrahedra: .vtu, .pvtu, .vtk, .vtkhdf, .mesh, .msh, .node with .ele."""
    from .meshes import Mesh

    with reading(path):
        return Mesh._adopt(mesher_or_plain(mesher)._call(_io().cleft_io_read_mesh, path_bytes(path)))


def write_mesh(mesh: Mesh, path: Path, format: str | None = None, *, mesher: Mesher | None = None) -> None:
    """Writes a mesh; `format` is a name of `cleft.formats()`, or None for that of the extension."""
    from .meshes import Mesh

    io = _io()
    number = io.CLEFT_FORMAT_BY_NAME
    if format is not None:
        numbers = {row.name: row.number for row in formats() if row.writes_mesh}
        if format not in numbers:
            raise InvalidArgument(f"format is {format!r}; it must be one of {', '.join(numbers)}")
        number = numbers[format]
    with writing(path):
        mesher_or_plain(mesher)._call(io.cleft_io_write_mesh, required(mesh, Mesh, "mesh"), path_bytes(path), number)


def write_picture(
    mesh: Mesh,
    path: Path,
    *,
    by: str = "label",
    size: tuple[int, int] = (1200, 900),
    cut: Mapping[str, float] | None = None,
    strip: Sequence[int] = (),
    whole: Sequence[int] = (),
    view: Sequence[float] | None = None,
    up: Sequence[float] | None = None,
    zoom: float = 1,
    edges: bool = True,
    line_width: float = 1,
    legend: bool = False,
    background: str = "light",
    range: tuple[float, float] | None = None,
    mesher: Mesher | None = None,
) -> None:
    """Draws a mesh as PNG, without a screen.

    `by`: "label", "angle", "ratio" or "size" gives the colour; `range` has the measures at its ends. `cut`: shares of
    the box, {"x": 0.5}; whole tetrahedra are taken away on the side of the eye, those in front of all cuts. `strip`:
    labels that are not drawn. `whole`: labels that are not cut. `view`: the direction to the eye. `background`:
    "light", "dark" or "none".
    """
    from .meshes import Mesh

    look = _look(by, background, size, zoom, line_width)  # a NativePicture
    look.no_edges = int(not true_or_false(edges, "edges"))
    look.legend = int(true_or_false(legend, "legend"))
    for axis, share in (cut or {}).items():
        look.set_cut(_choice(axis, "an axis of cut", {"x": 0, "y": 1, "z": 2}), real_number(share, "cut"))
    for name, values, put in (("view", view, look.set_view), ("up", up, look.set_up)):
        for axis, part in enumerate(() if values is None else triple(values, name)):
            put(axis, float(part))
    for end, measure in enumerate(() if range is None else _pair(range, "range")):
        look.set_range(end, real_number(measure, "range"))
    out, whole_ones = int32_array(strip, "strip"), int32_array(whole, "whole")
    of = required(mesh, Mesh, "mesh")
    with writing(path):
        mesher_or_plain(mesher)._call(
            _io().cleft_io_write_picture, of, out, len(out), whole_ones, len(whole_ones), look, path_bytes(path)
        )


def _look(by: str, background: str, size: tuple[int, int], zoom: float, line_width: float) -> Any:
    io = _io()
    look = io.NativePicture()
    numbers = {
        "label": io.CLEFT_IO_BY_LABEL,
        "angle": io.CLEFT_IO_BY_ANGLE,
        "ratio": io.CLEFT_IO_BY_RATIO,
        "size": io.CLEFT_IO_BY_SIZE,
    }
    look.by = _choice(by, "by", numbers)
    numbers = {
        "light": io.CLEFT_IO_BACKDROP_LIGHT,
        "dark": io.CLEFT_IO_BACKDROP_DARK,
        "none": io.CLEFT_IO_BACKDROP_NONE,
    }
    look.backdrop = _choice(background, "background", numbers)
    look.width, look.height = (whole_number(side, "size", 1, 2**31 - 1) for side in _pair(size, "size"))
    look.zoom = real_number(zoom, "zoom")
    look.line_width = real_number(line_width, "line_width")
    return look


def _pair(values: Any, name: str) -> Any:
    if np.shape(values) != (2,):
        raise InvalidArgument(f"{name} is {values!r}; it must be two numbers")
    return values


def _world(name: str) -> int:
    return _choice(name, "world", {"LPS": _io().CLEFT_IO_WORLD_LPS, "RAS": _io().CLEFT_IO_WORLD_RAS})


def _kind(name: str) -> int:
    io = _io()
    return _choice(
        name,
        "kind",
        {"auto": io.CLEFT_IO_KIND_AUTO, "labels": io.CLEFT_IO_KIND_LABELS, "indicators": io.CLEFT_IO_KIND_INDICATORS},
    )


def _order(name: str) -> int:
    io = _io()
    numbers = {
        "file": io.CLEFT_IO_ORDER_FILE,
        "nrrd": io.CLEFT_IO_ORDER_NRRD,
        "vtk": io.CLEFT_IO_ORDER_VTK,
        "nifti": io.CLEFT_IO_ORDER_NIFTI,
    }
    return _choice(name, "order", numbers)


def _reading(world: str, kind: str, spacing: Sequence[float] | None, scale: float | None) -> Any:
    io = _io()
    reading = io.NativeReading()
    reading.world = _world(world)
    reading.kind = _kind(kind)
    if scale is not None:
        reading.scale = real_number(scale, "scale")
        if not reading.scale > 0:
            raise InvalidArgument(f"scale is {scale!r}; it must be above 0")
    if spacing is not None:
        for axis, length in enumerate(triple(spacing, "spacing")):
            reading.set_spacing(axis, float(length))
    return reading


def _choice(name: str, argument: str, numbers: dict[str, int]) -> int:
    if name not in numbers:
        raise InvalidArgument(f"{argument} is {name!r}; it must be one of {', '.join(numbers)}")
    return numbers[name]
