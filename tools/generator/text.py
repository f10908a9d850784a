"""Pieces of text that all languages share: regions in files written by hand, numbers, names, lines of a width."""
import re
import textwrap

MADE_BY = "Made by tools/generate.py"
WIDTH = 120  # of the lines of all languages


def region(text, path, name, inner, marks=("/*", "*/")):
    """`text` with what lies between the marks <name> and </name>, each on a line of its own, replaced by `inner`."""
    begin, end = marks
    pattern = re.compile(
        rf"(^[ \t]*{re.escape(begin)} <{re.escape(name)}>[^\n]*\n).*?(^[ \t]*{re.escape(begin)} </{re.escape(name)}>)",
        re.DOTALL | re.MULTILINE,
    )
    result, count = pattern.subn(lambda match: match[1] + inner + match[2], text)
    if count != 1:
        raise ValueError(f"{path} has {count} regions <{name}>")
    return result


def number(value):
    """As C and people read it: 0.3, 1e30, 10000000."""
    if value == int(value) and abs(value) < 1e16:
        return str(int(value))
    return repr(value).replace("e+", "e")


def camel(name):
    """ "size_min" as "sizeMin"."""
    first, *rest = name.lower().split("_")
    return first + "".join(part.capitalize() for part in rest)


def pascal(name):
    """ "size_min" as "SizeMin"."""
    return "".join(part.capitalize() for part in name.lower().split("_"))


def sentence(phrase):
    """A phrase that begins with a small letter, as a sentence."""
    return phrase[0].upper() + phrase[1:] + ("" if phrase.endswith((".", "?")) else ".")


def lines(text, width, first="", rest=None):
    return (
        textwrap.fill(
            text,
            width,
            initial_indent=first,
            subsequent_indent=first if rest is None else rest,
            break_long_words=False,
            break_on_hyphens=False,
        )
        + "\n"
    )


def with_names(text, options, style):
    """A text of the table whose names of options with more than one word are in the style of a language."""
    for option in sorted(options, key=lambda o: -len(o.name)):
        if "_" in option.name:
            text = re.sub(rf"\b{option.name}\b", style(option.name), text)
    return text


def values_text(option):
    """The values of an option and its default, in words."""
    if option.choice:
        names = [value.name for value in option.choice.values]
        return f"{', '.join(names[:-1])} or {names[-1]}; default {names[int(option.default)]}"
    if option.type == "flag":
        return f"on or off; default {'on' if option.default else 'off'}"
    limits = (
        f"at least {number(option.least)}"
        if option.greatest >= 1e15
        else f"{number(option.least)} to {number(option.greatest)}"
    )
    return f"{limits}; default {number(option.default)}"
