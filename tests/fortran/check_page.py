"""Does docs/fortran.md have the signature of every public procedure? check_page.py [--write] SOURCES PAGE

SOURCES is the folder of the modules. --write makes the part of the page anew that has the signatures.
"""
import pathlib
import re
import sys
import textwrap

HEAD = "## Signatures"
MODULES = ("contexts", "option_sets", "volumes", "sizings", "meshes", "surfaces", "reports", "support", "io")
# Arguments that are described once, above all signatures.
COMMON = {
    "context": "type(cleft_context), intent(inout)",
    "options": "type(cleft_options), intent(inout), optional",
    "volume": "type(cleft_volume), intent(in)",
    "spacing": "real(c_double) (3), intent(in), optional",
    "origin": "real(c_double) (3), intent(in), optional",
    "affine": "real(c_double) (3, 4), intent(in), optional",
    "stat": "integer, intent(out), optional",
    "errmsg": "character(len=*), intent(inout), optional",
}


def split(text):
    """The parts between commas that are in no brackets."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter == "(") - (letter == ")")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


def procedures(text):
    """{name: (kind, arguments, {variable: declaration}, result)} of the procedures of a module."""
    found = {}
    body = text.split("\ncontains\n", 1)[1]
    for kind, name, arguments, result, lines in re.findall(
        r"^  (?:pure |impure |elemental )*(subroutine|function) (\w+)\((.*?)\)(?: result\((\w+)\))?\n(.*?)^  end \1",
        body,
        re.M | re.S,
    ):
        declared = {}
        for kinds, names in re.findall(r"^    ([a-z].*?) :: (.*)$", lines, re.M):
            for entity in split(names):
                variable, shape = re.match(r"(\w+)(\(.*\))?", entity).groups()
                kind_only, *attributes = split(re.sub(r", (?:allocatable|contiguous|target)", "", kinds))
                declared[variable] = ", ".join([kind_only + (f" {shape}" if shape else ""), *attributes])
        found[name] = (kind, split(arguments), declared, result or name)
    return found


def signature(call, procedure):
    kind, arguments, declared, result = procedure
    words = []
    for argument in arguments:
        if argument == "self":
            continue
        described = declared.get(argument, "procedure, optional")
        word = argument if described == COMMON.get(argument) else f"{argument}: {described}"
        word = re.sub(r", intent\(in\)", "", word).replace(", optional", "")
        words.append(f"[{word}]" if "optional" in described else word)
    text = f"{call}({', '.join(words)})"
    if kind == "function":
        return f"{text} -> {declared[result]}"
    return f"call {text}"


def bound(body):
    """(public name, procedure) of the procedures that a type has."""
    for line in body.splitlines():
        if match := re.fullmatch(r" *procedure :: (.*)", line):
            for entry in split(match[1]):
                name, _, target = entry.partition(" => ")
                yield name, target or name
        elif match := re.fullmatch(r" *generic :: (\w+) => (.*)", line):
            for target in split(match[2]):
                yield match[1], target


def is_offered(folder, module, name):
    """Does a program get the name by `use cleft` or `use cleft_io`?"""
    used = re.search(rf"use cleft_{module}(?:, only: (.*))?$", source(folder / "cleft.f90"), re.M)
    return not used or not used[1] or name in split(used[1])


def source(path):
    """A module without comments, each statement in one line."""
    return re.sub(r"&\s*\n\s*", "", re.sub(r" *!.*", "", path.read_text()))


def of_types(folder):
    """{type: its signatures}, and the signatures of the procedures that are bound to none."""
    types, free = {}, []
    for module in MODULES:
        text = source(folder / f"cleft_{module}.f90")
        known = procedures(text)
        public = re.findall(r"\w+", " ".join(re.findall(r"^  public :: (.*)$", text, re.M)))
        for name, body in re.findall(r"^  type(?:, extends\(\w+\))? :: (\w+)\n(.*?)^  end type", text, re.M | re.S):
            if name in public:
                types[name] = [
                    signature(f"{name.removeprefix('cleft_')}%{entry}", known[target])
                    for entry, target in bound(body.partition("contains")[2])
                ]
        generic = {
            name: split(targets)
            for name, targets in re.findall(r"^  interface (\w+)\n +module procedure (.*)\n  end interface", text, re.M)
        }
        free += [
            signature(name, known[target])
            for name in public
            if is_offered(folder, module, name)
            for target in generic.get(name, [name])
            if target in known
        ]
    return types, free


def block(lines):
    return [
        "```",
        *(
            textwrap.fill(line, 118, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)
            for line in lines
        ),
        "```",
    ]


def part(folder):
    """The part of the page with the signatures."""
    types, free = of_types(folder)
    lines = [
        HEAD,
        "",
        "Arguments in square brackets are optional. After a colon comes the type, its shape in round brackets;",
        "`intent(in)` is left out. These arguments are the same everywhere:",
        "",
    ]
    lines += block(f"{name}: {described}" for name, described in COMMON.items())
    for name, entries in types.items():
        lines += ["", f"### {name}", "", *block(entries)]
    lines += [
        "",
        "### All types of objects but cleft_context and cleft_options",
        "",
        *block(["call object%destroy()", "object%c_handle() -> type(c_ptr)"]),
    ]
    lines += ["", "### Procedures", "", *block(free)]
    return "\n".join([*lines, ""])


def main():
    write = "--write" in sys.argv
    folder, page = (pathlib.Path(name) for name in sys.argv[-2:])
    text = page.read_text()
    before, _, _ = text.partition(HEAD)
    wanted = before + part(folder)
    if write:
        page.write_text(wanted)
    elif text != wanted:
        old, new = set(text.splitlines()), set(wanted.splitlines())
        sys.exit(
            "docs/fortran.md is not as the sources say; tests/fortran/check_page.py --write mends it:\n"
            + "\n".join([*(f"- {line}" for line in old - new), *(f"+ {line}" for line in new - old)])
        )


main()
