# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

def sparse(
    terrain: Terrain | Array | Path,
    *,
    factor: Literal["x2", "x4", "x8"] = 'x4',
    dictionary: str = 'mountains',
    strength: float = 1,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """A terrain on cells of a half, a quarter or an eighth, with the detail of real ground.
    
    Source: P1 sec. 6.2; Guerin et al. 2016.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres, each the mean of its cell
    
    Parameters
    ----------
    factor : choice
        how many cells there are along each side for one: x2, x4, x8 [one of x2, x4, x8, default x4]
    dictionary : model
        ground whose detail it gets: mountains, hills, canyons, or a file of `seamount train dictionary` [default
        mountains]
    strength : number
        how strong the detail is; 0 refines without any [0 to 2, default 1]
    
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
    terrain : Terrain
        heights in metres on the finer cells
    """
    ...
