# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class ExtractResult(NamedTuple):
    image: Image
    lines: Drawing
    river: Field
    ridge: Field
    altitude: Field
    cue: Field

class LevelsetResult(NamedTuple):
    image: Image
    areas: Drawing
    levelset: Field

def extract(
    terrain: Terrain | Array | Path,
    *,
    coarse_m: float | None = None,
    blur_m: float | None = None,
    min_area_m2: float | None = None,
    cue_area_m2: float | None = None,
    leave: float = 0.3,
    shallow_m: float | None = None,
    min_length: float = 4,
    sea: bool = True,
    min_sea_m2: float | None = None,
    rivers: bool = True,
    ridges: bool = True,
    cues: bool = True,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> ExtractResult:
    """The sketch of a terrain: coarse rivers and ridges, one pixel wide, and heights of peaks and basins.
    
    Source: P1 sec. 5.1, fig. 6-8.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    coarse_m : number
        cell size on which water runs; a 128th of the terrain's longer side if absent [m, 0.01 to 1000000, derived if left
        out]
    blur_m : number
        deviation of the blur before it: how little of the detail is drawn; 0.7 coarse cells if absent [m, 0 to 1000000,
        derived if left out]
    min_area_m2 : number
        ground whose rain makes a river, or a ridge; a 500th of the land if absent [m2, 1 to 1e+13, derived if left out]
    cue_area_m2 : number
        ground whose rain ends in one place and makes it a cue; a 150th of the land if absent [m2, 1 to 1e+13, derived if
        left out]
    leave : number
        probability with which a drop leaves a local minimum [0 to 1, default 0.3]
    shallow_m : number
        relief that is none: minima no deeper hold no water, and valleys and crests that stand out no more are not drawn;
        if absent, a 200th of all relief (for valleys and crests a twentieth of a coarse cell if less), at least a
        hundredth of a coarse cell (10 m at most) and two steps of rounded heights [m, 0 to 1000, derived if left out]
    min_length : number
        shortest branch and piece that is kept, in coarse cells [0 to 100, default 4]
    sea : switch
        rivers end at sea level and ridges stand above it; otherwise the sea floor is ground as well [default True]
    min_sea_m2 : number
        enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m,
        or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2, 0 to 1e+15, derived
        if left out]
    rivers : switch
        draw rivers [default True]
    ridges : switch
        draw ridges [default True]
    cues : switch
        draw peaks and basins with their heights [default True]
    
    Common to all
    -------------
    domain : Frame | Raster | Mapping[str, Any] | None
        where what is made lies, if no input says so; 1024 x 1024 cells of 10 m around (0, 0) if left out
    seed : int
        of everything random: same seed, same bytes
    threads : int
        threads to use; 0: all processors
    progress : Callable[[float], object] | None
        called with the finished fraction
    
    Returns
    -------
    image : Image
        ridges red 255, rivers blue 255, cues green by height: 32 the lowest, 255 the highest; nothing 0
    lines : Drawing
        lines of value 0 (river) or 1 (ridge), and cues as points with height, basin (1 or 0) and green
    river : Field
        1 on rivers, else 0
    ridge : Field
        1 on ridges, else 0
    altitude : Field
        height in metres at the cues, 0 elsewhere
    cue : Field
        1 where altitude counts, else 0
    """
    ...

def levelset(
    terrain: Terrain | Array | Path,
    *,
    percentile: float = 60,
    blur_m: float | None = None,
    sea: bool = True,
    min_sea_m2: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> LevelsetResult:
    """The high part of a terrain as an area.
    
    Source: P1 sec. 5.2, fig. 9.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    percentile : number
        share of the land that lies lower than the levelset [%, 0 to 100, default 60]
    blur_m : number
        deviation of the blur before it; a 64th of the terrain's longer side if absent [m, 0 to 1000000, derived if left
        out]
    sea : switch
        only what lies above sea level counts; otherwise the sea floor is ground as well [default True]
    min_sea_m2 : number
        enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m,
        or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2, 0 to 1e+15, derived
        if left out]
    
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
    image : Image
        white inside, black outside
    areas : Drawing
        the area, with level_m
    levelset : Field
        1 inside, 0 outside
    """
    ...
