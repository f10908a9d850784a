#!/usr/bin/python3
"""What an installed Python package tells of itself (its .dist-info folder): for the wheel, and for `cmake --install`.
"""
import argparse
import base64
import hashlib
import pathlib

SOURCE = pathlib.Path(__file__).resolve().parents[2]
METADATA = """Metadata-Version: 2.1
Name: cleft
Version: {version}
Summary: Conforming multi-material tetrahedral meshes from labelled volumes
Author: The Cleft authors
License: {licence}
License-File: LICENSE
License-File: NOTICE
Keywords: mesh generation,tetrahedra,segmentation,image-based meshing,finite elements
Classifier: Development Status :: 4 - Beta
Classifier: Intended Audience :: Science/Research
{licences}Classifier: Operating System :: POSIX :: Linux
Classifier: Programming Language :: C++
Classifier: Programming Language :: Python :: 3 :: Only
Classifier: Programming Language :: Python :: 3.11
Classifier: Topic :: Scientific/Engineering
Classifier: Typing :: Typed
Requires-Python: >=3.11
Requires-Dist: numpy
Requires-Dist: matplotlib; extra == "plot"
Requires-Dist: pyvista; extra == "plot"
Requires-Dist: meshio; extra == "meshio"
Provides-Extra: plot
Provides-Extra: meshio
Description-Content-Type: text/markdown

{description}"""

CLASSIFIERS = {
    "MIT": "MIT License",
    "AGPL-3.0-or-later": "GNU Affero General Public License v3 or later (AGPLv3+)",
}


def folder_name(version):
    return f"cleft-{version}.dist-info"


def add_licence_to(parser):
    """The arguments that say what the build is made of."""
    parser.add_argument("--licence", required=True, help="of the whole, as an SPDX expression")
    parser.add_argument("--notice", required=True, type=pathlib.Path, help="the file that says what follows")


def files(options):
    """The files of the folder, but for RECORD and what the way of installing adds: {name: contents}."""
    licences = "".join(
        f"Classifier: License :: OSI Approved :: {name}\n"
        for word, name in CLASSIFIERS.items()
        if word in options.licence.split()
    )
    description = (SOURCE / "docs/python.md").read_text(encoding="utf-8")
    return {
        "METADATA": METADATA.format(
            version=options.version, licence=options.licence, licences=licences, description=description
        ).encode(),
        "NOTICE": options.notice.read_bytes(),
        "LICENSE": (SOURCE / "LICENSE").read_bytes(),
    }


def record(contents, version):
    """RECORD, of {path from the folder of packages: contents}."""
    lines = []
    for name, data in contents.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        lines.append(f"{name},sha256={digest},{len(data)}\n")
    return ("".join(lines) + f"{folder_name(version)}/RECORD,,\n").encode()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--version", required=True)
    parser.add_argument("--packages", required=True, type=pathlib.Path, help="the folder that has the package cleft")
    add_licence_to(parser)
    options = parser.parse_args()

    own = {**files(options), "INSTALLER": b"cmake\n"}
    package = options.packages / "cleft"
    contents = {f"cleft/{path.name}": path.read_bytes() for path in sorted(package.iterdir()) if path.is_file()}
    contents.update({f"{folder_name(options.version)}/{name}": data for name, data in own.items()})
    folder = options.packages / folder_name(options.version)
    folder.mkdir(exist_ok=True)
    for name, data in {**own, "RECORD": record(contents, options.version)}.items():
        (folder / name).write_bytes(data)


if __name__ == "__main__":
    main()
