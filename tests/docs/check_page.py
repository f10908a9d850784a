"""Builds and runs the programs in the page of a language, as a reader would copy them, with the installed library
alone.

check_page.py LANGUAGE PREFIX LIBDIR. Every fenced block of the page is used: one more on it without a use here is a
failure, so that no program can be on a page and never have run. Blocks that are parts of programs are completed here.
"""
import glob
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LANGUAGE, PREFIX, LIBDIR = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
TETRAHEDRA = r"[1-9][0-9]+ +tetrahedra"
ENVIRONMENT = {
    **os.environ,
    "PKG_CONFIG_PATH": str(PREFIX / LIBDIR / "pkgconfig"),
    "LD_LIBRARY_PATH": str(PREFIX / LIBDIR),
    "PYTHONPATH": str(PREFIX / "lib/python3/dist-packages"),
    "MPLBACKEND": "Agg",
}


def blocks(page):
    """The fenced blocks of a page: pairs of language and text."""
    return re.findall(r"^```(\w+)\n(.*?)^```$", (ROOT / page).read_text(), re.DOTALL | re.MULTILINE)


def commands(page, *starts):
    """The indented lines of a page that begin with these words."""
    lines = [line.strip() for line in (ROOT / page).read_text().splitlines() if line.startswith("    ")]
    return [next(line for line in lines if line.startswith(start)) for start in starts]


def run(*lines, expect=""):
    """Runs lines of the shell here, and looks for an expression in what the last one prints."""
    for line in lines:
        print("$", line, flush=True)
        done = subprocess.run(line, shell=True, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True)
        print(done.stdout, flush=True)
        if done.returncode:
            sys.exit(f"it failed: {line}")
    if not re.search(expect, done.stdout):
        sys.exit(f'"{expect}" was not printed')


def write(name, *texts):
    pathlib.Path(name).write_text("\n".join(texts))


def build_by_cmake(language, source, block):
    write(
        "CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.20)",
        f"project(app LANGUAGES {language})",
        f"add_executable(app {source})",
        block,
    )
    run(f"cmake -B build -DCMAKE_PREFIX_PATH={PREFIX} -Wno-dev", "cmake --build build", "build/app", expect=TETRAHEDRA)


def check_libraries(page):
    """The page names the Debian packages of all libraries that the installed ones use, but the compiler's."""
    if not shutil.which("dpkg-query"):
        return
    needed = set()
    for library in ("libcleft.so", "libcleft_io.so"):
        listed = subprocess.run(
            ["readelf", "-d", PREFIX / LIBDIR / library], stdout=subprocess.PIPE, text=True, check=True
        )
        needed |= set(re.findall(r"NEEDED.*\[(.*)\]", listed.stdout))
    packages = set()
    for name in needed - {"libcleft.so.0"}:
        found = subprocess.run(["dpkg-query", "-S", f"*/{name}"], stdout=subprocess.PIPE, text=True, check=True).stdout
        packages |= set(re.findall(rf"^([^:,\s]+)[:,].*/{re.escape(name)}$", found, re.MULTILINE))
    packages = {package for package in packages if not re.match(r"libc6|lib\w*gcc|lib\w*stdc", package)}
    assert packages, needed
    missing = sorted(package for package in packages if f"`{package}`" not in (ROOT / page).read_text())
    if missing:
        sys.exit(f"{page} does not name the libraries of {', '.join(missing)}")


