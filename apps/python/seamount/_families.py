"""The operators as functions, made from the library's own tables: nothing about them is written here."""

import collections
import operator
import os
import sys
import types

from . import _core, _describe
from ._describe import python_name
from ._frame import Frame, as_tuple
from ._notes import say
from ._value import Value, invalid
from ._values import CLASSES, Catalogue, Drawing, Image, Raster, wrap

_RASTERS = {"terrain", "field", "labels"}


def families(package):
    """A module for each family, known to `import`."""
    modules = {}
    for op in _core.schema()["operators"]:
        family, _, name = op["name"].partition(".")
        if family not in modules:
            modules[family] = module = types.ModuleType(f"{package}.{family}", f"Operators of the family {family}.")
            module.__all__ = []
            sys.modules[module.__name__] = module
        module = modules[family]
        function = _function(op, module)
        setattr(module, function.__name__, function)
        module.__all__.append(function.__name__)
    return list(modules.values())


def _function(op, module):
    handle = _core.operator(op["name"])
    ports = {python_name(port["name"]): port for port in op["in"]}
    order = list(ports)
    params = {python_name(param["name"]): param["name"] for param in op["params"]}
    name = python_name(op["name"].partition(".")[2])
    outputs = [python_name(port["name"]) for port in op["out"]]
    result = None if len(outputs) == 1 else collections.namedtuple(_describe.result_type(op), outputs, module=module.__name__)
    if result is not None:
        setattr(module, result.__name__, result)  # where pickle looks for it

    def call(*args, domain=None, seed=None, threads=0, progress=None, **given):
        if len(args) > len(order):
            raise TypeError(f"{op['name']}: {len(args)} inputs are given, it takes {len(order)}")
        for port, value in zip(order, args):
            if port in given:
                raise TypeError(f"{op['name']}: '{port}' is given twice")
            given[port] = value
        seed = _checked_seed(op, seed)
        frame = None if domain is None else _frame_of(domain)
        inputs, values = {}, {}
        for key, value in given.items():
            port = ports.get(key)
            if port is not None and (key not in params or _is_value(value, port["kind"])):
                if value is not None:
                    inputs[port["name"]] = value
            else:
                values[params.get(key, key)] = value
        held = _held_inputs(op, inputs, frame) if inputs else inputs
        made, notes = handle.call(held, values, None if frame is None else as_tuple(frame), seed, threads, progress)
        if notes:
            say(notes)
        return wrap(made[0]) if result is None else result._make(map(wrap, made))

    call.__name__ = call.__qualname__ = name
    call.__module__ = module.__name__
    call.__doc__ = _describe.docstring(op)
    call.__signature__ = _describe.signature(op)
    return call


def _checked_seed(op, seed):
    if seed is None:
        return 0
    if not op["stochastic"]:
        raise TypeError(f"{op['name']}: takes no seed, nothing in it is random")
    if not 0 <= operator.index(seed) < 2**64:
        raise invalid("seed", f"{seed} is outside [0, 2^64 - 1]")
    return operator.index(seed)


def _frame_of(domain):
    if isinstance(domain, Frame):
        return domain
    if isinstance(domain, Raster):
        return domain.frame
    if hasattr(domain, "keys"):
        return Frame.of_domain(**domain)
    raise TypeError(f"domain: {type(domain).__name__} is no Frame, no raster and no mapping")


def _is_value(value, kind):
    """Is it meant for the input, where a parameter has the same name?"""
    return isinstance(value, Value) or hasattr(value, "__geo_interface__") or (kind in _RASTERS and hasattr(value, "shape"))


def _held_inputs(op, given, domain):
    """What the compiled part takes. Arrays lie where the first raster does, in the order of the ports, else on the domain."""
    first, held = None, {}
    for port in op["in"]:
        value = given.get(port["name"])
        if value is None:
            continue
        if not isinstance(value, Value):
            value = _as_value(value, port, domain if first is None else first.frame)
        if first is None and isinstance(value, Raster):
            first = value
        held[port["name"]] = value._held
    return held


def _as_value(value, port, frame):
    """A value of what else an input may be: a file's name, an array, a table of xarray, shapes, a catalogue as a mapping."""
    kind, cls = port["kind"], CLASSES[port["kind"]]
    if isinstance(value, (str, os.PathLike)):
        return cls.read(value, frame=frame)
    if kind in _RASTERS and hasattr(value, "dims") and hasattr(value, "coords"):
        return cls.from_xarray(value)
    if kind in _RASTERS and hasattr(value, "__array__"):
        if frame is None:
            raise invalid(port["name"], "is an array without a place: "
                          f"seamount.{cls.__name__}(array, cell_m=...) gives it one")
        return cls(value, frame)
    if kind == "image" and hasattr(value, "__array__"):
        return Image(value)
    if kind == "drawing" and (hasattr(value, "__geo_interface__") or hasattr(value, "keys")):
        return Drawing(value)
    if kind == "catalogue" and hasattr(value, "keys"):
        return Catalogue(value)
    raise invalid(port["name"], f"is of the type '{type(value).__name__}', which is no {kind}")
