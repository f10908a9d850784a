"""What is made in the documents: the tables of options in docs/guide.md, one a group."""
from . import text

PATH = "docs/guide.md"


def _row(option, options):
    def argument(name):
        return f"`--{name.replace('_', '-')}`"

    value = {"flag": "", "choice": " NAME", "integer": " N", "real": " X"}[option.type]
    words = text.with_names(option.text, options, argument).replace("|", "\\|")
    return f"| `--{option.name.replace('_', '-')}{value}` | {words} | {text.values_text(option)} |\n"


def files(tree, table):
    guide = tree.read(PATH)
    for group in dict.fromkeys(option.group for option in table.options):
        rows = "".join(_row(option, table.options) for option in table.options if option.group == group)
        inner = f"\n| option | what it is | values |\n|---|---|---|\n{rows}\n"
        guide = text.region(guide, PATH, f"options: {group}", inner, ("<!--", ""))
    return {PATH: guide}
