"""run_fuzzers.py PROGRAMS CLEFT FOLDER SECONDS [--seed S] [TARGET...]: runs each fuzz target of the folder PROGRAMS.

As many targets run side by side as there are processors. What a fuzzer finds is kept below FOLDER: inputs that reach
new code in inputs/TARGET, with which the next run begins, those that fail in failed/, and what each said in TARGET.log.
At last, files of all formats are damaged and given to the command CLEFT for as long. Without TARGETs, all are run.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
LIMITS = ["-rss_limit_mb=3000", "-malloc_limit_mb=500", "-timeout=120", "-max_len=4096", "-print_final_stats=1"]
NO_INPUT_MAY_TAKE_LONGER = 300  # seconds beyond its time after which a fuzzer hangs

parser = argparse.ArgumentParser()
parser.add_argument("programs", type=pathlib.Path)
parser.add_argument("cleft", type=pathlib.Path)
parser.add_argument("folder", type=pathlib.Path)
parser.add_argument("seconds", type=int)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("targets", nargs="*")
given = parser.parse_intermixed_args()


def dictionary_of(name):
    """A dictionary is for one target, or for all whose names begin as it is called."""
    return ["-dict=%s" % path for path in sorted(HERE.glob("*.dict")) if name.startswith(path.stem)]


def what_failed(name, log):
    """The path of the input that failed and the line that says why."""
    text = log.read_text(errors="replace")
    path = re.search(r"Test unit written to (\S+)", text)
    why = re.search(r"^FAULT: (.*)|runtime error: (.*)|^SUMMARY: (.*)|^(==\d+== ?ERROR: .*)", text, re.MULTILINE)
    return "%s fails on %s: %s" % (
        name,
        path[1] if path else "an input that it did not keep (see %s)" % log,
        next(filter(None, why.groups())) if why else "see %s" % log,
    )


def run_target(name):
    """What the target did, in a sentence, and whether nothing failed."""
    inputs, failed, scratch = (given.folder / kind / name for kind in ("inputs", "failed", "scratch"))
    for folder in (inputs, failed, scratch):
        folder.mkdir(parents=True, exist_ok=True)
    log = given.folder / (name + ".log")
    command = [
        given.programs / ("fuzz_" + name),
        "-max_total_time=%d" % given.seconds,
        "-seed=%d" % given.seed,
        *LIMITS,
        *dictionary_of(name),
        "-artifact_prefix=%s/" % failed,
        inputs,
        HERE / "corpus" / name,
    ]
    with open(log, "w") as out:
        try:
            done = (
                subprocess.run(
                    command,
                    stdout=out,
                    stderr=out,
                    env=dict(os.environ, TMPDIR=str(scratch)),
                    timeout=given.seconds + NO_INPUT_MAY_TAKE_LONGER,
                ).returncode
                == 0
            )
        except subprocess.TimeoutExpired:
            return "%s does not end: see %s" % (name, log), False
    if not done:
        return what_failed(name, log), False
    runs = re.search(r"number_of_executed_units: *(\d+)", log.read_text(errors="replace"))
    return "%s: %s inputs, none failed" % (name, runs[1] if runs else "no"), True


def main():
    targets = given.targets or sorted(path.name for path in (HERE / "corpus").iterdir())
    sound = True
    print("fuzzing %d targets for %d s each, seed %d" % (len(targets), given.seconds, given.seed), flush=True)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for sentence, passed in pool.map(run_target, targets):
            print(sentence, flush=True)
            sound = sound and passed
    if not given.targets:
        damaged = subprocess.run(
            [
                sys.executable,
                "-B",
                HERE / "damage_files.py",
                given.cleft,
                "--seconds",
                str(given.seconds),
                "--seed",
                str(given.seed),
                "--keep",
                given.folder / "failed",
            ]
        )
        sound = sound and damaged.returncode == 0
    sys.exit(0 if sound else 1)


main()
