"""The structs and enumerations of the C headers that other languages have as plain values."""
import re
from dataclasses import dataclass

from . import headers

# The structs that come out of the library, and what their classes are called.
RECORDS = {
    "cleft_quality": "Quality",
    "cleft_metric_quality": "MetricQuality",
    "cleft_validation": "Validation",
    "cleft_label_report": "LabelReport",
    "cleft_contact": "Contact",
    "cleft_distance": "Distance",
    "cleft_estimate": "Estimate",
}
# How the lowest level of the bindings gives one element of an array, by its index.
ELEMENTS = {"dihedral_histogram": "histogram_bin"}
# The enumerations of cleft_io.h: class, prefix, first constant.
IN_FILES = (
    ("World", "CLEFT_IO_WORLD_", ""),
    ("VoxelKind", "CLEFT_IO_KIND_", ""),
    ("Content", "CLEFT_IO_", "UNKNOWN"),
    ("TensorOrder", "CLEFT_IO_ORDER_", ""),
    ("Colouring", "CLEFT_IO_BY_", ""),
    ("Backdrop", "CLEFT_IO_BACKDROP_", ""),
)


@dataclass(frozen=True)
class Value:
    """A field as other languages have it."""

    name: str
    kind: str  # "whole", "label" (a whole number of 32 bits), "real", "flag" or "list" (of whole numbers)
    length: int
    about: str


def _kind(field):
    if field.length:
        return "list"
    if field.type == "int32_t":
        return "flag" if field.comment.startswith("1 if ") else "label"
    return "real" if field.type == "double" else "whole"


def _value(field):
    if not field.comment:
        raise ValueError(f"the field {field.name} has no comment")
    return Value(field.name, _kind(field), field.length, re.sub("^1 if ", "true if ", field.comment))


def records(tree):
    """{class: (C struct, its values)}."""
    structs = {struct.name: struct for struct in headers.read(tree, headers.CORE).structs}
    return {
        name: tuple(_value(field) for field in structs[struct].fields if field.name not in ("struct_size", "reserved"))
        for struct, name in RECORDS.items()
    }


def enumeration(tree, prefix, first=""):
    """The comment of an enumeration, and its constants (name without the prefix, text, C name). Where the prefix is
    that of others, too, `first` is the first name."""
    header = headers.read(tree, headers.FILES if prefix.startswith("CLEFT_IO_") else headers.CORE)
    for found in header.enumerations:
        if found.constants[0].name.startswith(prefix + first):
            comment = re.sub(r" *\\since [\d.]+$", "", found.comment)
            rows = [
                (constant.name.removeprefix(prefix), constant.comment, constant.name) for constant in found.constants
            ]
            if comment and all(about for _, about, _ in rows):
                return comment, rows
            raise ValueError(f"not all of the enumeration {prefix}... have a comment")
    raise ValueError(f"there is no enumeration {prefix}...")


def choices(table):
    """(name, comment, constants) of the choices of options."""
    return [
        (
            choice.name,
            choice.text,
            [(value.name.upper(), value.text, f"CLEFT_{choice.key}_{value.name.upper()}") for value in choice.values],
        )
        for choice in table.choices
    ]
