#!/usr/bin/python3
"""Builds the site: all pages, and the references of the languages, with a search. No library need be built.

    tools/site/build.py [FOLDER]   writes the site into FOLDER, in place of a site that is there; build/site without one
    tools/site/build.py --views VIEWS [FOLDER]
        also puts the views that `benchmarks/gallery.py --views VIEWS` wrote beside the gallery

It needs mkdocs-material, Doxygen, SWIG, Java and Mono (tools/setup.sh), and no network. `index.html` can be opened as a
file; browsers allow the search only to pages of a server, as `python3 -m http.server -d build/site`.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import c_reference
import csharp_reference
import pages
import python_reference

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = ("mkdocs", "doxygen", "swig", "javadoc", "mcs", "mono")
OVERVIEW = """# Reference

What each language offers, in full. The pages of the [languages](../docs/c.md) introduce it.

| language | reference | made from |
|---|---|---|
| C | [functions, structs and constants](c/modules.html), [conventions](c/cleft_8h.html) | `cleft.h`, `cleft_io.h` |
| C++ | [classes](cpp/annotated.html), [functions](cpp/namespacecleft.html) | `cleft.hpp`, `cleft_io.hpp` |
| Fortran | [the module `cleft`](../docs/fortran.md); `cleft_c` is C, one to one | |
| Python | [modules](python/README.md) | docstrings of `cleft` |
| Java | [org.cleft](java/index.html) | comments of `org.cleft` |
| C# | [types](csharp/README.md) | XML documentation of `Cleft` |
"""


def version():
    header = (ROOT / "include/cleft/cleft.h").read_text()
    return re.search(r'CLEFT_VERSION_STRING "(.*)"', header)[1]


def wrap(language, folder, *flags):
    """What SWIG writes in a language. The classes of the bindings call it, so their compilers ask for it."""
    folder.mkdir(parents=True)
    for module in ("cleft", "cleft_io"):
        interface = ROOT / f"bindings/swig/{module}.i"
        command = ("swig", f"-{language}", *flags, "-w844", "-DSWIGWORDSIZE64", f"-I{ROOT}/include")
        unused = folder.parent / f"{module}_{language}.c"
        subprocess.run((*command, "-outdir", folder, "-o", unused, interface), check=True)


def java_reference(work, output):
    generated = work / "java"
    wrap("java", generated / "org/cleft", "-package", "org.cleft")
    sources = sorted((ROOT / "bindings/java/src/org/cleft").glob("*.java"))
    home = '<a href="{@docRoot}/../../index.html">Cleft: all pages</a>'
    checks = ("-Xdoclint:all", "-Werror", "-quiet")
    texts = ("-encoding", "UTF-8", "-notimestamp", "-windowtitle", f"Cleft {version()}", "-header", home)
    command = ("javadoc", *checks, *texts, "-sourcepath", generated, "-d", output, *sources)
    subprocess.run(command, check=True)


def build(work, output, views):
    staged = work / "pages"
    staged.mkdir()
    pages.copy_all(ROOT, staged)
    pages.link_views(staged / "docs/gallery.md", views)
    reference = staged / "reference"
    c_reference.make(ROOT, work, reference, version())
    python_reference.make(ROOT, reference / "python")
    java_reference(work, reference / "java")
    wrap("csharp", work / "csharp", "-namespace", "Cleft")
    csharp_reference.make(ROOT, work, work / "csharp", reference / "csharp")
    (reference / "README.md").write_text(OVERVIEW)
    places = {"CLEFT_SITE_PAGES": str(staged), "CLEFT_SITE_OUTPUT": str(output), "PYTHONDONTWRITEBYTECODE": "1"}
    settings = ROOT / "tools/site/mkdocs.yml"
    # mkdocs lists pages outside the navigation, which those of sources are on purpose: quiet unless it fails.
    done = subprocess.run(
        ("mkdocs", "build", "-f", settings),
        env={**os.environ, **places},
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    if done.returncode:
        sys.exit(done.stdout)


def main():
    missing = [program for program in PROGRAMS if not shutil.which(program)]
    if missing:
        sys.exit(f"build.py: {', '.join(missing)} missing; tools/setup.sh lists the packages")
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=ROOT / "build/site", metavar="FOLDER")
    parser.add_argument("--views", type=pathlib.Path)
    arguments = parser.parse_args()
    output = arguments.output.resolve()
    # mkdocs empties the folder.
    if output.exists() and any(output.iterdir()) and not (output / "search/search_index.json").exists():
        sys.exit(f"build.py: {output} has something else than a site in it")
    with tempfile.TemporaryDirectory() as work:
        try:
            build(pathlib.Path(work), output, arguments.views)
        except subprocess.CalledProcessError as error:
            sys.exit(f"build.py: {error.cmd[0]} failed")
    print(f"{output}/index.html is written")


main()
