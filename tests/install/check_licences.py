"""Each package says what it is made of: the install tree, the jar, the wheel and the NuGet package of this build, and
the notice of a build without TetGen. check_licences.py BUILD SOURCE PREFIX LICENCE."""
import pathlib
import subprocess
import sys
import tempfile
import zipfile

BUILD, SOURCE, PREFIX = map(pathlib.Path, sys.argv[1:4])
LICENCE = sys.argv[4]
CONSEQUENCE = "must offer them the source of the whole work under the AGPL"
# Of each package: the name of the file of the notice, of the licence, and of the line in which LICENCE stands.
PACKAGES = {
    "bindings/java/cleft-*.jar": ("META-INF/NOTICE", "META-INF/LICENSE", "META-INF/MANIFEST.MF", "Bundle-License: %s"),
    "bindings/python/cleft-*.whl": ("*.dist-info/NOTICE", "*.dist-info/LICENSE", "*.dist-info/METADATA", "License: %s"),
    "bindings/csharp/Cleft.*.nupkg": ("LICENSE.txt", "LICENSE.txt", "Cleft.nuspec", "Licences: %s;"),
}


def check(holds, what):
    if not holds:
        sys.exit(what)


def check_notice(text, tetgen, where):
    check("libcleft: Eigen" in text, f"{where} does not name Eigen")
    check((CONSEQUENCE in text) == tetgen, f"{where} is wrong about what follows")
    check(("libcleft: TetGen 1.5, AGPL-3.0-or-later" in text) == tetgen, f"{where} is wrong about TetGen")


def member(package, pattern):
    (name,) = [name for name in package.namelist() if pathlib.PurePath(name).match(pattern) and name.count("/") < 2]
    return package.read(name).decode()


def main():
    tetgen = "AGPL" in LICENCE
    own = (SOURCE / "LICENSE").read_text().split("\n\n")[2]
    (notice,) = PREFIX.rglob("doc/cleft/NOTICE")
    check_notice(notice.read_text(), tetgen, notice)
    for pattern, (notice, licence, told_in, line) in PACKAGES.items():
        for path in BUILD.glob(pattern):
            package = zipfile.ZipFile(path)
            check_notice(member(package, notice), tetgen, path)
            check(own in member(package, licence), f"{path} is without the text of the licence")
            check(line % LICENCE in member(package, told_in).replace("\r\n", "\n"), f"{path} does not say {LICENCE}")
            print("ok", path)

    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(
            [
                "cmake",
                "-S",
                SOURCE,
                "-B",
                folder,
                "-G",
                "Ninja",
                "-DCLEFT_WITH_TETGEN=OFF",
                "-DCLEFT_WITH_IO=OFF",
                "-DCLEFT_BUILD_TESTS=OFF",
                "-DCLEFT_BUILD_FORTRAN=OFF",
            ],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        text = (pathlib.Path(folder) / "install/NOTICE").read_text()
        check_notice(text, False, "the notice without TetGen")
        check("TetGen" not in text and "AGPL" not in text, "the notice without TetGen names it")


main()
