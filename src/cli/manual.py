"""Writes the manual pages of the command from its own help: manual.py CLEFT VERSION FOLDER makes cleft.1, cleft-mesh.1
...; likewise for cleft-mpi.

The help is made of a line that says what the command does, the usage, paragraphs, and sections: a heading at the margin
that ends with a colon, followed by indented lines, an item and (after two blanks or more, or on further lines) its
text.
"""
import pathlib
import re
import subprocess
import sys

VERBATIM = ("Examples",)


def escaped(text):
    text = text.replace("\\", r"\e").replace("-", r"\-")
    return r"\&" + text if text.startswith((".", "'")) else text


def sections(lines):
    """Heading -> its lines; paragraphs between the sections come under "Notes"."""
    found, heading = {}, None
    for line in lines:
        if re.fullmatch(r"\S.*:", line):
            heading = line[:-1]
            found[heading] = []
        elif line.startswith(" ") and heading:
            found[heading].append(line)
        elif line.startswith("Exit codes: "):
            heading = "Exit codes"
            found[heading] = [line.removeprefix("Exit codes: ")]
        elif line and heading == "Exit codes":
            found[heading].append(line)
        elif line:
            found.setdefault("Notes", []).append(line)
    return found


def items(lines):
    """An item a list: the item itself, then the words about it."""
    found = []
    for line in lines:
        item = re.match(r"  (\S.*?)(?:  +(.*))?$", line)
        if item and not line.startswith("   "):
            found.append([item.group(1), item.group(2) or ""])
        else:
            found[-1].append(line.strip())
    return [(item, " ".join(text).strip()) for item, *text in found]


def page(name, help_text, version):
    summary, usage, *lines = help_text.splitlines()
    purpose = summary[0].lower() + summary[1:].rstrip(".")
    out = [
        f'.TH {name.upper()} 1 "" "Cleft {version}" "User Commands"',
        ".SH NAME",
        f"{escaped(name)} \\- {escaped(purpose)}",
        ".SH SYNOPSIS",
        rf"\fB{escaped(usage.removeprefix('Usage: '))}\fR",
    ]
    for heading, body in sections(lines).items():
        out.append(f'.SH "{heading.upper()}"')
        if heading in VERBATIM:
            out += [".nf", *(escaped(line.strip()) for line in body), ".fi"]
        elif body and body[0].startswith(" "):
            for item, text in items(body):
                out += [".TP", rf"\fB{escaped(item)}\fR", escaped(text)]
        else:
            out.append(escaped(" ".join(body)))
    return "\n".join(out) + "\n"


def main():
    program, version, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])

    def help_of(*command):
        return subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True).stdout

    whole = help_of()
    commands = [item for item, _ in items(sections(whole.splitlines())["Subcommands"])]
    folder.mkdir(parents=True, exist_ok=True)
    name = pathlib.Path(program).name
    (folder / f"{name}.1").write_text(page(name, whole, version))
    for command in commands:
        (folder / f"{name}-{command}.1").write_text(page(f"{name}-{command}", help_of(command), version))


main()
