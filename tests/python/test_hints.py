"""Everything public has type hints that can be resolved, and a sentence about it."""
import importlib
import inspect
import pathlib
import types
import typing
import unittest

import cleft


def public_functions():
    for name in cleft.__all__:
        thing = getattr(cleft, name)
        if inspect.isfunction(thing):
            yield name, thing
        elif inspect.isclass(thing):
            for member, value in vars(thing).items():
                value = value.fget if isinstance(value, property) else getattr(value, "__func__", value)
                if inspect.isfunction(value) and (not member.startswith("_") or member == "__init__"):
                    yield f"{name}.{member}", value


class Hints(unittest.TestCase):
    def test_every_parameter_and_answer_is_typed(self):
        names = [name for name, _ in public_functions()]
        self.assertGreater(len(names), 60)
        for name, function in public_functions():
            if name.endswith("__init__") and "dataclass" in (inspect.getmodule(function) or cleft).__name__:
                continue
            parameters = [p for p in inspect.signature(function).parameters.values() if p.name not in ("self", "cls")]
            for parameter in parameters:
                self.assertIsNot(parameter.annotation, inspect.Parameter.empty, f"{name}({parameter.name})")
            self.assertIsNot(inspect.signature(function).return_annotation, inspect.Signature.empty, name)

    def test_hints_resolve(self):
        modules = {"volume", "sizing", "meshes", "surface", "files", "options", "mesher", "results", "errors"}
        names = {}
        for module in modules:
            names.update(vars(importlib.import_module(f"cleft.{module}")))
        names["meshio"] = types.SimpleNamespace(Mesh=object)
        for name, function in public_functions():
            with self.subTest(name):
                typing.get_type_hints(function, names)

    def test_options_are_hinted_where_they_are_taken(self):
        for name, function in public_functions():
            parameters = inspect.signature(function).parameters
            if "options" in parameters:
                self.assertEqual(str(parameters["keywords"].annotation), "Unpack[OptionKeywords]", name)

    def test_everything_is_described(self):
        for name, function in public_functions():
            if not name.endswith("__init__"):
                self.assertTrue(inspect.getdoc(function), name)
        for name in cleft.__all__:
            if inspect.isclass(getattr(cleft, name)):
                self.assertTrue(vars(getattr(cleft, name)).get("__doc__"), name)

    def test_all_is_all(self):
        public = {
            name
            for name, value in vars(cleft).items()
            if not name.startswith("_") and not inspect.ismodule(value) and name != "annotations"
        }
        self.assertEqual(public, set(cleft.__all__))

    def test_marker(self):
        self.assertTrue((pathlib.Path(cleft.__file__).parent / "py.typed").exists())


if __name__ == "__main__":
    unittest.main()
