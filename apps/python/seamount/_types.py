"""Types that the stubs of the families name."""

import os
import typing

Path = typing.Union[str, "os.PathLike[str]"]
Point = typing.Sequence[float]
"""(x, y) in metres, x east and y north; a knot of a curve."""
Outline = typing.Union[float, typing.Sequence[float]]
"""Radii at equal steps of the angle; one is a circle."""
Polygon = typing.Union[typing.Sequence[Point], typing.Mapping[str, typing.Any]]
"""A ring of points, or {"outer": ring, "holes": [ring, ...]}."""
Region = typing.Union[typing.Sequence[Point], typing.Mapping[str, typing.Any]]
"""A ring of points, or {"name", "ring", "height_m", "peak_m", "basin"}."""
River = typing.Union[typing.Sequence[Point], typing.Mapping[str, typing.Any]]
"""Points from source to mouth, or {"points", "bed_m", "source_width_m", "mouth_width_m"}."""


class Stroke(typing.TypedDict, total=False):
    points: typing.Sequence[Point]
    width_m: float
    strength_m: float


class Array(typing.Protocol):
    """What NumPy makes an array of."""

    def __array__(self) -> typing.Any: ...


class HasGeoInterface(typing.Protocol):
    """Shapes of shapely, tables of geopandas."""

    @property
    def __geo_interface__(self) -> typing.Any: ...


Shapes = typing.Union[typing.Mapping[str, typing.Any], HasGeoInterface]
