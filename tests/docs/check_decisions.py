"""Decisions are numbered without a gap, and each has the headings that CONTRIBUTING.md asks for, in their order."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADINGS = ("Decision", "Why", "Price", "When to look again")
MOST_LINES = 35  # of a page that is still read


def faults(number, path):
    text = path.read_text()
    title = text.splitlines()[0]
    if not re.match(r"%04d-[a-z0-9-]+\.md$" % number, path.name):
        yield "is not the file of decision %d" % number
    if not re.match(r"# %d\. [A-Z0-9]" % number, title):
        yield "has the title '%s'" % title
    places = [text.find("\n**%s.** " % heading) for heading in HEADINGS]
    for heading, place in zip(HEADINGS, places):
        if place < 0:
            yield "has no paragraph that begins with **%s.**" % heading
    if places != sorted(places):
        yield "has its headings in another order than %s" % ", ".join(HEADINGS)
    if text.count("\n") > MOST_LINES:
        yield "has more than %d lines" % MOST_LINES


found = [
    "%s %s" % (path.relative_to(ROOT), fault)
    for number, path in enumerate(sorted((ROOT / "docs" / "decisions").iterdir()), 1)
    for fault in faults(number, path)
]
sys.exit("\n".join(found) or 0)
