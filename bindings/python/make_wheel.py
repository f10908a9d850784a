#!/usr/bin/python3
"""Makes a wheel, which pip installs without a network, of the installed files of the Python package and libraries."""
import argparse
import pathlib
import sysconfig
import zipfile

import dist_info

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


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--version", required=True)
    dist_info.add_licence_to(parser)
    parser.add_argument("--stage", required=True, type=pathlib.Path)
    parser.add_argument("--output", required=True, type=pathlib.Path)
    options = parser.parse_args()

    info = dist_info.folder_name(options.version)
    contents = {name: path.read_bytes() for name, path in members(options.stage)}
    own = {**dist_info.files(options), "WHEEL": WHEEL.format(tag=tag()).encode()}
    contents.update({f"{info}/{name}": data for name, data in own.items()})
    contents[f"{info}/RECORD"] = dist_info.record(contents, options.version)

    for former in options.output.glob("cleft-*.whl"):
        former.unlink()
    with zipfile.ZipFile(options.output / f"cleft-{options.version}-{tag()}.whl", "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, data in contents.items():
            wheel.writestr(name, data)


if __name__ == "__main__":
    main()
