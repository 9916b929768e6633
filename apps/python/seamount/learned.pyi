# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class SketchRidges(TypedDict, total=False):
    points: Sequence[Point]
    """the line's points"""

class SketchRivers(TypedDict, total=False):
    points: Sequence[Point]
    """the line's points"""

class SketchHeights(TypedDict, total=False):
    x_m: float
    """east of the domain's middle, or in its system [m, -100000000 to 100000000, default 0]"""
    y_m: float
    """north of it [m, -100000000 to 100000000, default 0]"""
    height_m: float
    """height of the ground there [m, -12000 to 9000, default 0]"""

def sketch(
    lines: Drawing | Shapes | Path | None = None,
    image: Image | Array | Path | None = None,
    river: Field | Array | Path | None = None,
    ridge: Field | Array | Path | None = None,
    levelset: Field | Array | Path | None = None,
    terrain: Terrain | Array | Path | None = None,
    erase: Field | Array | Path | None = None,
    *,
    ridges: Sequence[SketchRidges] = [],
    rivers: Sequence[SketchRivers] = [],
    heights: Sequence[SketchHeights] = [],
    low_m: float | None = None,
    relief_m: float | None = None,
    adherence: float = 1,
    model: str = 'sketch',
    precision: Literal["automatic", "f32", "bf16"] = 'automatic',
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """Terrain from a sketch of ridges, rivers, heights, high ground and known ground in any mix, by a network.
    
    Source: P1 sec. 4 to 6.1, 6.3.
    
    Inputs
    ------
    lines : Drawing, optional
        lines of value 0 (river) or 1 (ridge), points with heights, areas of high ground
    image : Image, optional
        a painted sketch over the domain: ridges red, rivers blue
    river : Field, optional
        above 0.5 on rivers
    ridge : Field, optional
        above 0.5 on ridges
    levelset : Field, optional
        1 on high ground, 0 on low, unknown where nothing is said
    terrain : Terrain, optional
        known ground, which stays; unknown cells are made
    erase : Field, optional
        above 0.5 where known ground is made anew
    
    Parameters
    ----------
    ridges : groups
        crest lines
        points : points
            the line's points
    rivers : groups
        rivers, in any direction
        points : points
            the line's points
    heights : groups
        places whose height is given: summits, basins, passes
        x_m : number
            east of the domain's middle, or in its system [m, -100000000 to 100000000, default 0]
        y_m : number
            north of it [m, -100000000 to 100000000, default 0]
        height_m : number
            height of the ground there [m, -12000 to 9000, default 0]
    low_m : number
        height of the low ground; if absent, the lowest that is drawn or known, or, where that is near the highest, two
        fifths of a usual relief below it (of the highest itself if less); 0 where nothing has a height [m, -12000 to
        9000, derived if left out]
    relief_m : number
        how far high ground rises above it; if absent, as heights and known ground say, else what is usual for mountains
        of the domain's width [m, 1 to 12000, derived if left out]
    adherence : number
        how closely what is drawn is met: 1 heights exactly, and lines carved and sharpened a little; 0 as the network
        sees fit [0 to 1, default 1]
    model : model
        network: a shipped one by its word, or a file of weights (safetensors) [default sketch]
    precision : choice
        of the network's sums [one of automatic, f32, bf16, default automatic]
    
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
    terrain : Terrain
        heights in metres
    """
    ...

def island(
    labels: Labels | Array | Path | None = None,
    subsidence: Field | Array | Path | float | None = None,
    *,
    painting: Path = '',
    scale: float | None = None,
    peak_m: float | None = None,
    floor_m: float | None = None,
    reef_depth_m: float | None = None,
    model: str = 'island',
    precision: Literal["automatic", "f32", "bf16"] = 'automatic',
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """Island terrain from a map of its regions, painted or made, by a network.
    
    Source: P0 sec. 1.5 to 1.7.
    
    Inputs
    ------
    labels : Labels, optional
        regions
    subsidence : Field, optional
        how far the ground has sunk, 0 to 1
    
    Parameters
    ----------
    painting : file
        picture over the domain in the colours of regions: mountain yellow, beach green, lagoon cyan, reef blue, abyss
        red; the darker, the more it has sunk
    subsidence : number
        how far the island has sunk, where no painting and no field says [0 to 1, default 0]
    scale : number
        size of everything, heights too, against islands shown on 20 km; if absent, the domain's longer side over 20 km,
        at most 1 [0.02 to 4, derived if left out]
    peak_m : number
        height of the highest summit, met exactly; if absent, as the network sees fit [m, 1 to 9000, derived if left out]
    floor_m : number
        height of the deepest sea floor, a two hundredth of it aside; if absent, as the network sees fit [m, -12000 to -1,
        derived if left out]
    reef_depth_m : number
        depth of the reef's crest where nothing has sunk; if absent, as the network sees fit [m, 0 to 100, derived if left
        out]
    model : model
        network: a shipped one by its word, or a file of weights (safetensors) [default island]
    precision : choice
        of the network's sums [one of automatic, f32, bf16, default automatic]
    
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
    terrain : Terrain
        heights in metres
    """
    ...

def erode(
    terrain: Terrain | Array | Path,
    mask: Field | Array | Path | None = None,
    *,
    years: float = 30000,
    strength: float = 1,
    sea_m: float = 0,
    model: str = 'erode',
    precision: Literal["automatic", "f32", "bf16"] = 'automatic',
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """Years of rivers, slides and creep in a moment, by a network that learned from erosion.run (early weights).
    
    Source: ours; the simulation is erosion.run.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    mask : Field, optional
        share of the change that is kept: 0 nothing, 1 all; everywhere if absent
    
    Parameters
    ----------
    years : number
        how long erosion acts [yr, 0 to 300000, default 30000]
    strength : number
        share of the change that is kept, times the mask [0 to 1, default 1]
    sea_m : number
        level of the sea; far below the terrain for none [m, -12000 to 9000, default 0]
    model : model
        network: a shipped one by its word, or a file of weights (safetensors) [default erode]
    precision : choice
        of the network's sums [one of automatic, f32, bf16, default automatic]
    
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
        heights in metres
    """
    ...
