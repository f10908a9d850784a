"""The guard of the binary interface.

The interface is C and its handles are opaque, so the header is all there is to it: a library of empty functions,
compiled from the header with debug information, has the same binary interface as the real one (whose symbols
check_exports.py compares). That library is what libabigail describes in the baselines libcleft*.abi.

  abi.py dump  CC HEADER VERSION_SCRIPT OUTPUT      describes the interface
  abi.py check CC HEADER VERSION_SCRIPT BASELINE    fails if anything of the baseline is gone or changed
  abi.py faults CC HEADER VERSION_SCRIPT BASELINE   checks the check: it must refuse what breaks, and nothing else

HEADER may be several, with commas between them, the first of which the others include.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))

from generator import c_header  # noqa: E402

ABIDW = [
    "abidw",
    "--no-corpus-path",
    "--no-comp-dir-path",
    "--no-show-locs",
    "--no-elf-needed",
    "--type-id-style",
    "hash",
]


def stub(header):
    """The source of a library of empty functions."""
    bodies = [
        function.prototype + (" {}" if function.result == "void" else " { return 0; }")
        for function in c_header.Header(header).functions
    ]
    return header + "\n" + "\n".join(bodies) + "\n"


def dump(compiler, header, include, version_script, output):
    with tempfile.TemporaryDirectory() as folder:
        source, library = pathlib.Path(folder, "stub.c"), pathlib.Path(folder, "stub.so")
        source.write_text(stub(header))
        # Relative to the folder, so that no path of this machine is in the description.
        subprocess.run(
            [
                compiler,
                "-std=c99",
                "-g",
                "-O0",
                "-shared",
                "-fPIC",
                "-fvisibility=hidden",
                f"-I{include}",
                f"-Wl,--version-script={version_script}",
                "-Wl,--undefined-version",
                "stub.c",
                "-o",
                library.name,
            ],
            cwd=folder,
            check=True,
        )
        text = subprocess.run([*ABIDW, library.name], cwd=folder, check=True, capture_output=True, text=True).stdout
    pathlib.Path(output).write_text(text)


# Structs begin with struct_size, so that they may grow at their end.
GROWTH = "[suppress_type]\n type_kind = struct\n has_data_member_inserted_at = end\n"


def breaks(baseline, compiler, header, include, version_script):
    """What abidiff has to say of an interface; "" if programs of the baseline go on to work."""
    with tempfile.NamedTemporaryFile(suffix=".abi") as now, tempfile.NamedTemporaryFile(
        "w", suffix=".abignore"
    ) as growth:
        dump(compiler, header, include, version_script, now.name)
        growth.write(GROWTH)
        growth.flush()
        result = subprocess.run(
            ["abidiff", "--no-added-syms", "--suppressions", growth.name, baseline, now.name],
            capture_output=True,
            text=True,
        )
    return result.stdout + result.stderr if result.returncode else ""


def changed(header, pattern, replacement):
    text, count = re.subn(pattern, replacement, header, count=1, flags=re.S)
    if count != 1:
        sys.exit(f"the header has no {pattern}")
    return text


def check_faults(baseline, compiler, header, include, version_script):
    functions = c_header.Header(header).functions
    first, last = functions[0], functions[-1].prototype
    added = header.replace(first.text, first.text + "\nCLEFT_API int cleft_added(void) CLEFT_NOEXCEPT;")
    harmless = {
        "nothing": header,
        "an added function": added,
        "a comment": header + "/* */",
        "a field at the end": changed(header, r"(\n} cleft_\w+;)", r"\n    double added;\1"),
    }
    breaking = {
        "a removed function": changed(header, re.escape(first.text), ""),
        "another type of an argument": changed(header, r"\bint64_t (\w+)(,\s[^;]*\) CLEFT_NOEXCEPT)", r"int32_t \1\2"),
        "another result": changed(header, re.escape(last), "double " + re.search(r"cleft_\w+\(.*", last, re.S).group()),
        "an added argument": changed(
            header,
            re.escape(last),
            last[:-1].replace("(void", "(") + ", int added)"
            if "(void" not in last
            else last.replace("(void)", "(int added)"),
        ),
        "a field that moved": changed(header, r"(uint32_t struct_size;)", r"\1 double moved;"),
    }
    for what, text in harmless.items():
        if breaks(baseline, compiler, text, include, version_script):
            sys.exit(f"{what} was refused")
    for what, text in breaking.items():
        if not breaks(baseline, compiler, text, include, version_script):
            sys.exit(f"{what} was not refused")
    print(f"{len(harmless)} harmless changes are accepted, {len(breaking)} breaking ones refused")


def main():
    task, compiler, header_path, version_script, file = sys.argv[1:]
    headers = [pathlib.Path(path) for path in header_path.split(",")]
    include = headers[0].resolve().parents[1]
    header = "".join(path.read_text() for path in headers)
    if task == "dump":
        dump(compiler, header, include, version_script, file)
    elif task == "check":
        report = breaks(file, compiler, header, include, version_script)
        if report:
            sys.exit(report + "\nPrograms that were built with the baseline break. See docs/c.md, Binary interface.")
    elif task == "faults":
        check_faults(file, compiler, header, include, version_script)
    else:
        sys.exit(__doc__)


main()
