"""Do docs/gallery.md, and docs/guide.md where it shows metrics, show what their commands make?

check_gallery.py CLEFT. All commands of the pages have options that there are, inputs that there are, and pictures of
the size that they name, which the page shows. The meshes of QUICK are made anew: their figures and pictures must be
those of the page.
"""
import pathlib
import re
import struct
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CLEFT = pathlib.Path(sys.argv[1]).resolve()
QUICK = ("grains", "equal", "fibres")
MOST_BYTES = 2_000_000  # of all pictures: each of their states stays in the repository

sys.path.insert(0, str(ROOT / "benchmarks"))
import gallery  # noqa: E402
import gallery_volumes  # noqa: E402


def check(holds, what):
    if not holds:
        sys.exit(what)


def options_of(subcommand):
    text = subprocess.run((CLEFT, subcommand, "--help"), check=True, stdout=subprocess.PIPE, text=True).stdout
    return set(re.findall(r"(?<![\w-])--?[a-z][\w-]*", text))


def check_options(subcommand, line, known):
    unknown = set(re.findall(r" (--?[a-z][\w-]*)", re.sub(r"\$\(.*?\)", "", line))) - known[subcommand]
    check(not unknown, f"there is no option {unknown}: {line}")


def generated_files():
    spheres = [f"{name}{number}" for name in gallery_volumes.SPHERES for number in range(3)]
    return {f"out/{name}.nrrd" for name in (*gallery_volumes.LABELS, *spheres)}


def check_inputs(line):
    for path in re.findall(r" (\S+\.(?:nrrd|nii\.gz))", line):
        is_there = path.startswith("/usr/share/") or (ROOT / path).exists() or path in generated_files()
        check(is_there, f"there is no {path}: {line}")


def check_picture(line, page, pictures):
    name = re.search(r"-o out/(\S+\.png)", line)[1]
    check(f"](images/{pictures.name}/{name})" in page, f"the page does not show {name}")
    head = (pictures / name).read_bytes()[:24]
    size = "%dx%d" % struct.unpack(">II", head[16:24])
    check(f"--size {size} " in line + " ", f"{name} has {size} pixels: {line}")
    return name


def check_mesh(mesh, lines, known, page, pictures):
    """Answers the names of the pictures of a mesh."""
    check(lines[0][0] == "mesh", f"{mesh} has no mesh")
    check(f"| {mesh} | " in page, f"{mesh} has no figures")
    for subcommand, line in lines:
        check_options(subcommand, line, known)
        check_inputs(line)
    return {check_picture(line, page, pictures) for subcommand, line in lines if subcommand == "render"}


def check_views(work, page):
    for mesh, lines in work.items():
        check(f"--view out/{mesh}.html" in lines[0][1], f"{mesh} has no view")
        check(f"<!-- view: {mesh} -->\n" in page, f"{mesh} has no place for the link to its view")


def check_page(file, pictures, known, fewest):
    page = file.read_text()
    work = gallery.commands(page)
    check(len(work) >= fewest, f"{file.name} has fewer meshes than it had")
    if file.name == "gallery.md":
        check_views(work, page)
    drawn = set().union(*(check_mesh(mesh, lines, known, page, pictures) for mesh, lines in work.items()))
    kept = {path.name: path.stat().st_size for path in pictures.iterdir()}
    check(kept.keys() == drawn, f"pictures that no command draws: {kept.keys() - drawn}")
    check(sum(kept.values()) < MOST_BYTES, f"the pictures of {file.name} have {sum(kept.values())} bytes")


def main():
    known = {subcommand: options_of(subcommand) for subcommand in ("mesh", "render")}
    for (file, pictures), fewest in zip(gallery.PAGES.items(), (9, 6)):
        check_page(file, pictures, known, fewest)
    again = (sys.executable, "-B", ROOT / "benchmarks/gallery.py", "--cleft", CLEFT, "--check", "--only", *QUICK)
    sys.exit(subprocess.run(again).returncode)


main()
