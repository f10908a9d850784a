#!/usr/bin/python3
"""How soon the page of a view is there, and how fast it turns, in Debian's Chromium without a screen and without a
graphics card. The best of some turns counts, as other work on the machine slows them.

    benchmarks/view_speed.py VIEW.html... [--size 1280x800] [--repeat 3]
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
os.environ.setdefault("NODE_FOLDER", str(ROOT / "build" / "view_speed"))
sys.path.insert(0, str(ROOT / "tests" / "view"))

from browser import script_command, skip_without_browser  # noqa: E402


def measured(page, size):
    """What speed.mjs says of one turn."""
    with tempfile.TemporaryDirectory() as folder:
        result = pathlib.Path(folder) / "result.json"
        command, environment = script_command("speed", page=page.resolve(), size=size, result=result)
        subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL)
        return json.loads(result.read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("views", nargs="+", type=pathlib.Path)
    parser.add_argument("--size", default="1280x800", help="of the window, in pixels")
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    skip_without_browser()
    size = [int(number) for number in arguments.size.split("x")]
    turns_of = {page: [measured(page, size) for _ in range(arguments.repeat)] for page in arguments.views}
    print("| view | ready after | shown | triangles | frames a second |")
    print("| --- | --- | --- | --- | --- |")
    for page, turns in turns_of.items():
        ready = min(turn["ready"] for turn in turns) / 1000
        for rows in zip(*(turn["turning"] for turn in turns)):
            best = max(rows, key=lambda row: row["rate"])
            print(f"| {page.stem} | {ready:.1f} s | {best['what']} | {best['triangles']:,} | {best['rate']:.0f} |")


main()
