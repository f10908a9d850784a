"""The reference of Python: the docstrings of what the package exports, a page for each of its modules.

The sources are read, not run, so that the library need not be built.
"""
import ast
import inspect
import tomllib

LINE = 70  # what stands beside the name on a page without scrolling


def written(argument, default):
    """An argument as this package's sources write it."""
    kind = f": {ast.unparse(argument.annotation)}" if argument.annotation else ""
    if default is None:
        return argument.arg + kind
    return argument.arg + kind + (" = " if kind else "=") + ast.unparse(default)


def signature(function, is_method):
    """The arguments of a function with types and defaults, and what it returns; one to a line if that is long."""
    arguments = function.args
    plain = [*arguments.posonlyargs, *arguments.args]
    defaults = [None] * (len(plain) - len(arguments.defaults)) + arguments.defaults
    parts = [written(argument, default) for argument, default in zip(plain, defaults)][int(is_method) :]
    if arguments.vararg:
        parts.append("*" + written(arguments.vararg, None))
    elif arguments.kwonlyargs:
        parts.append("*")
    parts += [written(argument, default) for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    if arguments.kwarg:
        parts.append("**" + written(arguments.kwarg, None))
    returns = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    line = f"({', '.join(parts)}){returns}"
    return line if len(line) < LINE else "(\n    " + ",\n    ".join(parts) + f",\n){returns}"


def decorators(node):
    return {ast.unparse(decorator).split("(")[0] for decorator in node.decorator_list}


def is_public(name):
    return not name.startswith("_")


def docstring(node):
    """The text of a docstring. That of a module has no indent of its own, so that blocks keep theirs."""
    text = ast.get_docstring(node, clean=False) or ""
    return text.strip() if isinstance(node, ast.Module) else inspect.cleandoc(text)


def trailing_comments(source):
    """Comments `#:` by the line of what they are about: behind it, or on the lines before it."""
    comments, above = {}, []
    for number, line in enumerate(source.splitlines(), 1):
        code, mark, text = line.partition("#: ")
        if mark and not code.strip():
            above.append(text)
            continue
        if mark or above:
            comments[number] = " ".join((*above, *([text] if mark else ())))
        above = []
    return comments


class Module:
    """A module of the package, and what it exports."""

    def __init__(self, path):
        source = path.read_text()
        self.name = path.stem
        self.tree = ast.parse(source)
        self.comments = trailing_comments(source)
        named = (ast.ClassDef, ast.FunctionDef)
        self.nodes = {node.name: node for node in self.tree.body if isinstance(node, named)}
        for node in self.tree.body:
            if isinstance(node, (ast.Assign, ast.AnnAssign)):
                target = node.target if isinstance(node, ast.AnnAssign) else node.targets[0]
                self.nodes[ast.unparse(target)] = node


class Reference:
    """The pages of all modules. `options` has the text of each option by its name."""

    def __init__(self, package, options):
        self.options = options
        self.modules = {path.stem: Module(path) for path in sorted(package.glob("*.py"))}
        self.undocumented = []
        self.exports = {}
        start = self.modules["__init__"]
        public = ast.literal_eval(start.nodes["__all__"].value)
        for node in start.tree.body:
            if isinstance(node, ast.ImportFrom) and node.level == 1:
                for alias in node.names:
                    if alias.name in public:
                        self.exports.setdefault(node.module, []).append(alias.name)
        found = {name for names in self.exports.values() for name in names}
        self.exports["__init__"] = [name for name in public if name not in found]

    def class_named(self, name):
        return next((module for module in self.modules.values() if name in module.nodes), None)

    def entry(self, level, heading, code, text):
        if not text:
            self.undocumented.append(heading)
        return [f"{'#' * level} {heading}", f"```python\n{code}\n```", text]

    def fields(self, module, node):
        """A table of the fields of a data class or of a dictionary with given keys."""
        fields = [part for part in node.body if isinstance(part, ast.AnnAssign) and is_public(part.target.id)]
        if not fields:
            return []
        rows = [
            f"| `{field.target.id}` | `{ast.unparse(field.annotation)}` | {self.about(module, node, field)} |"
            for field in fields
        ]
        return ["\n".join(("| field | type | |", "|---|---|---|", *rows))]

    def about(self, module, node, field):
        """What a field is. Keywords are options, which have their own table."""
        options = self.options if node.name == "OptionKeywords" else {}
        return module.comments.get(field.lineno) or options.get(field.target.id, "")

    def members(self, module, node, owner):
        """Properties and methods, those of private bases too."""
        lines = self.fields(module, node)
        for part in node.body:
            if not isinstance(part, ast.FunctionDef) or not is_public(part.name):
                continue
            marks = decorators(part)
            if any(mark.endswith(".setter") for mark in marks):
                continue
            name = f"{owner}.{part.name}"
            if marks & {"property", "functools.cached_property", "cached_property"}:
                code = f"{part.name}: {ast.unparse(part.returns)}" if part.returns else part.name
            else:
                prefix = (
                    "classmethod " if "classmethod" in marks else "staticmethod " if "staticmethod" in marks else ""
                )
                code = f"{prefix}{name}{signature(part, 'staticmethod' not in marks)}"
            lines += self.entry(3, name, code, docstring(part))
        for base in node.bases:
            home = self.class_named(ast.unparse(base))
            if home and home.name.startswith("_"):
                lines += self.members(home, home.nodes[ast.unparse(base)], owner)
        return lines

    def class_entry(self, module, node):
        init = next((part for part in node.body if getattr(part, "name", "") == "__init__"), None)
        bases = [ast.unparse(base) for base in node.bases]
        shown = [base for base in bases if base not in ("Owner", "Named")]
        code = f"class cleft.{node.name}" + (f"({', '.join(shown)})" if shown else "")
        if init:
            code += f"\ncleft.{node.name}{signature(init, True).removesuffix(' -> None')}"
        return self.entry(2, node.name, code, docstring(node)) + self.members(module, node, node.name)

    def value_entry(self, module, name, node):
        code = f"cleft.{name}"
        if isinstance(node, ast.AnnAssign):
            code += f": {ast.unparse(node.annotation)}"
        elif isinstance(node.value, ast.Tuple):
            code += f" = {ast.unparse(node.value)}"
        return self.entry(2, name, code, module.comments.get(node.lineno, "") or "A constant.")

    def page(self, name):
        module = self.modules[name]
        title = "Package" if name == "__init__" else name.capitalize()
        lines = [f"# {title}", docstring(module.tree)]
        for exported in self.exports[name]:
            node = module.nodes[exported]
            if isinstance(node, ast.ClassDef):
                lines += self.class_entry(module, node)
            elif isinstance(node, ast.FunctionDef):
                lines += self.entry(2, exported, f"cleft.{exported}{signature(node, False)}", docstring(node))
            else:
                lines += self.value_entry(module, exported, node)
        return title, "\n\n".join(line for line in lines if line) + "\n"


def make(root, output):
    """Writes the pages into `output`: what `cleft` exports and has no docstring fails."""
    options = tomllib.loads((root / "src/capi/options.toml").read_text())
    texts = {option["key"].lower(): option["text"] for option in options["option"]}
    texts.update({one["name"]: one["text"] for one in options["list"]})
    reference = Reference(root / "bindings/python/cleft", texts)
    output.mkdir(parents=True)
    rows = []
    for name in sorted(reference.exports, key=lambda name: (name != "__init__", name)):
        title, text = reference.page(name)
        file = "package.md" if name == "__init__" else f"{name}.md"
        (output / file).write_text(text)
        rows.append(f"- [{title}]({file}): " + ", ".join(f"`{export}`" for export in reference.exports[name]))
    if reference.undocumented:
        raise SystemExit("these have no docstring: " + ", ".join(reference.undocumented))
    about = "What `import cleft` offers. [Cleft from Python](../../docs/python.md) introduces it."
    (output / "README.md").write_text("\n\n".join(("# Reference of Python", about, "\n".join(rows))) + "\n")
