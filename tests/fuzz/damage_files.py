"""damage_files.py CLEFT (--count N | --seconds T) [--seed S] [--keep FOLDER] [--any-memory]: damaged files of all
formats.

Each file of the corpora of readers is cut, spliced, and changed byte by byte, and given to `cleft info` and `cleft
mesh` (or `cleft check`) in a process with limits on memory and time. Each run must end with an exit status that is
documented, and one sentence where it fails; what it wrote is whole or not there. The same seed damages the same files.
Unlike the fuzzers, this reaches GDCM, which runs in a process of its own. Inputs that fail are kept in FOLDER.
"""
import argparse
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
BORDER = b"\n--next file--\n"
FILES = {
    "volume_nrrd": ["given.nhdr", "given.raw", "given1.raw"],
    "volume_metaimage": ["given.mhd", "given.raw", "given1.raw"],
    "volume_analyze": ["given.hdr", "given.img"],
    "volume_dicom": ["given.dcm"],
    "volume_dicom_series": ["1.dcm", "2.dcm", "3.dcm"],
    "mesh_tetgen": ["given.node", "given.ele"],
}
OK, CHECK_FAILED, CANNOT_READ, MESHING_FAILED, LABEL_LOST = 0, 1, 3, 5, 6
SECONDS, MEMORY = 60, 2 << 30  # of one run

parser = argparse.ArgumentParser()
parser.add_argument("cleft", type=pathlib.Path)
parser.add_argument("--count", type=int)
parser.add_argument("--seconds", type=float)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--keep", type=pathlib.Path)
parser.add_argument("--any-memory", action="store_true")
given = parser.parse_args()

STRANGE = (
    [bytes(n) for n in (1, 2, 4, 8)]
    + [b"\xff" * n for n in (1, 2, 4, 8)]
    + [
        b"\x7f\xff\xff\xff",
        b"\xff\xff\xff\x7f",
        b"\x80",
        b"\x00\x00\xc0\x7f",
        b"\x7f\xc0\x00\x00",
        b"%s%n",
        b"-1",
        b"1e999",
        b"99999999999",
        b"nan",
        b"\n",
        b"LIST",
        b" ",
    ]
)


def damaged(data, others, chance):
    """The bytes with one to four faults."""
    data = bytearray(data)
    for _ in range(chance.randint(1, 4)):
        at = chance.randrange(len(data) + 1)
        # A header is where damage does most.
        at = min(at, chance.randrange(400)) if chance.random() < 0.5 else at
        kind = chance.randrange(7)
        if kind == 0 and at < len(data):
            data[at] ^= 1 << chance.randrange(8)
        elif kind == 1:
            del data[at:]
        elif kind == 2:
            strange = chance.choice(STRANGE)
            data[at : at + len(strange)] = strange
        elif kind == 3:
            data[at:at] = chance.choice(STRANGE)
        elif kind == 4:
            del data[at : at + chance.randint(1, 16)]
        elif kind == 5:
            other = chance.choice(others)
            start = chance.randrange(len(other) + 1)
            data[at:] = other[start : start + chance.randint(0, 1000)]
        else:
            data[at:at] = data[max(0, at - chance.randint(1, 64)) : at]
    return bytes(data)


def limit():
    if not given.any_memory:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def fault_of(command, exits, folder):
    """What is wrong with a run of the command; '' if nothing."""
    try:
        command += ["--progress", "none"]  # a slow run says nothing of it
        done = subprocess.run([given.cleft, *command], capture_output=True, timeout=2 * SECONDS, preexec_fn=limit)
    except subprocess.TimeoutExpired:
        return "does not end"
    if done.returncode not in exits:
        return "ends with %d: %s" % (done.returncode, done.stderr.decode(errors="replace").strip()[:300])
    try:
        lines = done.stderr.decode().splitlines()
    except UnicodeDecodeError:
        return "prints what is no text"
    errors = [line for line in lines if not line.startswith("cleft: warning: ")]
    if len(errors) != (0 if done.returncode in (OK, CHECK_FAILED) else 1):
        return "reports %d errors with status %d: %s" % (len(errors), done.returncode, " / ".join(errors)[:300])
    written = [name for name in os.listdir(folder) if "out" in name]
    if "mesh" in command:
        if written != (["out.vtu"] if done.returncode == OK else []):
            return "leaves %s behind with status %d" % (written, done.returncode)
        if written:
            check = subprocess.run([given.cleft, "check", folder + "/out.vtu"], capture_output=True)
            return "" if check.returncode == 0 else "writes a mesh that is not valid"
    return ""


def try_one(seed, target, others):
    """A sentence about the fault that a damaged file of a target brings about; '' if there is none."""
    chance = random.Random("%d %s" % (seed, target))
    source = chance.choice(others)
    data = damaged(source, others, chance)
    names = FILES.get(target) or ["given." + target.split("_")[1]]
    with tempfile.TemporaryDirectory() as folder:
        given_folder = pathlib.Path(folder, "in")
        given_folder.mkdir()
        for name, part in zip(names, data.split(BORDER)):
            (given_folder / name).write_bytes(part)
        path = str(given_folder if target.endswith("series") else given_folder / names[0])
        if target.startswith("mesh"):
            runs = [(["check", path], (OK, CHECK_FAILED, CANNOT_READ))]
        else:
            runs = [
                (["info", path], (OK, CANNOT_READ)),
                (
                    ["mesh", path, "-o", folder + "/out.vtu", "--max-tets", "2000", "--quiet"],
                    (OK, CANNOT_READ, MESHING_FAILED, LABEL_LOST),
                ),
            ]
        for command, exits in runs:
            fault = fault_of(command, exits, folder)
            if not fault:
                continue
            where = "run again with --seed %d" % seed
            if given.keep:
                given.keep.mkdir(parents=True, exist_ok=True)
                where = given.keep / ("%s-%d" % (target, seed))
                where.write_bytes(data)
            return "cleft %s %s: %s (%s)" % (command[0], path.replace(folder, ""), fault, where)
    return ""


def main():
    corpora = {
        folder.name: [path.read_bytes() for path in sorted(folder.iterdir())]
        for folder in sorted((HERE / "corpus").iterdir())
        if folder.name.startswith(("mesh_", "volume_"))
    }
    started = time.monotonic()
    runs = faults = 0
    while runs < given.count if given.count else time.monotonic() - started < given.seconds:
        target = list(corpora)[runs % len(corpora)]
        fault = try_one(given.seed + runs // len(corpora), target, corpora[target])
        if fault:
            print(fault, flush=True)
        faults += bool(fault)
        runs += 1
    print("damaged files: %d, of which %d failed" % (runs, faults))
    sys.exit(1 if faults else 0)


main()
