"""The type hints say what the module has: names, parameters, which of them have defaults, which are by keyword only."""

import ast
import os
import re
import unittest

import rubble

HINTS = os.path.join(os.environ["RUBBLE_SOURCE_DIR"], "app/python/rubble/__init__.pyi")


def hinted():
    with open(HINTS) as file:
        return ast.parse(file.read()).body


def hinted_parameters(function):
    """(name, has default, keyword only) of each but self."""
    arguments = function.args
    defaults = [False] * (len(arguments.args) - len(arguments.defaults)) + [True] * len(arguments.defaults)
    rows = [(a.arg, d, False) for a, d in zip(arguments.args, defaults) if a.arg != "self"]
    return rows + [(a.arg, d is not None, True) for a, d in zip(arguments.kwonlyargs, arguments.kw_defaults)]


def split(text):
    """Parameters of a signature, parted at commas that stand in no brackets."""
    parts, depth, current = [], 0, ""
    for c in text:
        depth += c in "[({"
        depth -= c in "])}"
        if c == "," and depth == 0:
            parts.append(current.strip())
            current = ""
        else:
            current += c
    return parts + ([current.strip()] if current.strip() else [])


def real_parameters(callable_object):
    """The same out of the first line of a docstring, where the module says its signature."""
    line = callable_object.__doc__.splitlines()[0]
    rows, keyword_only = [], False
    for part in split(re.match(r"\w+\((.*)\) -> ", line).group(1)):
        name = part.split(":")[0].strip()
        if part == "*":
            keyword_only = True
        elif name != "self" and not name.startswith("arg0"):
            rows.append((name, " = " in part, keyword_only))
    return rows


class Hints(unittest.TestCase):
    def test_names_of_the_module(self):
        functions = {node.name for node in hinted() if isinstance(node, ast.FunctionDef)}
        classes = {node.name for node in hinted() if isinstance(node, ast.ClassDef)}
        self.assertEqual(functions | classes | {"build"}, set(rubble.__all__))

    def test_functions(self):
        for node in hinted():
            if isinstance(node, ast.FunctionDef):
                self.assertEqual(hinted_parameters(node), real_parameters(getattr(rubble, node.name)), node.name)

    def test_members_of_classes(self):
        checked = 0
        for node in hinted():
            if not isinstance(node, ast.ClassDef) or issubclass(getattr(rubble, node.name), Exception):
                continue
            real = vars(getattr(rubble, node.name))
            names = {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
            self.assertEqual(names - {"__len__"}, {name for name in real if not name.startswith("_")}, node.name)
            self.assertEqual("__len__" in names, "__len__" in real, node.name)
            for member in node.body:
                value = real[member.name]
                is_property = any(getattr(d, "id", "") == "property" for d in member.decorator_list)
                self.assertEqual(is_property, isinstance(value, property), f"{node.name}.{member.name}")
                if not is_property and not member.name.startswith("_"):
                    self.assertEqual(hinted_parameters(member), real_parameters(value), f"{node.name}.{member.name}")
                    checked += 1
        self.assertGreater(checked, 15)

    def test_errors(self):
        for node in hinted():
            if isinstance(node, ast.ClassDef) and issubclass(getattr(rubble, node.name), Exception):
                bases = {getattr(rubble, base.id, None) or getattr(__builtins__, base.id, None) for base in node.bases}
                self.assertTrue(all(issubclass(getattr(rubble, node.name), base) for base in bases if base), node.name)


if __name__ == "__main__":
    unittest.main()
