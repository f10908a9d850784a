"""The reference of C#: the XML documentation of the compiler, a page for each public type.

The XML has no declarations. Signatures.cs reads them from the assembly.
"""
import re
import subprocess
import xml.etree.ElementTree as ElementTree

SECTIONS = (
    ("Constructors", re.compile(r"M:.*\.#ctor")),
    ("Properties", re.compile("P:")),
    ("Fields", re.compile("F:")),
    ("Methods", re.compile(r"M:(?!.*\.#ctor)")),
)


def short(identifier):
    """`M:Cleft.Mesh.CopyTets(System.Int32)` as `Mesh.CopyTets`."""
    name = re.sub(r"\(.*", "", identifier[2:]).removeprefix("Cleft.")
    return re.sub(r"`+\d+", "", name).replace(".#ctor", "")


class Texts:
    """The sentences of the XML, as Markdown. `pages` has the page of each type."""

    def __init__(self, path, pages):
        self.members = {member.get("name"): member for member in ElementTree.parse(path).getroot().iter("member")}
        self.pages = pages

    def link(self, identifier):
        owner, anchor = identifier, ""
        if not identifier.startswith("T:"):
            owner, _, name = re.sub(r"\(.*", "", identifier).rpartition(".")
            owner, anchor = "T:" + owner[2:], "#" + name.lower()
        name = f"`{short(identifier)}`"
        return f"[{name}]({self.pages[owner]}{anchor})" if owner in self.pages else name

    def plain(self, element):
        """The text of an element, with the elements in it."""
        parts = [element.text or ""]
        for child in element:
            if child.tag == "see" and child.get("cref"):
                parts.append(self.link(child.get("cref")))
            elif child.tag == "see":
                parts.append(f"`{child.get('langword')}`")
            elif child.tag in ("paramref", "typeparamref"):
                parts.append(f"`{child.get('name')}`")
            elif child.tag == "c":
                parts.append(f"`{child.text}`")
            elif child.tag == "code":
                parts.append(f"\n\n```csharp\n{child.text.strip()}\n```\n\n")
            elif child.tag == "para":
                parts.append("\n\n" + self.plain(child) + "\n\n")
            elif child.tag != "inheritdoc":
                raise SystemExit(f"csharp_reference.py does not know <{child.tag}>")
            parts.append(child.tail or "")
        return re.sub(r"^ +", "", "".join(parts), flags=re.MULTILINE).strip()

    def of(self, identifier):
        """All that the XML has on a type or member."""
        member = self.members.get(identifier)
        if member is None:
            return ""
        lines = []
        for element in member:
            if element.tag in ("summary", "remarks"):
                lines.append(self.plain(element))
            elif element.tag == "inheritdoc":
                lines.append("As in the base class.")
        arguments = [
            f"- `{element.get('name')}`: {self.plain(element)}"
            for element in member
            if element.tag in ("param", "typeparam")
        ]
        lines += ["\n".join(arguments)] if arguments else []
        lines += [f"Returns {self.plain(element)}" for element in member.iter("returns")]
        lines += [f"Throws {self.link(one.get('cref'))}: {self.plain(one)}" for one in member.iter("exception")]
        return "\n\n".join(line for line in lines if line)


def types_of(lines):
    """The lines of Signatures.cs by type: pairs of identifier and declaration."""
    types = {}
    for line in lines:
        identifier, _, declaration = line.partition("\t")
        if identifier.startswith("T:"):
            members = types.setdefault(identifier, (declaration, []))[1]
        else:
            members.append((identifier, declaration))
    return types


def entry(heading, declaration, text):
    return [heading, f"```csharp\n{declaration}\n```", text]


def members_of(texts, identifier, members):
    """Sections of members. Those without a text are constructors that nobody wrote."""
    lines = []
    for title, kind in SECTIONS:
        found = [pair for pair in members if kind.match(pair[0]) and pair[0] in texts.members]
        lines += [f"## {title}"] if found else []
        for member, declaration in found:
            name = short(member).removeprefix(short(identifier) + ".")
            lines += entry(f"### {name}", declaration, texts.of(member))
    return lines


def values_of(texts, members):
    """The table of an enumeration."""
    rows = [
        f"| `{declaration.partition(' = ')[0]}` | {declaration.partition(' = ')[2]} | {texts.of(member)} |"
        for member, declaration in members
    ]
    return ["\n".join(("| value | number | |", "|---|---|---|", *(row.replace("\n", " ") for row in rows)))]


def undocumented(texts, types):
    for identifier, (_, members) in types.items():
        for name in (identifier, *(member for member, _ in members)):
            if name not in texts.members and not name.endswith(".#ctor"):
                yield name


def make(root, work, generated, output):
    """Writes the pages into `output`, with the sources that SWIG made. What has no comment fails."""
    sources = sorted((root / "bindings/csharp/src").glob("*.cs")) + sorted(generated.glob("*.cs"))
    assembly, documentation, program = work / "Cleft.dll", work / "Cleft.xml", work / "Signatures.exe"
    compiler = ("mcs", "-langversion:7.2", "-warnaserror")
    flags = ("-target:library", "-noconfig", "-unsafe", "-nowarn:0649", f"-doc:{documentation}", f"-out:{assembly}")
    subprocess.run((*compiler, *flags, *sources), check=True)
    subprocess.run((*compiler, f"-out:{program}", root / "tools/site/Signatures.cs"), check=True)
    listed = subprocess.run(("mono", program, assembly), check=True, text=True, stdout=subprocess.PIPE).stdout
    types = types_of(listed.splitlines())
    texts = Texts(documentation, {identifier: short(identifier) + ".md" for identifier in types})
    missing = list(undocumented(texts, types))
    if missing:
        raise SystemExit("these have no comment: " + ", ".join(missing))
    output.mkdir(parents=True)
    rows = []
    for identifier, (declaration, members) in types.items():
        lines = entry(f"# {short(identifier)}", declaration, texts.of(identifier))
        is_enumeration = declaration.startswith("public enum")
        lines += values_of(texts, members) if is_enumeration else members_of(texts, identifier, members)
        (output / texts.pages[identifier]).write_text("\n\n".join(line for line in lines if line) + "\n")
        summary = texts.plain(texts.members[identifier].find("summary")).replace("\n", " ")
        first = re.split(r"(?<=[.:;]) ", summary)[0].rstrip(".:;")
        rows.append(f"| [{short(identifier)}]({texts.pages[identifier]}) | {first} |")
    about = "The public types of `Cleft`. [Cleft from C#](../../docs/csharp.md) introduces them."
    table = "\n".join(("| type | |", "|---|---|", *rows))
    (output / "README.md").write_text("\n\n".join(("# Reference of C#", about, table)) + "\n")
