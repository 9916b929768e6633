# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

def import_(
    *,
    file: Path = '',
    layer: str = '',
    feature: str = '',
    height_field: str = '',
    crs: str = '',
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Drawing:
    """Areas, lines and points from a file, in metres.
    
    Parameters
    ----------
    file : file
        GeoJSON, GeoPackage, Shapefile or SVG file
    layer : text
        layer of a file with several; empty: the first that fits
    feature : text
        only the features of this name, in any letter case; empty: all
    height_field : text
        field with the heights; empty: one named like a height, else z
    crs : text
        coordinate system of a file that says none or a wrong one: EPSG:32627, or local for metres on no map
    
    Common to all
    -------------
    domain : Frame | Raster | Mapping[str, Any] | None
        where what is made lies, if no input says so; 1024 x 1024 cells of 10 m around (0, 0) if left out
    threads : int
        threads to use; 0: all processors
    progress : Callable[[float], object] | None
        called with the finished fraction
    
    Returns
    -------
    drawing : Drawing
        areas, lines and points
    """
    ...
