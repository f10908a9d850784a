"""The description of the options, src/capi/options.toml, checked."""
import re
import tomllib
from dataclasses import dataclass

PATH = "src/capi/options.toml"
TYPES = {"integer": 1, "real": 2, "choice": 3, "flag": 4}
_FIELDS = {"key", "number", "type", "default", "least", "greatest", "group", "calls", "field", "text"}


@dataclass(frozen=True)
class Value:
    name: str  # "particles"
    text: str


@dataclass(frozen=True)
class Choice:
    key: str
    enum: str  # of the stage
    header: str  # that has this enum
    name: str  # of the enumeration in Java and C#
    text: str
    values: tuple[Value, ...]


@dataclass(frozen=True)
class Option:
    key: str
    number: int
    type: str
    default: float  # the number of a choice, 0 or 1 for a flag
    least: float
    greatest: float
    choice: Choice | None
    group: str
    calls: tuple[str, ...]
    field: str  # "" where the call asks for the value itself
    text: str

    @property
    def name(self):
        return self.key.lower()

    @property
    def is_small(self):
        """Does an int of 32 bits do in languages where whole numbers have sizes?"""
        return self.type == "integer" and self.greatest < 1e6


@dataclass(frozen=True)
class LabelList:
    """What is said of single labels, which no row of the library's table can hold."""

    name: str
    text: str


@dataclass(frozen=True)
class OptionTable:
    calls: dict[str, str]  # name -> C function
    choices: tuple[Choice, ...]
    options: tuple[Option, ...]
    lists: tuple[LabelList, ...]

    @property
    def by_number(self):
        return sorted(self.options, key=lambda option: option.number)


def _require(condition, sentence):
    if not condition:
        raise ValueError(f"{PATH}: {sentence}")


def _choice(row):
    values = tuple(Value(**value) for value in row.pop("values"))
    return Choice(values=values, **row)


def _option(row, choices, calls):
    key = row.get("key", "?")
    missing = _FIELDS - {"least", "greatest", "field"} - set(row)
    _require(not missing, f"{key} lacks {', '.join(sorted(missing))}")
    _require(set(row) <= _FIELDS, f"{key} has unknown fields: {set(row) - _FIELDS}")
    kind, default, text = row["type"], row["default"], re.sub(r"\s+", " ", row["text"]).strip()
    _require(re.fullmatch(r"[A-Z][A-Z0-9_]*", key), f"{key} is no key")
    _require(kind in TYPES, f"{key}: there is no type {kind}")
    _require(kind in ("integer", "real") or not {"least", "greatest"} & set(row), f"{key}: a {kind} has no range")
    choice, least, greatest = None, row.get("least", 0), row.get("greatest", 1)
    if kind == "choice":
        _require(key in choices, f"{key} has no [[choice]] with its names")
        choice = choices[key]
        names = [value.name for value in choice.values]
        _require(default in names, f"{key}: {default} is none of {names}")
        default, greatest = names.index(default), len(names) - 1
    _require(least <= default <= greatest, f"{key}: the default is out of its range")
    _require(row["calls"] and set(row["calls"]) <= set(calls), f"{key}: there are no calls {row['calls']}")
    _require(text and text[0].islower() and text[-1] != ".", f"{key}: its text is a phrase, not a sentence")
    reading = set(row["calls"]) | ({"mesh"} if set(row["calls"]) != {"volume"} else set())
    return Option(
        key,
        row["number"],
        kind,
        float(default),
        float(least),
        float(greatest),
        choice,
        row["group"],
        tuple(call for call in calls if call in reading),
        row.get("field", ""),
        text,
    )


def read(root):
    """The table of the repository in the folder `root`."""
    with open(root / PATH, "rb") as file:
        rows = tomllib.load(file)
    choices = {choice.key: choice for choice in map(_choice, rows["choice"])}
    options = tuple(_option(row, choices, rows["calls"]) for row in rows["option"])
    for what in ("key", "number"):
        values = [getattr(option, what) for option in options]
        _require(len(set(values)) == len(values), f"a {what} is there twice")
    _require({option.key for option in options if option.choice} == set(choices), "a choice is of no option")
    lists = tuple(LabelList(**row) for row in rows["list"])
    return OptionTable(rows["calls"], tuple(choices.values()), options, lists)
