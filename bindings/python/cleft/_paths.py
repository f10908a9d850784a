"""Paths of files: as the library reads them, and what the system says of one that the library could not use."""
from __future__ import annotations

import contextlib
import errno
import glob
import os
import re
import tempfile
from typing import Any, Iterator, Sequence, Union

from .errors import FileError, file_error

Path = Union[str, "os.PathLike[str]"]


def path_bytes(path: Any) -> bytes:
    """A path as the library reads it; ValueError if it has a zero in it."""
    text = os.fsencode(path)
    if b"\0" in text:
        raise ValueError("embedded null byte in a path")
    return text + b"\0"


def path_list(path: Path | Sequence[Path]) -> list[Path]:
    """One path, or several, as a list."""
    return [path] if isinstance(path, (str, bytes, os.PathLike)) else list(path)


@contextlib.contextmanager
def reading(*paths: Path, folders: bool = False) -> Iterator[None]:
    """Around a call that reads: a FileError of the library gets the errno and the name of the unreadable file."""
    try:
        yield
    except FileError as error:
        for path in paths:
            for part in _files_of(os.fsdecode(path)):
                try:
                    _try_to_read(part, folders)
                except OSError as found:
                    raise file_error(found, part, str(error)) from None
        if len(paths) == 1:
            _name(error, paths[0])
        raise


@contextlib.contextmanager
def writing(path: Path) -> Iterator[None]:
    """Around a call that writes: a FileError of the library gets the errno and the name of the file."""
    try:
        yield
    except FileError as error:
        name = os.fsdecode(path)
        try:
            _try_to_write(name, str(error))
        except OSError as found:
            raise file_error(found, name, str(error)) from None
        _name(error, path)
        raise


def _name(error: FileError, path: Path) -> None:
    """Gives the exception the name of the file where the system has no number for what is wrong with it."""
    error.sentence = str(error)
    error.filename = os.fsdecode(path)


def _files_of(path: str) -> list[str]:
    """The files that a path names: both of TetGen's, all of a series; the path itself if there are none."""
    stem, extension = os.path.splitext(path)
    if extension in (".node", ".ele"):
        return [stem + ".node", stem + ".ele"]
    if os.path.exists(path):
        return [path]
    pattern = re.sub(r"%0?\d*d", "*", path).replace("[", "[[]")
    return sorted(glob.glob(pattern)) or [path]


def _try_to_read(path: str, folders: bool) -> None:
    if folders and os.path.isdir(path):
        os.scandir(path).close()
    else:
        open(path, "rb").close()


def _try_to_write(path: str, sentence: str) -> None:
    if os.path.isdir(path):
        raise OSError(errno.EISDIR, "")
    with tempfile.TemporaryFile(dir=os.path.dirname(path) or "."):
        pass
    for number in errno.errorcode:  # a full disk, which the library names at the end of its sentence
        if sentence.endswith(": " + os.strerror(number)):
            raise OSError(number, "")
