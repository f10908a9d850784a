"""The options of meshing, by name."""
from __future__ import annotations

import operator
import textwrap
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Mapping, TypedDict, TypeVar, Unpack

import numpy as np

from . import native
from ._arrays import int32_array, real_number, true_or_false, whole_number
from ._handle import Handle, Owner
from .errors import raise_for, warn


class OptionKeywords(TypedDict, total=False):
    """The keyword arguments of Options and of the functions of the stages; `cleft.option_table()` describes them."""

    # <options> made by tools/generate.py from src/capi/options.toml
    background: str
    size: float
    size_min: float
    size_max: float
    feature_scale: float
    gradation: float
    interface_size: float
    surface_error: float
    anisotropy: float
    keep_thin: bool
    tets: int
    max_tets: int
    smooth: int
    snap: str
    improve: str
    min_angle: float
    steps: int
    seed: int
    strict: bool
    repair: float
    block: int
    delaunay: str
    # </options>
    label_sizes: Mapping[int, float]
    strip: Iterable[int]
    only: Iterable[int]


@dataclass(frozen=True)
class OptionDescription:
    """One row of the table of options."""

    name: str
    type: str  #: "integer", "real", "choice" or "flag"
    default: int | float | str | bool
    least: float
    greatest: float
    choices: tuple[str, ...]
    text: str
    group: str  #: the heading under which help lists it
    calls: tuple[str, ...]  #: the calls that read it: "volume", "sizing", "background", "cleave", "improve", "mesh"
    key: int


_TYPES = {
    native.CLEFT_OPTION_TYPE_INTEGER: "integer",
    native.CLEFT_OPTION_TYPE_REAL: "real",
    native.CLEFT_OPTION_TYPE_CHOICE: "choice",
    native.CLEFT_OPTION_TYPE_FLAG: "flag",
}


def _described(index: int) -> OptionDescription:
    row = native.NativeOptionDescription()
    raise_for(native.cleft_option_info(index, row), "no such option")
    kind = _TYPES[row.type]
    choices = tuple(row.choices.split("|")) if row.choices else ()
    default: Any = row.value
    if kind == "choice":
        default = choices[int(row.value)]
    elif kind != "real":
        default = bool(row.value) if kind == "flag" else int(row.value)
    return OptionDescription(
        row.name,
        kind,
        default,
        row.least,
        row.greatest,
        choices,
        row.text,
        row.group,
        tuple(row.calls.split("|")),
        row.key,
    )


_TABLE = {row.name: row for row in map(_described, range(native.cleft_option_count()))}
_LISTS = {
    # <lists> made by tools/generate.py from src/capi/options.toml
    "label_sizes": "greatest wanted edge lengths inside single labels, in world units",
    "strip": "labels whose tetrahedra the finished mesh leaves out",
    "only": "labels whose tetrahedra alone the finished mesh keeps. None: all",
    # </lists>
}


def option_table() -> list[OptionDescription]:
    """All options that have one value, with their defaults and ranges, as the library describes them."""
    return list(_TABLE.values())


def _kind_of(row: OptionDescription) -> str:
    if row.type == "choice":
        return f"{', '.join(map(repr, row.choices))} = {row.default!r}"
    if row.type == "flag":
        return f"bool = {row.default!r}"
    name = "float" if row.type == "real" else "int"
    limits = f"at least {row.least:g}" if row.greatest > 1e300 else f"{row.least:.16g} to {row.greatest:.16g}"
    return f"{name} = {row.default!r}, {limits}"


def describe_options() -> str:
    """Name, type, default, range and meaning of all options, as the docstrings have them."""
    rows = [(row.name, _kind_of(row), row.text) for row in _TABLE.values()]
    rows += [
        (name, "{label: float} = {}" if name == "label_sizes" else "[label, ...] = []", text)
        for name, text in _LISTS.items()
    ]
    return "\n".join(
        f"{name} : {kind}\n" + textwrap.indent(textwrap.fill(text, 90), "    ") for name, kind, text in rows
    )


# What a call does not read itself.
_OF_MESHER = {"threads", "progress", "log"}

_Documented = TypeVar("_Documented", bound=Callable[..., Any])


def lists_options(documented: _Documented) -> _Documented:
    """Puts the list of all options under a docstring."""
    if documented.__doc__:
        lines = "The options, as keywords or as attributes of an Options object:\n\n" + describe_options()
        documented.__doc__ = documented.__doc__.rstrip() + "\n\n" + textwrap.indent(lines, "    ") + "\n    "
    return documented


