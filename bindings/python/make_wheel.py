#!/usr/bin/python3
"""Makes a wheel, which pip installs without a network, of the installed files of the Python package and libraries."""
import argparse
import base64
import hashlib
import pathlib
import sysconfig
import zipfile

METADATA = """Metadata-Version: 2.1
Name: cleft
Version: {version}
Summary: Conforming multi-material tetrahedral meshes from labelled volumes
License-File: LICENSE
Requires-Python: >=3.11
Requires-Dist: numpy
"""
WHEEL = "Wheel-Version: 1.0\nGenerator: cleft\nRoot-Is-Purelib: false\nTag: {tag}\n"


def tag():
    python = "cp" + sysconfig.get_config_var("py_version_nodot")
    return f"{python}-{python}-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")


def members(stage):
    """Names in the wheel and the files they come from: the package, and beside its modules the libraries."""
    package = next(stage.rglob("cleft/__init__.py")).parent
    for path in sorted(package.iterdir()):
        if path.is_file():
            yield f"cleft/{path.name}", path
    for path in sorted(stage.rglob("libcleft*.so.[0-9]")):
        yield f"cleft/{path.name}", path


def record_line(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--version", required=True)
    parser.add_argument("--stage", required=True, type=pathlib.Path)
    parser.add_argument("--output", required=True, type=pathlib.Path)
    options = parser.parse_args()

    info = f"cleft-{options.version}.dist-info"
    contents = {name: path.read_bytes() for name, path in members(options.stage)}
    contents[f"{info}/METADATA"] = METADATA.format(version=options.version).encode()
    contents[f"{info}/LICENSE"] = next(options.stage.rglob("doc/cleft/LICENSE")).read_bytes()
    contents[f"{info}/WHEEL"] = WHEEL.format(tag=tag()).encode()
    record = "".join(record_line(name, data) for name, data in contents.items()) + f"{info}/RECORD,,\n"
    contents[f"{info}/RECORD"] = record.encode()

    for former in options.output.glob("cleft-*.whl"):
        former.unlink()
    with zipfile.ZipFile(options.output / f"cleft-{options.version}-{tag()}.whl", "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, data in contents.items():
            wheel.writestr(name, data)


if __name__ == "__main__":
    main()
