"""Terrain authoring, from ridgeline to reef.

Every operator is a function of its family::

    import seamount as sm

    isle = sm.island.build(peak_m=900, seed=3, domain=sm.Frame(512, 512, 30))
    reef = sm.island.coral(isle.terrain, isle.labels, isle.coordinate, subsidence=0.4)
    reef.terrain.array          # a NumPy array of heights in metres, not a copy
    reef.terrain.save("height.tif")

Lengths are metres, x is east and y north, row 0 of a raster is its northern edge, z = 0 the sea. Parameters, units and
ranges are those of `seamount describe`, since both come from the same tables: help(sm.island.build).
"""

from . import _core
from ._core import Cancelled, Error, IncompatibleInputs, InvalidArgument, IoError, RecipeError, WriteError
from ._families import families as _families
from ._frame import Frame, Transform
from ._notes import logger
from ._recipe import SHARE, Output, Recipe, Run, Step, examples
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain,
                      Things, Tin, Value, read)

__version__ = _core.version

for _family in _families(__name__):
    globals()[_family.__name__.rpartition(".")[2]] = _family
del _family

__all__ = ["Cancelled", "Catalogue", "Contours", "Current", "Drawing", "Error", "Field", "Frame", "Image",
           "IncompatibleInputs", "InvalidArgument", "IoError", "Labels", "Objects", "Output", "Raster", "Recipe",
           "RecipeError", "Report", "Run", "SHARE", "Step", "Terrain", "Things", "Tin", "Transform", "Value", "WriteError",
           "examples", "logger", "read"]