@lists_options
class Options(Owner):
    """How to mesh: Options(size=2.0, background="octree", strip=[0]). Values can be read and set as attributes.

    A value out of its range raises OptionError, which is a ValueError; a name that is no option raises TypeError.
    `cleft.option_table()` has the options that have one value as a list.
    """

    def __init__(self, **values: Unpack[OptionKeywords]) -> None:
        object.__setattr__(self, "_lists", {"label_sizes": {}, "strip": (), "only": ()})
        status, address = native.cleft_options_create()
        raise_for(status, "options could not be made")
        self._handle = Handle(address, native.cleft_options_destroy)
        for name, value in values.items():
            if name in _OF_MESHER:
                raise TypeError(f"{name!r} is not an option but of a Mesher: give mesher=cleft.Mesher({name}=...)")
            if name not in _TABLE and name not in _LISTS:
                raise TypeError(f"{name!r} is not an option; {_names()}")
            setattr(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        if name in _TABLE:
            self._set(_TABLE[name], value)
        elif name == "label_sizes":
            self._set_label_sizes(value)
        elif name in _LISTS:
            self._set_list(name, value)
        elif name.startswith("_"):
            super().__setattr__(name, value)
        else:
            raise AttributeError(f"{name!r} is not an option; {_names()}")

    def __getattr__(self, name: str) -> Any:
        if name in _LISTS:
            return self._lists[name]
        if name not in _TABLE:
            raise AttributeError(f"{name!r} is not an option")
        row = _TABLE[name]
        value = np.zeros(1, float if row.type == "real" else np.int64)
        get = native.cleft_options_get_real if row.type == "real" else native.cleft_options_get_integer
        self._check(get(self._native, row.key, value))
        if row.type == "choice":
            return row.choices[int(value[0])]
        return bool(value[0]) if row.type == "flag" else value[0].item()

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *_TABLE, *_LISTS]

    def __repr__(self) -> str:
        if self.closed:
            return "Options(closed)"
        changed = {
            row.name: getattr(self, row.name) for row in _TABLE.values() if getattr(self, row.name) != row.default
        }
        changed.update({name: value for name, value in self._lists.items() if value})
        return "Options(" + ", ".join(f"{name}={value!r}" for name, value in changed.items()) + ")"

    def set_text(self, name: str, value: str) -> None:
        """Sets an option from text, as the command line does: options.set_text("size", "2.5")."""
        self._check(native.cleft_options_set_text(self._native, _text(name, "name"), _text(value, "value")))

    def _check(self, status: int) -> None:
        if status:
            raise_for(status, native.cleft_options_last_error(self._native))

    def _set(self, row: OptionDescription, value: Any) -> None:
        if row.type == "real":
            self._check(native.cleft_options_set_real(self._native, row.key, real_number(value, row.name)))
        elif row.type == "choice":
            self.set_text(row.name, _text(value, row.name))
        elif row.type == "flag":
            self._check(native.cleft_options_set_integer(self._native, row.key, int(true_or_false(value, row.name))))
        else:
            whole = int(value) if isinstance(value, float) and value.is_integer() else value
            number = whole_number(whole, row.name, -(2**63), 2**63 - 1)
            self._check(native.cleft_options_set_integer(self._native, row.key, number))

    def _set_label_sizes(self, sizes: Mapping[int, float]) -> None:
        if not isinstance(sizes, Mapping):
            raise TypeError(f"label_sizes must be a dictionary from labels to sizes, not {sizes!r}")
        wanted = {
            whole_number(label, "a label in label_sizes", -(2**31), 2**31 - 1): real_number(
                size, f"label_sizes[{label!r}]"
            )
            for label, size in sizes.items()
        }
        for label in self._lists["label_sizes"]:
            self._check(native.cleft_options_set_label_size(self._native, label, 0.0))
        self._lists["label_sizes"] = {}
        for label, size in wanted.items():
            self._check(native.cleft_options_set_label_size(self._native, label, size))
            self._lists["label_sizes"][label] = size

    def _set_list(self, name: str, labels: Iterable[int]) -> None:
        try:
            values = tuple(operator.index(label) for label in labels)
        except TypeError:
            raise TypeError(f"{name} must be a list of labels, not {labels!r}") from None
        array = int32_array(values, name)
        set_list = native.cleft_options_set_strip if name == "strip" else native.cleft_options_set_only
        self._check(set_list(self._native, array, len(array)))
        self._lists[name] = values


def _names() -> str:
    return "the options are " + ", ".join((*_TABLE, *_LISTS))


def _text(value: str, name: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a text, not {value!r}")
    return value


def options_of_volume(options: Options | None, keywords: Mapping[str, Any]) -> Options | None:
    """The options of a call that makes a volume. A keyword that it does not read gives a warning."""
    for name in keywords:
        if name in _TABLE and "volume" not in _TABLE[name].calls or name in _LISTS:
            warn(f"a volume has no use for the option {name}: give it to mesh()")
    return options_of(options, keywords)


def options_of(options: Options | None, keywords: Mapping[str, Any]) -> Options | None:
    """The options of a call: either an Options object, or keywords, or none."""
    if options is not None and keywords:
        raise TypeError("give either options or keywords for them, not both")
    if options is not None and not isinstance(options, Options):
        raise TypeError(f"options must be an Options, not {type(options).__name__}")
    return Options(**keywords) if keywords else options
