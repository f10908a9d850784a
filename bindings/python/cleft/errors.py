"""Exceptions: one class a status of the library, each also one of Python's own kinds where there is a natural one."""
from __future__ import annotations

import os
import sys
import warnings

from . import native


class CleftError(Exception):
    """What every failure of the library is raised as. `status` is the library's number for its kind."""

    status = native.CLEFT_ERROR_INTERNAL


# <classes> Made by tools/generate.py from include/cleft/cleft_status.h.
class Cancelled(CleftError):
    """The progress function answered a false value, or Mesher.cancel() was called."""

    status = native.CLEFT_ERROR_CANCELLED


class OutOfMemory(CleftError, MemoryError):
    """There is not enough memory."""

    status = native.CLEFT_ERROR_OUT_OF_MEMORY


class InvalidArgument(CleftError, ValueError):
    """An argument is out of its range, or missing."""

    status = native.CLEFT_ERROR_ARGUMENT


class NotFinite(InvalidArgument):
    """A number is NaN or infinite."""

    status = native.CLEFT_ERROR_NOT_FINITE


class OptionError(InvalidArgument):
    """The value of an option is out of its range."""

    status = native.CLEFT_ERROR_OPTION


class TooLarge(CleftError, OverflowError):
    """Too large for numbers of 32 bits."""

    status = native.CLEFT_ERROR_TOO_LARGE


class Unsupported(CleftError, NotImplementedError):
    """Not supported by this build or format."""

    status = native.CLEFT_ERROR_UNSUPPORTED


class InvalidMesh(CleftError, ValueError):
    """A mesh is not valid."""

    status = native.CLEFT_ERROR_INVALID_MESH


class LabelLost(CleftError):
    """A label of the volume is not in the mesh, and the option `strict` is on."""

    status = native.CLEFT_ERROR_LABEL_LOST


class FormatError(CleftError, ValueError):
    """The contents of a file break the rules of its format."""

    status = native.CLEFT_ERROR_FORMAT


class InternalError(CleftError):
    """A defect of the library."""

    status = native.CLEFT_ERROR_INTERNAL


class Closed(CleftError, ValueError):
    """The object was closed before."""

    status = native.CLEFT_ERROR_HANDLE


class Busy(CleftError, RuntimeError):
    """The Mesher runs another call."""

    status = native.CLEFT_ERROR_BUSY


# </classes>


class FileError(CleftError, OSError):
    """A file cannot be read or written. `filename` is its path and `errno` the system's number, None if it has none.

    Where Python has a class for that number, the exception is of that class too: FileNotFoundError, PermissionError,
    IsADirectoryError, NotADirectoryError.
    """

    status = native.CLEFT_ERROR_FILE
    sentence = ""  # of the library

    def __str__(self) -> str:
        return self.sentence or super().__str__()


class FileMissing(FileError, FileNotFoundError):
    """There is no such file, or no such folder."""


class FileForbidden(FileError, PermissionError):
    """There is no permission to read the file, or to write into its folder."""


class FileIsFolder(FileError, IsADirectoryError):
    """There is a folder where a file should be."""


class FolderIsFile(FileError, NotADirectoryError):
    """There is a file where a folder should be."""


def file_error(found: OSError, path: str | bytes, sentence: str) -> FileError:
    """The exception for a file: the system's number as `found`, the sentence of the library."""
    kinds = {
        FileNotFoundError: FileMissing,
        PermissionError: FileForbidden,
        IsADirectoryError: FileIsFolder,
        NotADirectoryError: FolderIsFile,
    }
    number = found.errno or 0
    error = kinds.get(type(found), FileError)(number, os.strerror(number), path)
    error.sentence = sentence
    return error


_CLASSES = {
    # <choice> Made by tools/generate.py from include/cleft/cleft_status.h.
    native.CLEFT_ERROR_CANCELLED: Cancelled,
    native.CLEFT_ERROR_OUT_OF_MEMORY: OutOfMemory,
    native.CLEFT_ERROR_ARGUMENT: InvalidArgument,
    native.CLEFT_ERROR_NULL: InvalidArgument,
    native.CLEFT_ERROR_BUFFER: InvalidArgument,
    native.CLEFT_ERROR_NOT_FINITE: NotFinite,
    native.CLEFT_ERROR_OPTION: OptionError,
    native.CLEFT_ERROR_TOO_LARGE: TooLarge,
    native.CLEFT_ERROR_UNSUPPORTED: Unsupported,
    native.CLEFT_ERROR_INVALID_MESH: InvalidMesh,
    native.CLEFT_ERROR_LABEL_LOST: LabelLost,
    native.CLEFT_ERROR_FILE: FileError,
    native.CLEFT_ERROR_FORMAT: FormatError,
    native.CLEFT_ERROR_INTERNAL: InternalError,
    native.CLEFT_ERROR_EXCHANGE: InternalError,
    native.CLEFT_ERROR_HANDLE: Closed,
    native.CLEFT_ERROR_BUSY: Busy,
    # </choice>
}


class CleftWarning(UserWarning):
    """What the library warns of, where no log function was given."""


_PACKAGE = os.path.dirname(__file__) + os.sep


def warn(sentence: str) -> None:
    """Warns through Python's `warnings`, at the line of the user that called the package."""
    depth, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_code.co_filename.startswith(_PACKAGE):
        depth, frame = depth + 1, frame.f_back
    warnings.warn(sentence, CleftWarning, stacklevel=depth)


def raise_for(status: int, sentence: str) -> None:
    """Raises the exception of a status, unless the status is success."""
    if status == 0:
        return
    kind = _CLASSES.get(status, InternalError)
    error = kind(sentence)
    error.status = status
    raise error
