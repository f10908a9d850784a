#!/usr/bin/env python3
"""Checks that prose is made of short sentences: 90 % of them under 30 words, and none over 45.

It reads Markdown pages, the docstrings of C and C++ headers with the comment at their head, and the texts of TOML
files.

check_prose.py [--list N] FILE... prints, for each file, the number of its sentences, the share of short ones and the
longest one. It prints the sentences that are too long, and with --list also those of N words or more. It ends with 1 if
a file is beyond a limit. Code blocks, tables, headings, comments and pictures are left out; a piece of code within a
sentence counts as one word.
"""
import argparse
import pathlib
import re
import sys
import tomllib

SHORT, LONGEST, LEAST_SHARE = 30, 45, 0.90
ITEM = re.compile(r"\s*(?:[-*+]|\d+\.)\s+")
SKIPPED = re.compile(r"\s*(?:#|\||<!--|---)")  # headings, tables, comments, rules
SENTENCE_END = re.compile(r"(?<=[.!?])[\"')*_]*\s+(?=[\"'(*_\[]*[A-Z0-9`<])")
DOCSTRING = re.compile(r"/\*\*<?(.*?)\*/", re.DOTALL)
HEAD = re.compile(r"\A/\*(?!\*)(.*?)\*/", re.DOTALL)
ABBREVIATION = re.compile(r"(?:\be\.g|\bi\.e|\bcf|\bvol|\bpp?|\bno|\b[A-Z])\.$")


def paragraphs(text):
    """The paragraphs and list items of a page, each as one line of text with the number of its first line."""
    gathered, first, fenced, after_blank, in_list = [], 0, False, True, False

    def flush():
        nonlocal gathered
        if gathered:
            yield first, " ".join(gathered)
        gathered = []

    for number, line in enumerate(text.splitlines(), 1):
        blank = not line.strip()
        if line.lstrip().startswith(("```", "~~~")):
            fenced = not fenced
            yield from flush()
        elif fenced:
            pass
        elif blank or SKIPPED.match(line):
            yield from flush()
            in_list = in_list and not line.startswith("#")
        elif line.startswith("    ") and after_blank and not in_list:
            continue  # indented code; what follows it without a blank line is code, too
        else:
            item = ITEM.match(line)
            if item:
                yield from flush()
                in_list = True
            elif not line.startswith(" ") and after_blank:
                in_list = False
            if not gathered:
                first = number
            gathered.append(line[item.end() :] if item else line.strip().removeprefix("> "))
        after_blank = blank
    yield from flush()


def numbered_paragraphs(text, whole, at):
    """The paragraphs of a part of a file that begins at the character `at` of the whole."""
    before = whole.count("\n", 0, at)
    for line, paragraph in paragraphs(text):
        yield before + line, paragraph


def docstring_paragraphs(header):
    """The paragraphs of the docstrings of a header, and of the comment at its head."""
    for comment in [*HEAD.finditer(header), *DOCSTRING.finditer(header)]:
        inner = re.sub(r"^[ \t]*\* ? ?", "", comment[1], flags=re.MULTILINE)
        inner = re.sub(r"\\since [\d.]+", "", inner)
        inner = re.sub(r"\bcleft_\w+(?:\(\))?", r"`\g<0>`", inner)  # code, which may begin a sentence
        yield from numbered_paragraphs(inner.lstrip(" "), header, comment.start(1))


def toml_texts(rows):
    """The strings of all keys `text`, at any depth."""
    for key, value in rows.items() if isinstance(rows, dict) else enumerate(rows):
        if isinstance(value, (dict, list)):
            yield from toml_texts(value)
        elif key == "text":
            yield value


def toml_paragraphs(toml):
    for text in toml_texts(tomllib.loads(toml)):
        yield from numbered_paragraphs(text.strip(), toml, toml.find(text))


PARAGRAPHS = {".md": paragraphs, ".h": docstring_paragraphs, ".hpp": docstring_paragraphs, ".toml": toml_paragraphs}


def sentences(paragraph):
    paragraph = re.sub(r"!\[[^]]*\]\([^)]*\)", "", paragraph)
    # A link to a file may begin a sentence with a small letter.
    paragraph = re.sub(r"\[([^]]*)\]\([^)]*\)", lambda link: link[1][:1].upper() + link[1][1:], paragraph)
    paragraph = re.sub(r"`[^`]*`", "`code`", paragraph)
    part = ""
    for piece in SENTENCE_END.split(paragraph):
        part = f"{part} {piece}" if part else piece
        if not ABBREVIATION.search(piece):
            yield part
            part = ""
    if part:
        yield part


def word_count(sentence):
    return len([word for word in sentence.split() if re.search(r"\w", word)])


def measure(path):
    """Rows of a sentence's words, its line and its text."""
    return [
        (word_count(sentence), line, sentence)
        for line, paragraph in PARAGRAPHS[path.suffix](path.read_text())
        for sentence in sentences(paragraph)
        if word_count(sentence)
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--list", type=int, metavar="N", help="print the sentences of N words or more, too")
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    failed = False
    for path in arguments.files:
        rows = measure(path)
        share = sum(words < SHORT for words, _, _ in rows) / max(len(rows), 1)
        longest = max((words for words, _, _ in rows), default=0)
        fails = share < LEAST_SHARE or longest > LONGEST
        failed = failed or fails
        print(
            f"{path}: {len(rows)} sentences, {100 * share:.1f} % under {SHORT} words, longest {longest}"
            f"{', FAILS' if fails else ''}"
        )
        least = min(arguments.list or LONGEST + 1, SHORT if fails else LONGEST + 1)
        for words, line, sentence in rows:
            if words >= least:
                print(f"  {path}:{line}: {words} words: {sentence}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
