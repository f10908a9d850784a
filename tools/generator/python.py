"""What is made in Python: the keyword arguments of options, and the fields of plain values."""
from . import plain_values, text

FOLDER = "bindings/python/cleft"
_OPTIONS = {"real": "float", "flag": "bool", "integer": "int", "choice": "str"}
_VALUES = {"whole": "int", "label": "int", "real": "float", "flag": "bool", "list": "tuple[int, ...]"}


def _field(declaration, about):
    """A field with its comment: behind it, or in front of it if the line became too long."""
    line = f"    {declaration}  #: {about}\n"
    if len(line) <= text.WIDTH + 1:
        return line
    return text.lines(about, text.WIDTH, "    #: ") + f"    {declaration}\n"


def files(tree, table):
    options, results = f"{FOLDER}/options.py", f"{FOLDER}/results.py"
    keywords = "".join(f"    {option.name}: {_OPTIONS[option.type]}\n" for option in table.options)
    lists = "".join(f'    "{row.name}": "{row.text}",\n' for row in table.lists)
    module = text.region(tree.read(options), options, "options", keywords, ("#", ""))
    made = {options: text.region(module, options, "lists", lists, ("#", ""))}
    classes = tree.read(results)
    for name, values in plain_values.records(tree).items():
        fields = "".join(_field(f"{v.name}: {_VALUES[v.kind]}", v.about) for v in values)
        classes = text.region(classes, results, name, fields, ("#", ""))
    return made | {results: classes}