def check_c():
    (_, ten), (_, cmake), (_, cpp) = blocks("docs/c.md")
    write("ten.c", ten)
    run(*commands("docs/c.md", "cc ten.c"), "./a.out", expect=TETRAHEDRA)
    run(*commands("docs/c.md", "cc ten.c $(pkg-config --static"), "ldd a.out", expect=r"(?s)^(?!.*libcleft\.so)")
    run("./a.out", expect=TETRAHEDRA)
    write("example.cpp", cpp)
    run(*commands("docs/c.md", "c++ example.cpp"), "./a.out", expect=TETRAHEDRA)
    build_by_cmake("C", "ten.c", cmake)

    ((_, part),) = blocks("README.md")
    includes, part = part.split("\n\n", 1)
    write(
        "readme.c",
        includes,
        "#include <stdio.h>",
        "int main(void)",
        "{",
        "static unsigned char voxels[64 * 64 * 64];",
        part,
        'return printf("%lld tetrahedra of %d, at %g\\n", (long long)cleft_mesh_tet_count(mesh), labels[0],',
        "points[3 * tets[0]]) < 0;",
        "}",
    )
    run("cc -Wall -Werror readme.c $(pkg-config --cflags --libs cleft)", "./a.out", expect=TETRAHEDRA)


def check_fortran():
    (_, ten), (_, cmake), (_, listen), (_, errors) = blocks("docs/fortran.md")
    write("ten.f90", ten)
    run(*commands("docs/fortran.md", "gfortran ten.f90"), "./a.out", expect=TETRAHEDRA)
    build_by_cmake("Fortran", "ten.f90", cmake)

    write(
        "parts.f90",
        "module reports",
        "use, intrinsic :: iso_c_binding",
        "implicit none",
        "contains",
        listen,
        "end module",
        "program parts",
        "use cleft",
        "use reports",
        "type(cleft_context) :: context",
        "type(cleft_options) :: options",
        "type(cleft_volume) :: volume",
        "type(cleft_mesh) :: mesh",
        "integer :: stat, voxels(20, 20, 20)",
        "character(len=200) :: errmsg",
        errors,
        "voxels = 0",
        "call volume%create(context, voxels)",
        "call context%set_progress(listen)",
        "call mesh%create(context, volume, stat=stat)",
        "if (stat /= CLEFT_ERROR_CANCELLED) error stop 'listen() has not cancelled the call'",
        "end program",
    )
    sentence = re.search(r"print .*! (.*)", errors).group(1)
    run("gfortran -Wall parts.f90 $(pkg-config --cflags --libs cleft-fortran)", "./a.out", expect=re.escape(sentence))


def check_java():
    ((_, ten),) = blocks("docs/java.md")
    imports, body = ten.split("\n\n", 1)
    write("Program.java", imports, "class Program { public static void main(String[] arguments) {", body, "} }")
    (jar,) = glob.glob(f"{PREFIX}/share/java/cleft-*.jar")
    shutil.copy(jar, ".")
    start = re.search(r"`(java -cp .* Program)`", (ROOT / "docs/java.md").read_text()).group(1)
    run(f"javac -cp {os.path.basename(jar)} Program.java", start, expect=TETRAHEDRA)
    assert os.path.getsize("cube.vtu") > 0


def check_csharp():
    ((_, ten),) = blocks("docs/csharp.md")
    imports, body = ten.split("\n\n", 1)
    write("Program.cs", imports, "class Program { static void Main() {", body, "} }")
    (package,) = glob.glob(f"{PREFIX}/share/cleft/Cleft.*.nupkg")
    shutil.copy(package, ".")
    run(*commands("docs/csharp.md", "unzip", "cp cleft/", "mcs"), expect=TETRAHEDRA)
    assert os.path.getsize("cube.vtu") > 0


def check_python():
    (_, ten), (_, masks), (_, missing) = blocks("docs/python.md")
    write("ten.py", ten)
    run(f"{sys.executable} ten.py", expect=TETRAHEDRA)
    write(
        "parts.py",
        ten,
        masks,
        "assert cleft.Volume(together).labels.tolist() == [0, 1, 2]",
        "import importlib.metadata",
        "assert importlib.metadata.version('cleft') == cleft.__version__",
        missing,
    )
    printed = re.search(r"print\(error.*# (.*)", missing).group(1)
    run(f"{sys.executable} parts.py", expect=re.escape(printed))
    assert os.path.getsize("cube.vtu") > 0 and os.path.getsize("cube.png") > 0


if LANGUAGE != "c":
    check_libraries(f"docs/{LANGUAGE}.md")
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    globals()["check_" + LANGUAGE]()
