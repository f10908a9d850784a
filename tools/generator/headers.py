"""The two headers of the C interface, as they will be."""
from . import c_header

CORE = ("include/cleft/cleft_status.h", "include/cleft/cleft.h")
FILES = ("include/cleft/cleft_io.h",)


def read(tree, paths):
    return c_header.Header("".join(tree.read(path) for path in paths)).check()
