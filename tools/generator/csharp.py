"""What is made in C#: the properties of Options, enumerations, and the fields of plain values."""
from . import option_table, plain_values, text

FOLDER = "bindings/csharp/src"
WIDTH = text.WIDTH


def summary(sentences, indent):
    pad = " " * indent
    if len(pad) + len(f"/// <summary>{sentences}</summary>") <= WIDTH:
        return f"{pad}/// <summary>{sentences}</summary>\n"
    return f"{pad}/// <summary>\n{text.lines(sentences, WIDTH, f'{pad}/// ')}{pad}/// </summary>\n"


def _type(option):
    if option.choice:
        return f"Cleft.{option.choice.name}"
    return {"real": "double", "flag": "bool"}.get(option.type) or ("int" if option.is_small else "long")


def _about(option, options):
    words = text.with_names(option.text, options, text.pascal)
    note = (
        " It counts where a volume is made or read: a finished volume keeps its own."
        if option.calls == ("volume",)
        else ""
    )
    return text.sentence(f"{words} ({text.values_text(option)})") + note


def _property(option, options):
    key, kind = f"CleftNative.CLEFT_OPTION_{option.key}", _type(option)
    given = {
        "real": "value",
        "flag": "value ? 1L : 0L",
        "integer": "(long)value" if option.is_small else "value",
        "choice": "(long)value",
    }[option.type]
    got = {
        "real": f"Real({key})",
        "flag": f"Integer({key}) != 0",
        "integer": f"{'(int)' if option.is_small else ''}Integer({key})",
        "choice": f"({kind})Integer({key})",
    }[option.type]
    return (
        summary(_about(option, options), 8) + f"        public {kind} {text.pascal(option.name)}\n        {{\n"
        f"            get {{ return {got}; }}\n            set {{ Set({key}, {given}); }}\n        }}\n\n"
    )


_WORDS = {"UINT8": "UInt8", "UINT16": "UInt16", "UINT32": "UInt32"}  # beside those whose parts begin with a capital


def enumeration(name, comment, constants, native="CleftNative"):
    rows = [
        f"{summary(text.sentence(about), 8)}        {_WORDS.get(constant) or text.pascal(constant)} = {native}.{c_name}"
        for constant, about, c_name in constants
    ]
    return f"{summary(comment, 4)}    public enum {name}\n    {{\n" + ",\n".join(rows) + "\n    }\n"


_CSHARP = {"whole": "long", "label": "int", "real": "double", "flag": "bool", "list": "IReadOnlyList<long>"}
_NAMES = {("Validation", "valid"): "IsValid"}  # where C# has a better name than that of the field


def _record(name, values):
    """The part of a class that has the fields of a struct; the rest of it is in Values.cs and Report.cs."""

    def called(value):
        return _NAMES.get((name, value.name)) or text.pascal(value.name)

    out = f"    public sealed partial class {name}\n    {{\n        internal {name}(Native{name} row)\n        {{\n"
    for v in values:
        if v.kind == "list":
            out += (
                f"            long[] {text.camel(v.name)} = new long[{v.length}];\n"
                f"            for (int index = 0; index < {v.length}; ++index)\n"
                f"                {text.camel(v.name)}[index] = row.{plain_values.ELEMENTS[v.name]}(index);\n"
                f"            {called(v)} = {text.camel(v.name)};\n"
            )
        else:
            out += f"            {called(v)} = row.{v.name}{' != 0' if v.kind == 'flag' else ''};\n"
    out += "        }\n\n"
    out += "".join(
        f"{summary(text.sentence(v.about), 8)}        public {_CSHARP[v.kind]} {called(v)} {{ get; }}\n" for v in values
    )
    return out + "    }\n"


_ENUMERATIONS = {
    "VoxelType": "CLEFT_TYPE_",
    "Side": "CLEFT_SIDE_",
    "LogLevel": "CLEFT_LOG_",
    "OptionType": "CLEFT_OPTION_TYPE_",
}


def files(tree, table):
    path = f"{FOLDER}/Options.cs"
    properties = "".join(_property(option, table.options) for option in table.options)
    enumerations = [(name, comment, rows) for name, comment, rows in plain_values.choices(table)]
    enumerations += [(name, *plain_values.enumeration(tree, prefix)) for name, prefix in _ENUMERATIONS.items()]
    parts = [enumeration(name, comment, rows) for name, comment, rows in enumerations]
    for name, prefix, first in plain_values.IN_FILES:
        comment, rows = plain_values.enumeration(tree, prefix, first)
        # More than the first sentence is on functions of C.
        parts.append(enumeration(name, text.sentence(comment.split(". ")[0]), rows, "CleftIoNative"))
    records = [_record(name, values) for name, values in plain_values.records(tree).items()]
    head = f"// {text.MADE_BY} from {option_table.PATH} and include/cleft/*.h.\n"
    return {
        path: text.region(tree.read(path), path, "options", "\n" + properties, ("//", "")),
        f"{FOLDER}/Enumerations.cs": head + "namespace Cleft\n{\n" + "\n".join(parts) + "}\n",
        f"{FOLDER}/Records.cs": head
        + "using System.Collections.Generic;\n\nnamespace Cleft\n{\n"
        + "\n".join(records)
        + "}\n",
    }
