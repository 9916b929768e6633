"""Writes the types of all operators (island.pyi, ...) and of the package (__init__.pyi) to a folder:

    python3 -m seamount.stubs apps/python/seamount

With --check writes nothing and fails where a file there is not what it would write.
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
    options.add_argument("--check", action="store_true")
    given = options.parse_args()
    made, stale = stubs(), []
    for name, text in made.items():
        path = given.folder / name
        if path.exists() and path.read_text() == text:
            continue
        stale.append(name)
        if not given.check:
            path.write_text(text)
    others = {path.name for path in given.folder.glob("*.pyi")} - set(made) - {"_core.pyi"}
    if given.check and (stale or others):
        print(f"not of these operators: {', '.join(sorted(stale) + sorted(others))}; "
              f"python3 -m seamount.stubs {given.folder} writes them anew", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
