"""The references of C and of C++: what Doxygen makes of the headers.

Doxygen reads copies of them with its marks. The comment at the top is one on the file, and each section is a module,
with a page of its own. Fields whose type says everything have no comment in the header, and get one.
"""
import re
import subprocess

SECTION = re.compile(r"/\* -{3,} (.+) -- \*/\n")
END_OF_EXTERN = "#ifdef __cplusplus\n}"
FOR_COMPILERS = re.compile(r"^#define CLEFT_(?:IO_)?(?:API|NOEXCEPT|NODISCARD)\b.*\n", re.MULTILINE)
VERSION = re.compile(r"^(#define CLEFT_VERSION_\w+ .*)$", re.MULTILINE)
FIELD = re.compile(r"^(    (\w+) (\w+);)$", re.MULTILINE)
HOME = '<p style="margin: 8px 14px"><a href="../../index.html">Cleft: all pages</a></p>\n'
FIRST_PAGES = {
    "cleft.h": """
/** \\mainpage
The modules are the sections of the headers. The description of cleft.h has the conventions of all functions. */
""",
    "cleft.hpp": """
/** \\mainpage
The classes of cleft.hpp own what the functions of C make. Files are in cleft_io.hpp. */
""",
}
LANGUAGES = {
    "c": "FILE_PATTERNS = *.h\nEXCLUDE_PATTERNS = */cleft_mpi.h\n"
    'OPTIMIZE_OUTPUT_FOR_C = YES\nPROJECT_NAME = "Cleft in C"',
    # Most members have the name that the header of C explains, and no comment of their own.
    "cpp": 'FILE_PATTERNS = *.hpp\nEXTRACT_ALL = YES\nPROJECT_NAME = "Cleft in C++"',
}


def with_comment(field):
    """A field of a struct with the comment that its name or type stands for."""
    whole, kind, name = field.groups()
    known = {"struct_size": "sizeof of this struct, which the caller sets", "reserved": "0"}
    if name in known:
        return f"{whole} /**< {known[name]} */"
    return f"{whole} /**< one of #{kind} */" if kind.startswith("cleft_") else whole


def module(stem, name):
    """The mark that ends the module before, and begins the one of this name."""
    identifier = re.sub(r"\W+", "_", f"{stem}_{name}")
    title = f"Files: {name}" if stem == "cleft_io" else name.capitalize()
    return f"/** \\}} */\n/** \\defgroup {identifier} {title}\n *  In {stem}.h.\n *  \\{{ */\n"


def with_statuses(text):
    """The header of the statuses, with the enumeration that the compiler makes of their list."""
    listed = re.findall(r'^    X\((\w+), (-?\d+), "(.*)"\)', text, re.MULTILINE)
    values = "".join(f"    CLEFT_{name} = {number}, /**< {meaning} */\n" for name, number, meaning in listed)
    text = re.sub(r"^/\* The list.*?^\};\n", "", text, flags=re.DOTALL | re.MULTILINE)
    about = "/** \\file\n *  Status codes of libcleft. */\n"
    opened = "/** \\defgroup cleft_status Statuses\n *  In cleft_status.h.\n *  \\{ */\n"
    return f"{about}{opened}/** Status codes. */\nenum {{\n{values}}};\n{text}/** \\}} */\n"


def marked(stem, text):
    """The text of a header with the marks of Doxygen. The name of the header is in those of its modules."""
    text = re.sub(r"\A/\*\n \* ", r"/** \\file\n * ", text)
    text = FOR_COMPILERS.sub("", text)
    if stem == "cleft_status":
        return with_statuses(text)
    text = VERSION.sub(r"\1 /**< the version of this header */", text)
    text = FIELD.sub(with_comment, text)
    if not SECTION.search(text):
        return text
    if END_OF_EXTERN not in text:
        raise SystemExit("a header with sections does not end with the brace of its extern")
    text = SECTION.sub(lambda found: module(stem, found[1]), text)
    return text.replace("/** \\} */\n", "", 1).replace(END_OF_EXTERN, "/** \\} */\n" + END_OF_EXTERN)


def page_head(work):
    """A file with Doxygen's own head of a page and a way back to the other pages."""
    head = work / "doxygen_head.html"
    command = ("doxygen", "-w", "html", head, work / "doxygen_foot.html", work / "doxygen.css")
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    head.write_text(head.read_text().replace('<div id="top">', HOME + '<div id="top">', 1))
    return head


def without_dead_summary(page):
    """Doxygen lists classes in the summary of a class that has private ones alone, which it does not show."""
    text = page.read_text()
    link = '<a href="#nested-classes">Classes</a> &#124;\n'
    if link in text and 'id="nested-classes"' not in text:
        page.write_text(text.replace(link, ""))


def make(root, work, output, version):
    """Makes the folders `c` and `cpp` in `output`."""
    headers = work / "headers"
    (headers / "cleft").mkdir(parents=True)
    for path in (root / "include/cleft").glob("*.h*"):
        (headers / "cleft" / path.name).write_text(marked(path.stem, path.read_text()) + FIRST_PAGES.get(path.name, ""))
    settings = [
        (root / "tools/site/Doxyfile").read_text(),
        f'INPUT = "{headers}/cleft"\nSTRIP_FROM_PATH = "{headers}"',
        f'PROJECT_NUMBER = {version}\nHTML_HEADER = "{page_head(work)}"',
    ]
    for language, own in LANGUAGES.items():
        folder = output / language
        folder.mkdir(parents=True)
        lines = "\n".join((*settings, own, f'OUTPUT_DIRECTORY = "{folder}"'))
        subprocess.run(("doxygen", "-"), input=lines, text=True, check=True)
        for page in folder.glob("class*.html"):
            without_dead_summary(page)
