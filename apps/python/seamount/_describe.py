"""Signatures, docstrings and types of operators, from the library's own tables."""

import inspect
import keyword
import textwrap

NAMES = {"number": "float", "integer": "int", "switch": "bool", "text": "str", "file": "Path", "files": "Sequence[Path]",
         "model": "str", "colour": "str", "point": "Point", "curve": "Sequence[Point]", "numbers": "Sequence[float]",
         "integers": "Sequence[int]", "texts": "Sequence[str]", "points": "Sequence[Point]",
         "strokes": "Sequence[Stroke]",
         "outlines": "Sequence[Outline]", "polygons": "Sequence[Polygon]", "regions": "Sequence[Region]",
         "rivers": "Sequence[River]"}
INPUTS = {"drawing": "Drawing | Shapes | Path", "terrain": "Terrain | Array | Path", "field": "Field | Array | Path",
          "labels": "Labels | Array | Path", "image": "Image | Array | Path",
          "catalogue": "Catalogue | Mapping[str, Any] | Path"}
COMMON = {"domain": ("Frame | Raster | Mapping[str, Any] | None", None,
                     "where what is made lies, if no input says so; 1024 x 1024 cells of 10 m around (0, 0) if left out"),
          "seed": ("int", 0, "of everything random: same seed, same bytes"),
          "threads": ("int", 0, "threads to use; 0: all processors"),
          "progress": ("Callable[[float], object] | None", None, "called with the finished fraction")}


def python_name(name):
    """`with` and `import` are words of the language: with_, import_."""
    return name + "_" if keyword.iskeyword(name) else name


def class_of(kind):
    return kind.title()


def input_type(port):
    return INPUTS.get(port["kind"], class_of(port["kind"]) + (" | Path" if port["kind"] not in ("report",) else ""))


def choices(param):
    return "Literal[" + ", ".join(f'"{choice}"' for choice in param["choices"]) + "]"


def param_type(param, group="Mapping[str, Any]"):
    """`group`: the type of a parameter's members, where it has some."""
    kind = param["kind"]
    if kind in ("choice", "preset"):
        name = choices(param)
    elif kind == "group":
        name = group
    elif kind in ("groups", "tools"):
        name = f"Sequence[{group}]"
    else:
        name = NAMES[kind]
    return name + " | None" if param["default"] is None and not name.endswith("None") else name


def common(op):
    return [name for name in COMMON if name != "seed" or op["stochastic"]]


def parameters(op):
    """(name, type, default, is an input) of all that a call takes; inspect.Parameter.empty where something is needed. Where
    an input has the name of a parameter it stands for both."""
    by_name = {param["name"]: param for param in op["params"]}
    required = [port["required"] for port in op["in"]]
    ordered = required == sorted(required, reverse=True)
    for port in op["in"]:
        kind = input_type(port)
        if port["name"] in by_name:
            kind += " | " + param_type(by_name[port["name"]])
        needed = port["required"] and ordered
        default = inspect.Parameter.empty if needed else None
        yield python_name(port["name"]), kind if needed else optional(kind), default, True
    inputs = {port["name"] for port in op["in"]}
    for param in op["params"]:
        if param["name"] not in inputs:
            yield python_name(param["name"]), param_type(param), param["default"], False
    for name in common(op):
        yield name, COMMON[name][0], COMMON[name][1], False


def optional(kind):
    return kind if kind.endswith("| None") else kind + " | None"


def result_type(op):
    if len(op["out"]) == 1:
        return class_of(op["out"][0]["kind"])
    return python_name(op["name"].partition(".")[2]).title().replace("_", "") + "Result"


def signature(op):
    kinds = {True: inspect.Parameter.POSITIONAL_OR_KEYWORD, False: inspect.Parameter.KEYWORD_ONLY}
    return inspect.Signature(
        [inspect.Parameter(name, kinds[is_input], default=default, annotation=kind)
         for name, kind, default, is_input in parameters(op)], return_annotation=result_type(op))


def number(value):
    return f"{value:.12g}"


def rule(param):
    """"m, 0 to 10000, default 4000"."""
    parts = [param["unit"]] if param["unit"] else []
    low, high = param.get("min"), param.get("max")
    if param.get("choices"):
        parts.append("one of " + ", ".join(param["choices"]))
    elif low is not None and high is not None:
        parts.append(f"{number(low)} to {number(high)}")
    elif low is not None:
        parts.append(f"at least {number(low)}")
    elif high is not None:
        parts.append(f"at most {number(high)}")
    default = param["default"]
    if default is None:
        parts.append("derived if left out" if param["kind"] != "preset" else "none if left out")
    elif default not in ("", [], {}) and param["kind"] != "group":
        parts.append(f"default {number(default) if isinstance(default, float) else default}")
    return ", ".join(parts)


def param_lines(param, indent=""):
    yield from paragraph(f"{python_name(param['name']) if not indent else param['name']} : {param['kind']}", indent)
    told = rule(param)
    yield from paragraph(param["help"] + (f" [{told}]" if told else ""), indent + "    ")
    for preset in param.get("presets", []):
        yield from paragraph(f"\"{preset['name']}\": {preset['about']}", indent + "    ")
    for tool in param.get("tools", []):
        if tool["name"]:
            yield from paragraph(f"{{\"tool\": \"{tool['name']}\"}}: {tool['about']}", indent + "    ")
        for member in tool["params"]:
            yield from param_lines(member, indent + ("      " if tool["name"] else "    "))


def paragraph(text, indent):
    return textwrap.wrap(text, 118, initial_indent=indent, subsequent_indent=indent)


def section(title, lines):
    lines = list(lines)
    return ["", title, "-" * len(title), *lines] if lines else []


def port_lines(port, name):
    yield f"{name} : {class_of(port['kind'])}" + ("" if port["required"] else ", optional")
    yield from paragraph(port["help"], "    ")


def docstring(op):
    lines = paragraph(op["summary"] + ".", "")
    if op["source"]:
        lines += ["", *paragraph("Source: " + op["source"] + ".", "")]
    if op["needs_one"]:
        lines += ["", "One of the inputs is needed."]
    lines += section("Inputs", (line for port in op["in"] for line in port_lines(port, python_name(port["name"]))))
    lines += section("Parameters", (line for param in op["params"] for line in param_lines(param)))
    lines += section("Common to all", (line for name in common(op) for line in
                                       [f"{name} : {COMMON[name][0]}", *paragraph(COMMON[name][2], "    ")]))
    lines += section("Returns", (line for port in op["out"] for line in port_lines(port, python_name(port["name"]))))
    return "\n".join(lines) + "\n"
