"""Does benchmarks/performance.py fill every table of docs/performance.md, and draw the plots that the page shows?

check_performance.py CLEFT. It measures small volumes, without CGAL, and does not look at times.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MARK = re.compile(r"^<!-- (\w+) -->$", re.MULTILINE)

TEXTS = ("summary", "machine")  # what is no table


def run(cleft, page):
    command = [
        sys.executable,
        "-B",
        ROOT / "benchmarks/performance.py",
        ROOT / "tests/data/mickey.nrrd",
        "--side",
        "12",
    ]
    command += ["--repeat", "1", "--cleft", cleft, "--cgal", "none", "--output", page]
    subprocess.run([*map(str, command)], check=True, stdout=subprocess.DEVNULL)


def parts(text):
    """What is between each pair of marks."""
    names = MARK.findall(text)
    assert names and names[::2] == names[1::2], "marks do not come in pairs"
    return dict(zip(names[::2], MARK.split(text)[2::4]))


def main():
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "performance.md"
        shutil.copy(ROOT / "docs/performance.md", page)
        run(sys.argv[1], page)
        text = page.read_text()
        for name, part in parts(text).items():
            rows = [line for line in part.splitlines() if line.startswith("|")]
            assert ("mickey" in part) if name in TEXTS else len(rows) > 2, f"{name} is empty"
            assert len({row.count("|") for row in rows}) < 2, f"{name} has rows of different lengths"
        assert "AAL" not in "".join(parts(text).values()), "an old table is left"
        pictures = re.findall(r"\]\((images/\S+)\)", text)
        assert pictures and all((page.parent / picture).stat().st_size > 0 for picture in pictures)


main()
