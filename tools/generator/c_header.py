"""What the C headers of Cleft declare, read from their text: the one reader for the generator and the tests.

The headers keep to few forms, and the reader knows these alone: a function ends with ") CLEFT_NOEXCEPT;", a struct is a
typedef of fields, an enumeration has a number for each name. check() fails on a header that has anything else.
"""
import pathlib
import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Argument:
    name: str
    type: str  # "const char*", without the length of an array
    length: int  # of an array, else 0


@dataclass(frozen=True)
class Function:
    name: str
    result: str
    arguments: tuple[Argument, ...]
    comment: str
    since: str  # the release, as "0.1"; "" if its comment does not say
    prototype: str  # "cleft_status cleft_x(int32_t a)"
    text: str  # all of the declaration, to its semicolon


@dataclass(frozen=True)
class Callback:
    name: str
    result: str
    arguments: tuple[Argument, ...]
    comment: str


@dataclass(frozen=True)
class Field:
    name: str
    type: str
    length: int  # of an array, else 0
    comment: str


@dataclass(frozen=True)
class Struct:
    name: str
    fields: tuple[Field, ...]
    comment: str


@dataclass(frozen=True)
class Constant:
    name: str
    number: int
    comment: str


@dataclass(frozen=True)
class Enumeration:
    constants: tuple[Constant, ...]
    comment: str


@dataclass(frozen=True)
class Section:
    """What stands under a heading of the header, in its order."""

    name: str
    items: tuple[Function | Callback | Struct | Enumeration, ...]


_COMMENT = r"/\*\*<?(?:(?!\*/).)*\*/"
_FUNCTION = (
    rf"(?P<function_comment>{_COMMENT}\s*)?(?P<function>(?:CLEFT_NODISCARD )?CLEFT(?:_IO|_MPI)?_API "
    r"(?P<prototype>(?P<result>[^;(){}]*?)\b(?P<name>cleft_\w+)\((?P<arguments>[^;{}]*?)\)) CLEFT_NOEXCEPT;)"
)
_STRUCT = rf"(?P<struct_comment>{_COMMENT}\s*)?typedef struct (?P<struct>cleft_\w+) \{{(?P<fields>.*?)\n\}} \w+;"
_ENUM = rf"(?P<enum_comment>{_COMMENT}\s*)?(?:typedef int32_t \w+;\s*)?^enum \{{(?P<constants>[^}}]*)\}};"
_CALLBACK = (
    rf"(?P<callback_comment>{_COMMENT}\s*)?typedef (?P<answer>\w+) \(\*(?P<callback>cleft_\w+)\)"
    r"\((?P<parameters>[^;{}]*?)\);"
)
_SECTION = r"/\* -+ (?P<section>[\w -]+?) -- \*/"
_ITEM = re.compile("|".join((_SECTION, _FUNCTION, _CALLBACK, _STRUCT, _ENUM)), re.DOTALL | re.MULTILINE)
_FIELD = re.compile(
    rf"\s*(?P<before>{_COMMENT})?\s*(?P<type>[\w ]+\*?)\s(?P<name>\w+)(?:\[(?P<length>\d+)\])?;[ \t]*"
    rf"(?P<after>/\*\*<(?:(?!\*/).)*\*/)?",
    re.DOTALL,
)
_CONSTANT = re.compile(
    rf"(?P<before>{_COMMENT})?\s*(?P<name>CLEFT_\w+) = (?P<number>-?\d+)\b(?! -),?[ \t]*"
    rf"(?P<after>/\*\*<(?:(?!\*/).)*\*/)?",
    re.DOTALL,
)


def plain(comment):
    """The words of a comment in one line, without its marks."""
    inner = re.sub(r"^/\*\*<?|\*/\s*$", "", (comment or "").strip())
    return re.sub(r"\s+", " ", re.sub(r"\n\s*\*", "\n", inner)).strip()


def without_comments(text):
    return re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)


