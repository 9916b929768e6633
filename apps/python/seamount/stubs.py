"""Writes the types of all operators (island.pyi, ...) and of the package (__init__.pyi) to a folder, as the build does:

    python3 -m seamount.stubs FOLDER
"""

import argparse
import inspect
import keyword
import pathlib
import re
import sys

from . import _core, _describe

HEAD = '''# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)
'''


def camel(name):
    return "".join(part.title() for part in name.split("_"))


def comment(param):
    told = _describe.rule(param)
    return f'    """{param["help"]}{f" [{told}]" if told else ""}"""'.replace("\\", "\\\\")


def dictionary(name, tool, members):
    """A TypedDict; one with a member that is a word of the language cannot be a class."""
    if any(keyword.iskeyword(member["name"]) for member, _ in members):
        rows = [f'"{member["name"]}": {kind}' for member, kind in members]
        return f'{name} = TypedDict("{name}", {{{", ".join(rows)}}}, total=False)'
    rows = [f'    tool: Literal["{tool}"]'] if tool else []
    for member, kind in members:
        rows += [f"    {member['name']}: {kind}", comment(member)]
    return "\n".join([f"class {name}(TypedDict, total=False):", *(rows or ["    pass"])])


class Stub:
    """Text of one family."""

    def __init__(self):
        self.classes, self.functions = [], []

    def members(self, param, path):
        """The type of a parameter; members of groups become classes of their own."""
        if not param.get("tools"):
            return _describe.param_type(param)
        name = camel(path) + camel(param["name"])
        names = []
        for tool in param["tools"]:
            inner = name + camel(tool["name"])
            members = [(member, self.members(member, inner)) for member in tool["params"]]
            self.classes.append(dictionary(inner, tool["name"], members))
            names.append(inner)
        return _describe.param_type(param, " | ".join(names))

    def add(self, op):
        name = _describe.python_name(op["name"].partition(".")[2])
        types = {_describe.python_name(param["name"]): self.members(param, name) for param in op["params"]}
        rows, keywords = [], False
        for parameter, kind, default, is_input in _describe.parameters(op):
            if not is_input and not keywords:
                rows.append("*")
                keywords = True
            if not is_input and parameter in types:
                kind = types[parameter]
            rows.append(f"{parameter}: {kind}" + ("" if default is inspect.Parameter.empty else f" = {default!r}"))
        result = _describe.result_type(op)
        if len(op["out"]) > 1:
            fields = "\n".join(f"    {_describe.python_name(port['name'])}: {_describe.class_of(port['kind'])}"
                               for port in op["out"])
            self.classes.append(f"class {result}(NamedTuple):\n{fields}")
        text = _describe.docstring(op).rstrip().replace("\\", "\\\\").replace("\n", "\n    ")
        body = "\n    ".join(line.rstrip() for line in f'    """{text}\n    """'.split("\n    "))
        self.functions.append(f"def {name}(\n    " + ",\n    ".join(rows) + f",\n) -> {result}:\n{body.rstrip()}\n    ...")

    def text(self):
        return "\n\n".join([HEAD.rstrip(), *self.classes, *self.functions]) + "\n"


def package_text(families):
    """__init__.pyi: what the package's source imports, and the families."""
    source = pathlib.Path(__file__).with_name("__init__.py").read_text()
    imported = [part for part in source[source.index("from ._core"):source.index("\n__version__")].split("\nfrom ")]
    lines = ["# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py."]
    for part in imported:
        module, _, names = part.removeprefix("from ").partition(" import ")
        if module != "._families":
            lines += [f"from {module} import {name} as {name}" for name in re.findall(r"\w+", names)]
    lines += [f"from . import {family} as {family}" for family in families]
    return "\n".join([*lines, "", "__version__: str", ""])


def stubs():
    """Text by name of file."""
    families = {}
    for op in _core.schema()["operators"]:
        families.setdefault(op["name"].partition(".")[0], Stub()).add(op)
    files = {family + ".pyi": stub.text() for family, stub in families.items()}
    return {**files, "__init__.pyi": package_text(families)}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=pathlib.Path)
    folder = options.parse_args().folder
    made = stubs()
    for name, text in made.items():
        path = folder / name
        if not path.exists() or path.read_text() != text:
            path.write_text(text)
    for path in folder.glob("*.pyi"):
        if path.name not in made and path.name != "_core.pyi":  # of a family that is no more
            path.unlink()
    return 0


if __name__ == "__main__":
    sys.exit(main())
