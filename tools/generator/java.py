"""What is made in Java: the accessors of Options, enumerations, and the records of plain values."""
from . import option_table, plain_values, text

FOLDER = "bindings/java/src/org/cleft"
WIDTH = text.WIDTH


def javadoc(sentences, tags=(), indent=4):
    """A comment of one paragraph and its tags."""
    pad = " " * indent
    if not tags and len(pad) + len(f"/** {sentences} */") <= WIDTH:
        return f"{pad}/** {sentences} */\n"
    body = text.lines(sentences, WIDTH, f"{pad} * ")
    body += (f"{pad} *\n" if tags else "") + "".join(text.lines(tag, WIDTH, f"{pad} * ") for tag in tags)
    return f"{pad}/**\n{body}{pad} */\n"


def _type(option):
    if option.choice:
        return option.choice.name
    return {"real": "double", "flag": "boolean"}.get(option.type) or ("int" if option.is_small else "long")


def _about(option, options):
    words = text.with_names(option.text, options, text.camel)
    note = (
        " It counts where a volume is made or read: a finished volume keeps its own."
        if option.calls == ("volume",)
        else ""
    )
    return f"{words} ({text.values_text(option)}).{note}"


def _accessors(option, options):
    name, key, kind = text.camel(option.name), f"CleftNative.CLEFT_OPTION_{option.key}", _type(option)
    about = _about(option, options)
    given = {
        "real": "value",
        "flag": "value ? 1L : 0L",
        "integer": "(long) value" if option.is_small else "value",
        "choice": '(long) Objects.requireNonNull(value, "value").number',
    }[option.type]
    got = {
        "real": f"real({key})",
        "flag": f"integer({key}) != 0",
        "integer": f"{'(int) ' if option.is_small else ''}integer({key})",
        "choice": f"{kind}.values()[(int) integer({key})]",
    }[option.type]
    return (
        javadoc(f"Sets {{@code {name}}}: {about}", ("@param value the new value", "@return these options"))
        + f"    public Options {name}({kind} value) {{\n        return set({key}, {given});\n    }}\n\n"
        + javadoc(f"{{@code {name}}}: {about}", ("@return the value",))
        + f"    public {kind} {name}() {{\n        return {got};\n    }}\n\n"
    )


def enumeration(name, comment, constants, source):
    """A file with an enumeration whose constants know their number."""
    out = f"// {text.MADE_BY} from {source}.\npackage org.cleft;\n\n{javadoc(comment, indent=0)}public enum {name} {{\n"
    return (
        out + _constants(constants, True) + f";\n\n    final int number;\n\n    {name}(int number) {{\n"
        "        this.number = number;\n    }\n}\n"
    )


def _constants(rows, with_number, indent=4):
    """The constants of an enumeration, with the number that C has for them or without."""
    pad = " " * indent
    lines = [
        f"{javadoc(text.sentence(about), indent=indent)}{pad}{name}"
        + (f"(CleftNative.{c_name})" if with_number else "")
        for name, about, c_name in rows
    ]
    return ",\n".join(lines)


_JAVA = {"whole": "long", "label": "int", "real": "double", "flag": "boolean", "list": "List<Long>"}
# What a record has besides the fields of its struct, which its maker is given: type, name, text, argument and value.
_MORE = {
    "Validation": (
        (
            "String",
            "firstFault",
            'the first fault and its place, "" if there is none',
            "sentence",
            'row.getValid() != 0 ? "" : sentence',
        ),
    )
}


def _record(name, about, values):
    more = _MORE.get(name, ())
    tags = [f"@param {text.camel(v.name)} {v.about}" for v in values] + [
        f"@param {n} {words}" for _, n, words, _, _ in more
    ]
    declared = [f"{_JAVA[v.kind]} {text.camel(v.name)}" for v in values] + [f"{kind} {n}" for kind, n, _, _, _ in more]
    lists = [v for v in values if v.kind == "list"]
    given = []
    for v in values:
        get = f"row.get{v.name[0].upper()}{v.name[1:]}()"
        given.append(
            f"List.of({text.camel(v.name)})" if v.kind == "list" else f"{get} != 0" if v.kind == "flag" else get
        )
    given += [expression for _, _, _, _, expression in more]
    out = f"// {text.MADE_BY} from include/cleft/cleft.h.\npackage org.cleft;\n\n"
    out += "import java.util.List;\n\n" if lists else ""
    out += javadoc(about, tags, indent=0) + f"public record {name}(\n        " + ",\n        ".join(declared) + ") {\n"
    out += f"    static {name} of(Native{name} row{''.join(f', {kind} {e}' for kind, _, _, e, _ in more)}) {{\n"
    for v in lists:
        element = plain_values.ELEMENTS[v.name]
        out += (
            f"        Long[] {text.camel(v.name)} = new Long[{v.length}];\n"
            f"        for (int index = 0; index < {v.length}; ++index)\n"
            f"            {text.camel(v.name)}[index] = row.{element}(index);\n"
        )
    return out + f"        return new {name}(\n                " + ",\n                ".join(given) + ");\n    }\n}\n"


_RECORDS = {
    "Estimate": "The expected size of a mesh.",
    "Quality": "Measures of the shape of a mesh, in world units.",
    "MetricQuality": "How well a mesh meets a metric, which measures an edge of the wanted length as 1.",
    "Validation": "The faults of a mesh. All counts of faults are 0 for a valid mesh.",
    "LabelReport": "What became of one label. Volumes are in cubic world units.",
    "Contact": "Two labels that share triangles in the mesh, although no two of their voxels share a face or an edge. "
    "The gap between them is narrower than the tetrahedra there, and a smaller size opens it.",
    "Distance": "How far an interface of the mesh is from that of the volume, in world units, or a line where three "
    "labels meet.",
}


def files(tree, table):
    path = f"{FOLDER}/Options.java"
    accessors = "".join(_accessors(option, table.options) for option in table.options)
    made = {path: text.region(tree.read(path), path, "options", "\n" + accessors, ("//", ""))}
    for name, comment, rows in plain_values.choices(table):
        made[f"{FOLDER}/{name}.java"] = enumeration(name, comment, rows, option_table.PATH)
    for path, prefix, with_number, indent in (
        ("VoxelType.java", "CLEFT_TYPE_", True, 4),
        ("Side.java", "CLEFT_SIDE_", False, 4),
        ("Log.java", "CLEFT_LOG_", False, 8),
        ("OptionDescription.java", "CLEFT_OPTION_TYPE_", False, 8),
    ):
        _, rows = plain_values.enumeration(tree, prefix)
        end = ";\n" if with_number or path == "Log.java" else "\n"
        path = f"{FOLDER}/{path}"
        made[path] = text.region(
            tree.read(path), path, "constants", _constants(rows, with_number, indent) + end, ("//", "")
        )
    path = f"{FOLDER}/MeshFiles.java"
    made[path] = tree.read(path)
    for name, prefix, first in plain_values.IN_FILES:
        _, rows = plain_values.enumeration(tree, prefix, first)
        made[path] = text.region(made[path], path, name, _constants(rows, False, 8) + "\n", ("//", ""))
    for name, values in plain_values.records(tree).items():
        made[f"{FOLDER}/{name}.java"] = _record(name, _RECORDS[name], values)
    return made