def _arguments(text):
    found = []
    for argument in re.sub(r"\s+", " ", text).split(","):
        if argument.strip() not in ("", "void"):
            kind, name, length = re.fullmatch(r"(.*?)(\w+)(?:\[(\d+)\])?", argument.strip()).groups()
            found.append(Argument(name, kind.strip(), int(length or 0)))
    return tuple(found)


def _function(match):
    comment = plain(match["function_comment"])
    since = re.search(r"\\since ([\d.]+)", comment)
    return Function(
        match["name"],
        re.sub(r"\s+", " ", match["result"]).strip(),
        _arguments(match["arguments"]),
        comment,
        since[1] if since else "",
        match["prototype"],
        match["function"],
    )


def _struct(match):
    fields = [
        Field(f["name"], f["type"].strip(), int(f["length"] or 0), plain(f["before"] or f["after"]))
        for f in _FIELD.finditer(match["fields"])
    ]
    if len(fields) != without_comments(match["fields"]).count(";"):
        raise ValueError(f"not all fields of {match['struct']} are understood")
    return Struct(match["struct"], tuple(fields), plain(match["struct_comment"]))


def _enumeration(match):
    constants = [
        Constant(c["name"], int(c["number"]), plain(c["before"] or c["after"]))
        for c in _CONSTANT.finditer(match["constants"])
    ]
    return Enumeration(tuple(constants), plain(match["enum_comment"]))


class Header:
    """A header, from its text."""

    def __init__(self, text):
        self.text = text
        name, items, sections = "", [], []
        for match in _ITEM.finditer(text):
            if match["section"]:
                sections.append(Section(name, tuple(items)))
                name, items = match["section"], []
            elif match["function"]:
                items.append(_function(match))
            elif match["callback"]:
                items.append(
                    Callback(
                        match["callback"],
                        match["answer"],
                        _arguments(match["parameters"]),
                        plain(match["callback_comment"]),
                    )
                )
            elif match["struct"]:
                items.append(_struct(match))
            else:
                items.append(_enumeration(match))
        self.sections = [*sections, Section(name, tuple(items))]

    def _all(self, kind):
        return [item for section in self.sections for item in section.items if isinstance(item, kind)]

    @property
    def functions(self):
        return self._all(Function)

    @property
    def callbacks(self):
        return self._all(Callback)

    @property
    def structs(self):
        return self._all(Struct)

    @property
    def enumerations(self):
        return [e for e in self._all(Enumeration) if e.constants]

    @property
    def versions(self):
        """The numbers CLEFT_VERSION_..."""
        return tuple(
            Constant(name, int(number), "")
            for name, number in re.findall(r"^#define (CLEFT_VERSION_\w+) (\d+)$", self.text, re.MULTILINE)
        )

    @property
    def statuses(self):
        """The status codes, if this is the header that lists them; their comments are their texts."""
        return tuple(
            Constant("CLEFT_" + name, int(number), text)
            for name, number, text in re.findall(r'X\((\w+), (-?\d+), "(.*?)"\)', self.text)
        )

    def check(self):
        """Fails if anything was passed over."""
        text = without_comments(self.text)
        for what, pattern, found in (
            ("functions", r"\)\s*CLEFT_NOEXCEPT\s*;", self.functions),
            ("callbacks", r"typedef [^;{}]*\(\*", self.callbacks),
            ("structs", r"\bstruct \w+\s*\{", self.structs),
            ("enumerations", r"\benum\b(?!\s*\{\s*#)", self.enumerations),
        ):
            if len(re.findall(pattern, text)) != len(found):
                raise ValueError(f"{len(found)} {what} were understood, of {len(re.findall(pattern, text))}")
        for function in self.functions:
            if not function.since:
                raise ValueError(f"{function.name} does not say since when it is there")
        return self


def read(*paths):
    """One header that has all that these files have, in their order."""
    return Header("".join(pathlib.Path(path).read_text(encoding="utf-8") for path in paths)).check()
