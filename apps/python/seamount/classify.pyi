# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class TerrainResult(NamedTuple):
    labels: Labels
    exposure: Field

class PaintStrokesRegion(TypedDict, total=False):
    tool: Literal["region"]
    region: Literal["mountain", "beach", "lagoon", "reef", "abyss"]
    """what is painted [one of mountain, beach, lagoon, reef, abyss, default mountain]"""
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    radius_m: float
    """half the width of the stroke [m, 0.01 to 1000000, default 500]"""

class PaintStrokesArea(TypedDict, total=False):
    tool: Literal["area"]
    region: Literal["mountain", "beach", "lagoon", "reef", "abyss"]
    """what is painted [one of mountain, beach, lagoon, reef, abyss, default mountain]"""
    polygons: Sequence[Polygon]
    """what is filled, at least one; an outline may cross itself"""

class PaintStrokesSink(TypedDict, total=False):
    tool: Literal["sink"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    pressure: Sequence[float]
    """how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]"""
    radius_m: float
    """reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]"""
    hardness: float
    """0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]"""
    subsidence: float
    """in the middle of the stroke: 0 not at all, 1 wholly [0 to 1, default 1]"""

class PaintStrokesErase(TypedDict, total=False):
    tool: Literal["erase"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    radius_m: float
    """half the width of the stroke [m, 0.01 to 1000000, default 500]"""

class PaintResult(NamedTuple):
    labels: Labels
    subsidence: Field

def terrain(
    terrain: Terrain | Array | Path,
    *,
    beach_m: float = 5,
    beach_width_m: float = 400,
    beach_slope_deg: float = 10,
    bar_m: float = 6,
    fetch_m: float = 15000,
    exposed: float = 0.2,
    reef_depth_m: float = 20,
    reef_width_m: float = 1200,
    fore_reef_m: float = 80,
    fore_reef_slope_deg: float = 12,
    lagoon_depth_m: float = 80,
    belt_gap_m: float = 20000,
    scale_m: float = 60,
    min_patch_m2: float = 20000,
    min_sea_m2: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> TerrainResult:
    """Labels any terrain by depth, slope and exposure, so that it can enter the methods that build on labels.
    
    Source: P0 sec. 1.4.1 for the regions.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres about sea level
    
    Parameters
    ----------
    beach_m : number
        height up to which land by the sea can be beach [m, 0 to 500, default 5]
    beach_width_m : number
        how far from the water beach reaches [m, 0 to 1000000, default 400]
    beach_slope_deg : number
        steepest beach [deg, 0 to 90, default 10]
    bar_m : number
        depth down to which ground breaks the swell [m, 0 to 500, default 6]
    fetch_m : number
        distance over open water that counts as fully open [m, 1 to 10000000, default 15000]
    exposed : number
        share of open directions from which water counts as exposed [0 to 1, default 0.2]
    reef_depth_m : number
        depth down to which exposed ground is reef [m, 0 to 1000, default 20]
    reef_width_m : number
        how far from exposed water bars are reef, and benches from deep water [m, 0 to 1000000, default 1200]
    fore_reef_m : number
        depth of the foot of the fore reef [m, 0 to 5000, default 80]
    fore_reef_slope_deg : number
        least slope of the fore reef, from the reef's edge [deg, 0.1 to 89, default 12]
    lagoon_depth_m : number
        depth down to which sheltered water is lagoon [m, 0 to 5000, default 80]
    belt_gap_m : number
        widest pass between two reefs of a belt; what lies behind a belt is lagoon [m, 0 to 1000000, default 20000]
    scale_m : number
        forms smaller than this do not count as slope [m, 0 to 100000, default 60]
    min_patch_m2 : number
        smaller patches go to what lies around them [m2, 0 to 1e+12, default 20000]
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
    labels : Labels
        mountain, beach, lagoon, reef, abyss
    exposure : Field
        openness to the sea, 0 to 1; 0 on land
    """
    ...

def follow(
    terrain: Terrain | Array | Path,
    before: Terrain | Array | Path,
    labels: Labels | Array | Path,
    *,
    sea_m: float = 0,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Labels:
    """Labels of a terrain that any steps have changed, from those before.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres, as they are now
    before : Terrain
        the terrain that the labels belong to
    labels : Labels
        its regions before
    
    Parameters
    ----------
    sea_m : number
        level of the sea [m, -12000 to 9000, default 0]
    
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
    labels : Labels
        land is beach or mountain, sea lagoon, reef or abyss
    """
    ...

def paint(
    labels: Labels | Array | Path | None = None,
    subsidence: Field | Array | Path | None = None,
    terrain: Terrain | Array | Path | None = None,
    *,
    base: Literal["mountain", "beach", "lagoon", "reef", "abyss"] = 'abyss',
    strokes: Sequence[PaintStrokesRegion | PaintStrokesArea | PaintStrokesSink | PaintStrokesErase] = [],
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> PaintResult:
    """Regions of an island painted with a pen, over those of a label map or from nothing, and its subsidence.
    
    Source: P0 sec. 1.7 for what may be painted.
    
    Inputs
    ------
    labels : Labels, optional
        what is painted on; `base` everywhere if open
    subsidence : Field, optional
        how far the ground has sunk before, 0 to 1; 0 if open
    terrain : Terrain, optional
        where the map is to lie; its heights do not count
    
    Parameters
    ----------
    base : choice
        region where nothing is painted and no labels come in [one of mountain, beach, lagoon, reef, abyss, default abyss]
    strokes : tools
        what is painted, one stroke after another
        {"tool": "region"}: paints a region along a stroke
          region : choice
              what is painted [one of mountain, beach, lagoon, reef, abyss, default mountain]
          points : points
              places of the pen, at least one; a spline runs through them
          radius_m : number
              half the width of the stroke [m, 0.01 to 1000000, default 500]
        {"tool": "area"}: fills areas with a region
          region : choice
              what is painted [one of mountain, beach, lagoon, reef, abyss, default mountain]
          polygons : polygons
              what is filled, at least one; an outline may cross itself
        {"tool": "sink"}: paints how far the ground has sunk
          points : points
              places of the pen, at least one; a spline runs through them
          pressure : numbers
              how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]
          radius_m : number
              reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]
          hardness : number
              0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]
          subsidence : number
              in the middle of the stroke: 0 not at all, 1 wholly [0 to 1, default 1]
        {"tool": "erase"}: brings back what was there before the step
          points : points
              places of the pen, at least one; a spline runs through them
          radius_m : number
              half the width of the stroke [m, 0.01 to 1000000, default 500]
    
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
    labels : Labels
        mountain, beach, lagoon, reef, abyss
    subsidence : Field
        how far the ground has sunk, 0 to 1
    """
    ...
