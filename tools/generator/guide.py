"""What is made in the documents: the tables of options in docs/guide.md, one a group."""
from . import option_table, text

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
        if f"<options: {group}>" not in guide:
            raise ValueError(
                f"{PATH} has no place for the group {group} of {option_table.PATH}: add a line "
                f"<!-- <options: {group}> --> and a line <!-- </options: {group}> --> where its table shall stand"
            )
        inner = f"\n| option | what it is | values |\n|---|---|---|\n{rows}\n"
        guide = text.region(guide, PATH, f"options: {group}", inner, ("<!--", ""))
    return {PATH: guide}
