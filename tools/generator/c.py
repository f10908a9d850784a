"""What is made in C and C++: keys and choices in cleft.h, the sentences on who reads which option, the library's table.
"""
import json
import re

from . import option_table, text

HEADER = "include/cleft/cleft.h"
ROWS = "src/capi/options.inc"
ARGUMENTS = "src/cli/option_arguments.cpp"
WIDTH = text.WIDTH


def _enumeration(rows):
    """An enumeration of (name, number, comment), formatted as clang-format does."""
    if not any(comment for _, _, comment in rows):
        inner = ", ".join(f"{name} = {number}" for name, number, _ in rows)
        if len(inner) + len("enum {  };") <= WIDTH:
            return f"enum {{ {inner} }};\n"
    parts = [f"{name} = {number}{',' if i + 1 < len(rows) else ''}" for i, (name, number, _) in enumerate(rows)]
    width = max(map(len, parts))
    lines = [
        f"    {part.ljust(width) + f' /**< {comment} */' if comment else part}".rstrip()
        for part, (_, _, comment) in zip(parts, rows)
    ]
    return "enum {\n" + "\n".join(lines) + "\n};\n"


def _keys(table):
    found = _enumeration([(f"CLEFT_OPTION_{option.key}", option.number, "") for option in table.by_number]) + "\n"
    for choice in table.choices:
        found += f"/** {choice.text} \\since 0.1 */\n" + _enumeration(
            [(f"CLEFT_{choice.key}_{value.name.upper()}", i, value.text) for i, value in enumerate(choice.values)]
        )
    return found


def _readers(table, call):
    """ "SIZE, SIZE_MIN and TETS", or "all but SMOOTH"."""
    reading = [option.key for option in table.options if call in option.calls]
    others = [option.key for option in table.options if call not in option.calls]
    names = others if len(others) < len(reading) / 2 else reading
    listed = ", ".join(names[:-1]) + " and " + names[-1] if len(names) > 1 else names[0]
    return listed if names is reading else "all but " + listed


def _manual(header, table):
    """The header with its sentences "Options read: ..." as the table has them; each reader has such a sentence."""
    for call, function in table.calls.items():
        sentence = text.lines(f"Options read: {_readers(table, call)}.", WIDTH - 2, " *  ")
        pattern = (
            r"^ \*  Options read: [^.]*\.\n((?: \*[^\n]*\n)*?[^\n]*\*/\s*(?:CLEFT_NODISCARD )?CLEFT_API cleft_status "
            + function
            + r"\()"
        )
        header, count = re.subn(pattern, lambda match: sentence + match[1], header, flags=re.MULTILINE)
        if count != 1:
            raise ValueError(f'the manual of {function} has no sentence of its own "Options read: ..."')
    return header


def _rows(table):
    out = (
        f"// {text.MADE_BY} from {option_table.PATH}. The rows of the table, the fields that take the\n"
        "// values, and the choices with those of the stages: each where its macro is defined.\n"
    )
    out += "#ifdef CLEFT_OPTION_ROW\n"
    for o in table.options:
        choices = "|".join(value.name for value in o.choice.values) if o.choice else ""
        default = (
            f"CLEFT_{o.key}_{o.choice.values[int(o.default)].name.upper()}" if o.choice else text.number(o.default)
        )
        parts = [
            f"CLEFT_OPTION_{o.key}",
            f"CLEFT_OPTION_TYPE_{o.type.upper()}",
            json.dumps(o.name),
            default,
            text.number(o.least),
            text.number(o.greatest),
            json.dumps(choices),
            json.dumps(o.group),
            json.dumps("|".join(o.calls)),
        ]
        out += f"CLEFT_OPTION_ROW({', '.join(parts)},\n                 {json.dumps(o.text)})\n"
    out += "#endif\n#ifdef CLEFT_OPTION_FIELD\n"
    out += "".join(f"CLEFT_OPTION_FIELD(CLEFT_OPTION_{o.key}, {o.field})\n" for o in table.options if o.field)
    out += "#endif\n#ifdef CLEFT_CHOICE\n"
    out += "".join(
        f"CLEFT_CHOICE(CLEFT_{c.key}_{v.name.upper()}, {c.enum}::{v.name})\n" for c in table.choices for v in c.values
    )
    return out + "#endif\n"


def _stage_enum(tree, choice):
    """The header of the stage with its enum made, and the number of its values for tables that have a row for each."""
    names = ", ".join(value.name for value in choice.values)
    made = f"enum class {choice.enum} {{ {names} }};\n"
    made += f"inline constexpr size_t k{choice.enum}Count = {len(choice.values)};\n"
    return text.region(tree.read(choice.header), choice.header, "choice", made)


def _list_texts(table):
    """Constants with what the command says of the lists."""
    made = ""
    for row in table.lists:
        begin, words = f"constexpr const char* k{text.pascal(row.name)}Text =", json.dumps(text.sentence(row.text)[:-1])
        fits = len(f"{begin} {words};") <= WIDTH
        made += begin + (" " if fits else "\n    ") + words + ";\n"
    return made


def files(tree, table):
    header = tree.read(HEADER)
    header = text.region(header, HEADER, "options", _keys(table))
    made = {choice.header: _stage_enum(tree, choice) for choice in table.choices}
    return made | {
        HEADER: _manual(header, table),
        ROWS: _rows(table),
        ARGUMENTS: text.region(tree.read(ARGUMENTS), ARGUMENTS, "lists", _list_texts(table)),
    }
