# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class SculptStrokesRaise(TypedDict, total=False):
    tool: Literal["raise"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    pressure: Sequence[float]
    """how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]"""
    radius_m: float
    """reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]"""
    hardness: float
    """0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]"""
    height_m: float
    """what it adds in the middle of the stroke [m, 0 to 10000, default 100]"""

class SculptStrokesLower(TypedDict, total=False):
    tool: Literal["lower"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    pressure: Sequence[float]
    """how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]"""
    radius_m: float
    """reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]"""
    hardness: float
    """0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]"""
    depth_m: float
    """what it takes off in the middle of the stroke [m, 0 to 10000, default 100]"""

class SculptStrokesSmooth(TypedDict, total=False):
    tool: Literal["smooth"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    pressure: Sequence[float]
    """how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]"""
    radius_m: float
    """reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]"""
    hardness: float
    """0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]"""
    strength: float
    """share of the detail that goes [0 to 1, default 1]"""

class SculptStrokesFlatten(TypedDict, total=False):
    tool: Literal["flatten"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    pressure: Sequence[float]
    """how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]"""
    radius_m: float
    """reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]"""
    hardness: float
    """0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]"""
    height_m: float | None
    """the height; the ground's where the stroke begins if absent [m, -12000 to 9000, derived if left out]"""
    strength: float
    """how far it goes in the middle of the stroke: 0 not at all, 1 all the way [0 to 1, default 1]"""

class SculptStrokesRamp(TypedDict, total=False):
    tool: Literal["ramp"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    pressure: Sequence[float]
    """how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]"""
    radius_m: float
    """reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]"""
    hardness: float
    """0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]"""
    start_m: float | None
    """height where the stroke begins; the ground's there if absent [m, -12000 to 9000, derived if left out]"""
    end_m: float | None
    """height where the stroke ends; the ground's there if absent [m, -12000 to 9000, derived if left out]"""
    strength: float
    """how far it goes in the middle of the stroke: 0 not at all, 1 all the way [0 to 1, default 1]"""

class SculptStrokesRoughen(TypedDict, total=False):
    tool: Literal["roughen"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    pressure: Sequence[float]
    """how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]"""
    radius_m: float
    """reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]"""
    hardness: float
    """0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]"""
    amplitude_m: float
    """how far ground goes up or down where it goes furthest [m, 0 to 10000, default 50]"""
    wavelength_m: float
    """size of the largest forms; detail of half the size follows, and so on [m, 0.1 to 1000000, default 600]"""

class SculptStrokesErase(TypedDict, total=False):
    tool: Literal["erase"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    pressure: Sequence[float]
    """how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]"""
    radius_m: float
    """reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]"""
    hardness: float
    """0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]"""
    strength: float
    """share of the earlier strokes that goes [0 to 1, default 1]"""

class PaintStrokesBrush(TypedDict, total=False):
    tool: Literal["brush"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    pressure: Sequence[float]
    """how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]"""
    radius_m: float
    """reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]"""
    hardness: float
    """0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]"""
    value: float
    """what is painted [-1000000 to 1000000, default 1]"""
    opacity: float
    """how much of what is there is covered in the middle: 0 nothing, 1 all [0 to 1, default 1]"""

class PaintStrokesArea(TypedDict, total=False):
    tool: Literal["area"]
    polygons: Sequence[Polygon]
    """what is filled, at least one; an outline may cross itself"""
    value: float
    """what is painted [-1000000 to 1000000, default 1]"""
    opacity: float
    """how much of what is there is covered in the middle: 0 nothing, 1 all [0 to 1, default 1]"""
    feather_m: float
    """over which it fades beyond its edge [m, 0 to 1000000, default 0]"""

class PaintStrokesErase(TypedDict, total=False):
    tool: Literal["erase"]
    points: Sequence[Point]
    """places of the pen, at least one; a spline runs through them"""
    pressure: Sequence[float]
    """how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]"""
    radius_m: float
    """reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]"""
    hardness: float
    """0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]"""
    opacity: float
    """share of the earlier strokes that goes [0 to 1, default 1]"""

class MaskCriteriaHeight(TypedDict, total=False):
    tool: Literal["height"]
    low_m: float | None
    """lowest that is fully selected; no limit if absent [m, -12000 to 9000, derived if left out]"""
    high_m: float | None
    """highest that is fully selected; no limit if absent [m, -12000 to 9000, derived if left out]"""
    falloff_m: float
    """over which the selection fades beyond the limits [m, 0 to 20000, default 20]"""
    invert: bool
    """select the rest [default False]"""

class MaskCriteriaDepth(TypedDict, total=False):
    tool: Literal["depth"]
    low_m: float
    """least depth that is fully selected [m, -9000 to 12000, default 0]"""
    high_m: float | None
    """greatest depth that is fully selected [m, -9000 to 12000, derived if left out]"""
    falloff_m: float
    """over which the selection fades beyond the limits [m, 0 to 20000, default 5]"""
    invert: bool
    """select the rest [default False]"""

class MaskCriteriaSlope(TypedDict, total=False):
    tool: Literal["slope"]
    low_deg: float | None
    """lowest that is fully selected; no limit if absent [deg, 0 to 90, derived if left out]"""
    high_deg: float | None
    """highest that is fully selected; no limit if absent [deg, 0 to 90, derived if left out]"""
    falloff_deg: float
    """over which the selection fades beyond the limits [deg, 0 to 90, default 5]"""
    scale_m: float
    """smaller forms are not looked at [m, 0 to 100000, default 30]"""
    invert: bool
    """select the rest [default False]"""

class MaskCriteriaAspect(TypedDict, total=False):
    tool: Literal["aspect"]
    direction_deg: float
    """bearing that the ground faces, clockwise from north [deg, -360 to 360, default 0]"""
    spread_deg: float
    """width of the bearings that are fully selected [deg, 0 to 360, default 60]"""
    falloff_deg: float
    """over which the selection fades beyond the limits [deg, 0 to 180, default 30]"""
    level_deg: float
    """slope below which ground faces nowhere more and more [deg, 0 to 90, default 2]"""
    scale_m: float
    """smaller forms are not looked at [m, 0 to 100000, default 30]"""
    invert: bool
    """select the rest [default False]"""

class MaskCriteriaCurvature(TypedDict, total=False):
    tool: Literal["curvature"]
    bend: Literal["profile", "plan", "mean"]
    """along the line of fall (profile), along the contour (plan), or their mean [one of profile, plan, mean, default mean]"""
    low_per_km: float
    """least curvature that is fully selected: above 0 ridges, below 0 hollows, 1 a radius of a kilometre [1/km, -10000 to 10000, default 0.5]"""
    high_per_km: float | None
    """highest that is fully selected; no limit if absent [1/km, -10000 to 10000, derived if left out]"""
    falloff_per_km: float
    """over which the selection fades beyond the limits [1/km, 0 to 10000, default 0.5]"""
    scale_m: float
    """size of the forms that are looked at [m, 0 to 100000, default 200]"""
    invert: bool
    """select the rest [default False]"""

class MaskCriteriaRegion(TypedDict, total=False):
    tool: Literal["region"]
    region: Literal["mountain", "beach", "lagoon", "reef", "abyss"]
    """region of the label map to whose border the distance is measured [one of mountain, beach, lagoon, reef, abyss, default beach]"""
    low_m: float | None
    """least distance from the region that is fully selected, negative inside; no limit if absent [m, -10000000 to 10000000, derived if left out]"""
    high_m: float
    """greatest distance; 0: the region itself [m, -10000000 to 10000000, default 0]"""
    falloff_m: float
    """over which the selection fades beyond the limits [m, 0 to 10000000, default 100]"""
    invert: bool
    """select the rest [default False]"""

class MaskCriteriaArea(TypedDict, total=False):
    tool: Literal["area"]
    polygons: Sequence[Polygon]
    """areas drawn here; none: those of the input 'drawing', or what its lines enclose"""
    feature: str
    """name of the area in the drawing; empty: all of them"""
    low_m: float | None
    """least distance from the border that is fully selected, negative inside; no limit if absent [m, -10000000 to 10000000, derived if left out]"""
    high_m: float
    """greatest distance; 0: the areas themselves [m, -10000000 to 10000000, default 0]"""
    falloff_m: float
    """feathering beyond the limits [m, 0 to 10000000, default 100]"""
    invert: bool
    """select the rest [default False]"""

class MaskCriteriaLine(TypedDict, total=False):
    tool: Literal["line"]
    points: Sequence[Point]
    """a line drawn here; none: the lines of the input 'drawing'"""
    low_m: float | None
    """least distance that is fully selected; no limit if absent [m, 0 to 10000000, derived if left out]"""
    high_m: float
    """greatest distance that is fully selected [m, 0 to 10000000, default 0]"""
    falloff_m: float
    """over which the selection fades beyond the limits [m, 0 to 10000000, default 200]"""
    invert: bool
    """select the rest [default False]"""

class MaskCriteriaNoise(TypedDict, total=False):
    tool: Literal["noise"]
    coverage: float
    """share of the ground that is selected, about [0 to 1, default 0.5]"""
    softness: float
    """0: patches with sharp borders; 1: soft clouds [0 to 1, default 0.5]"""
    wavelength_m: float
    """size of the largest patches [m, 0.01 to 10000000, default 1000]"""
    octaves: int
    """layers of detail, each of half the size [1 to 16, default 5]"""
    gain: float
    """strength of each layer over the one before [0.1 to 0.95, default 0.5]"""
    invert: bool
    """select the rest [default False]"""

class MaskCriteriaValue(TypedDict, total=False):
    tool: Literal["value"]
    low: float | None
    """least value of the input 'values' that is fully selected [derived if left out]"""
    high: float | None
    """greatest value that is fully selected [derived if left out]"""
    falloff: float
    """over which the selection fades beyond the limits [at least 0, default 0]"""
    invert: bool
    """select the rest [default False]"""

class LayersResult(NamedTuple):
    low: Field
    middle: Field
    high: Field

def import_(
    *,
    file: Path = '',
    cell_m: float | None = None,
    low_m: float | None = None,
    high_m: float | None = None,
    fill_voids: bool = False,
    band: int = 0,
    coding: Literal["numbers", "terrarium", "mapbox"] = 'numbers',
    unit: str = '',
    crs: str = '',
    byte_order: Literal["little", "big"] = 'little',
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """A terrain from a file, in metres and square cells.
    
    Parameters
    ----------
    file : file
        GeoTIFF, HGT, ASC, PNG, EXR, R16, R32 or NPY file
    cell_m : number
        cell size, where the file does not say [m, 0.0001 to 1000000, derived if left out]
    low_m : number
        height of the lowest code of an 8- or 16-bit image [m, -20000 to 20000, derived if left out]
    high_m : number
        height of the highest code of an 8- or 16-bit image [m, -20000 to 20000, derived if left out]
    fill_voids : switch
        give cells without data the heights that the rims of their holes lead to; otherwise they stay unknown [default
        False]
    band : integer
        band of a raster with several; 0: the first, unless they are colours [0 to 1000, default 0]
    coding : choice
        how heights are held: numbers, or in the colours of web map tiles: terrarium, mapbox (Terrain-RGB) [one of
        numbers, terrarium, mapbox, default numbers]
    unit : text
        unit of the heights, such as feet, where the file says none or a wrong one
    crs : text
        coordinate system, such as EPSG:4326, where the file says none or a wrong one; local: metres
    byte_order : choice
        which byte of a sample of a raw 16-bit file comes first: little, big [one of little, big, default little]
    
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

def join(
    *,
    files: Sequence[Path] = [],
    low_m: float | None = None,
    high_m: float | None = None,
    fill_voids: bool = False,
    coding: Literal["numbers", "terrarium", "mapbox"] = 'numbers',
    unit: str = '',
    crs: str = '',
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """Neighbouring files of elevation as one terrain, cell by cell.
    
    Parameters
    ----------
    files : files
        neighbouring files that say where they lie; where they overlap the first counts
    low_m : number
        height of the lowest code of 8- or 16-bit images [m, -20000 to 20000, derived if left out]
    high_m : number
        height of the highest code of 8- or 16-bit images [m, -20000 to 20000, derived if left out]
    fill_voids : switch
        give cells without data the heights that the rims of their holes lead to; otherwise they stay unknown [default
        False]
    coding : choice
        how heights are held: numbers, or in the colours of web map tiles: terrarium, mapbox (Terrain-RGB) [one of
        numbers, terrarium, mapbox, default numbers]
    unit : text
        unit of the heights, such as feet, where the files say none or a wrong one
    crs : text
        coordinate system, such as EPSG:4326, where the files say none or a wrong one; local: metres
    
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

def noise(
    *,
    kind: Literal["smooth", "ridged", "mountains"] = 'mountains',
    height_m: float | None = None,
    wavelength_m: float = 4000,
    octaves: int = 8,
    gain: float = 0.5,
    base_m: float = 0,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """Fractal noise: mountains with valleys, smooth or ridged.
    
    Source: Perlin 2002, Musgrave 1994.
    
    Parameters
    ----------
    kind : choice
        smooth: rolling hills, half of them below base_m; ridged: sharp crests; mountains: land with valleys that run down
        its slopes [one of smooth, ridged, mountains, default mountains]
    height_m : number
        height of the noise: about half the relief of smooth noise, all of it for the others; 400 by default, of mountains
        a quarter of the wavelength [m, 0 to 10000, derived if left out]
    wavelength_m : number
        size of the largest forms [m, 0.01 to 10000000, default 4000]
    octaves : integer
        layers of detail, each of half the size [1 to 16, default 8]
    gain : number
        height of each layer over that of the one before [0.1 to 0.95, default 0.5]
    base_m : number
        height to which the noise is added [m, -12000 to 9000, default 0]
    
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

def resample(
    terrain: Terrain | Array | Path,
    *,
    cell_m: float | None = None,
    centre: bool = True,
    scale: float = 1,
    beyond: Literal["unknown", "edge"] = 'unknown',
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """A terrain at another cell size, or on the document's domain.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    cell_m : number
        cell size over the terrain's own extent; if absent the terrain is brought to the document's domain [m, 0.0001 to
        1000000, derived if left out]
    centre : switch
        to the domain: put the terrain's middle at the domain's middle; otherwise its coordinates count [default True]
    scale : number
        stretches the terrain, width and height alike [0.001 to 1000, default 1]
    beyond : choice
        what lies beyond the terrain: unknown, which later steps fill or respect; edge: its nearest cells [one of unknown,
        edge, default unknown]
    
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

def sea_floor(
    terrain: Terrain | Array | Path,
    *,
    depth_m: float = 200,
    steepness: float = 0.5,
    min_slope_deg: float = 0.3,
    shore_m: float = 1500,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """A plausible sea floor for elevation models of land, whose sea is 0 m everywhere.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    depth_m : number
        greatest depth, far from land [m, 1 to 11000, default 200]
    steepness : number
        slope of the floor at the coast, as a share of the land's [0 to 10, default 0.5]
    min_slope_deg : number
        least slope of the floor at the coast [deg, 0.01 to 60, default 0.3]
    shore_m : number
        how far inland the slope of the land is measured [m, 1 to 100000, default 1500]
    
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

def samples(
    terrain: Terrain | Array | Path,
    *,
    layout: Literal["square", "whole", "tiles"] = 'square',
    samples: int = 0,
    choices: Sequence[int] = [],
    fit: Literal["crop", "pad"] = 'crop',
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """A terrain as the samples that game engines and tiles want, the outer ones on its edge.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    layout : choice
        square; whole: all of the terrain, as long as it is; tiles: all of it with its own cells, as whole tiles that
        share their border samples, the last ones padded with its edge [one of square, whole, tiles, default square]
    samples : integer
        samples of a square's side, of the longer side of the whole, or of one tile; 0: the largest of `choices` that the
        terrain fills, the smallest if it fills none; without choices as many as it has [0 to 16385, default 0]
    choices : integers
        numbers to choose from where `samples` is 0 [2 to 16385]
    fit : choice
        square, of a terrain that is none: crop takes the middle, pad keeps all and repeats its edge [one of crop, pad,
        default crop]
    
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

def blend(
    terrain: Terrain | Array | Path,
    with_: Terrain | Array | Path,
    mask: Field | Array | Path | None = None,
    *,
    mode: Literal["mix", "max", "min", "add", "subtract"] = 'mix',
    strength: float = 1,
    smooth_m: float = 5,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """Two terrains become one: mixed, the higher, the lower, added or subtracted, all over or by a mask.
    
    Source: P0 sec. 1.4.2, eq. 1.15 for the smooth maximum.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    with_ : Terrain
        the second terrain, of the same size
    mask : Field, optional
        where it is done, 0 to 1; everywhere if open
    
    Parameters
    ----------
    mode : choice
        mix: the second in place of the first; max, min: the higher, the lower; add, subtract: the second put on or carved
        out [one of mix, max, min, add, subtract, default mix]
    strength : number
        how much of it is done; a mask is multiplied with it [0 to 1, default 1]
    smooth_m : number
        max and min: how far the rounded result lies beyond both where they are equal; 0: a sharp crease [m, 0 to 1000,
        default 5]
    
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

def compose(
    terrain: Terrain | Array | Path,
    terrain_2: Terrain | Array | Path | None = None,
    terrain_3: Terrain | Array | Path | None = None,
    terrain_4: Terrain | Array | Path | None = None,
    terrain_5: Terrain | Array | Path | None = None,
    terrain_6: Terrain | Array | Path | None = None,
    terrain_7: Terrain | Array | Path | None = None,
    terrain_8: Terrain | Array | Path | None = None,
    *,
    places: Sequence[Point] = [],
    turns_deg: Sequence[float] = [],
    scales: Sequence[float] = [],
    raises_m: Sequence[float] = [],
    feather_m: float = 500,
    outside_m: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """Several terrains in one domain, moved, turned and scaled, with feathered seams.
    
    Source: Porter and Duff 1984.
    
    Inputs
    ------
    terrain : Terrain
        the lowest terrain
    terrain_2 : Terrain, optional
        a terrain over those before it
    terrain_3 : Terrain, optional
        a terrain over those before it
    terrain_4 : Terrain, optional
        a terrain over those before it
    terrain_5 : Terrain, optional
        a terrain over those before it
    terrain_6 : Terrain, optional
        a terrain over those before it
    terrain_7 : Terrain, optional
        a terrain over those before it
    terrain_8 : Terrain, optional
        a terrain over those before it
    
    Parameters
    ----------
    places : points
        where each terrain's middle goes; a single terrain is copied to every place; none: terrains lie where their
        coordinates put them
    turns_deg : numbers
        how far each terrain is turned, counter-clockwise; missing ones are 0 [deg, -360 to 360]
    scales : numbers
        how much each terrain is scaled, width and height alike; missing ones are 1 [0.01 to 100]
    raises_m : numbers
        how far each terrain is raised after scaling; missing ones are 0 [m, -20000 to 20000]
    feather_m : number
        width of the seams; 0: cut sharply [m, 0 to 10000000, default 500]
    outside_m : number
        height of the plain on which all terrains lie; if absent such ground stays unknown, for learned.sketch to make [m,
        -12000 to 9000, derived if left out]
    
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

def crop(
    terrain: Terrain | Array | Path,
    *,
    width_m: float = 10000,
    height_m: float | None = None,
    around: Literal["middle", "highest", "lowest"] = 'middle',
    x_m: float | None = None,
    y_m: float | None = None,
    longitude_deg: float | None = None,
    latitude_deg: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """A part of a terrain around a place, its summit or its middle, where it lies.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    width_m : number
        extent from west to east [m, 0.001 to 10000000, default 10000]
    height_m : number
        extent from south to north; by default the same [m, 0.001 to 10000000, derived if left out]
    around : choice
        what is in the middle: the terrain's middle, its highest or its lowest cell [one of middle, highest, lowest,
        default middle]
    x_m : number
        with y_m: the place in the middle instead, east [m, derived if left out]
    y_m : number
        with x_m: the place in the middle, north [m, derived if left out]
    longitude_deg : number
        with latitude_deg: the place in the middle, on WGS 84; the terrain must have a coordinate system [deg, -540 to
        540, derived if left out]
    latitude_deg : number
        with longitude_deg: the place in the middle [deg, -90 to 90, derived if left out]
    
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

def smooth(
    terrain: Terrain | Array | Path,
    mask: Field | Array | Path | None = None,
    *,
    radius_m: float = 60,
    strength: float = 1,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """A terrain with its detail taken off or exaggerated, all over or by a mask.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    mask : Field, optional
        where it is done, 0 to 1; everywhere if open
    
    Parameters
    ----------
    radius_m : number
        size of what vanishes: deviation of the Gaussian [m, 0 to 100000, default 60]
    strength : number
        1 smooths wholly, 0 not at all; below 0 detail is exaggerated instead [-3 to 1, default 1]
    
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

def terrace(
    terrain: Terrain | Array | Path,
    mask: Field | Array | Path | None = None,
    *,
    step_m: float = 80,
    flatness: float = 0.75,
    riser: float = 0.25,
    variation: float = 0.5,
    wander_m: float = 15,
    wander_wavelength_m: float = 3000,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """Slopes become treads and risers, as where hard beds lie in soft ones; erosion makes walls of them.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    mask : Field, optional
        where it is done, 0 to 1; everywhere if open
    
    Parameters
    ----------
    step_m : number
        mean height from tread to tread [m, 0.01 to 5000, default 80]
    flatness : number
        0 leaves the slope as it is, 1 makes treads level [0 to 1, default 0.75]
    riser : number
        share of the slope that becomes the riser of a step [0.02 to 1, default 0.25]
    variation : number
        how much thicknesses of steps differ [0 to 1, default 0.5]
    wander_m : number
        how far a tread's height wanders from place to place [m, 0 to 2000, default 15]
    wander_wavelength_m : number
        over what distance it does [m, 1 to 1000000, default 3000]
    
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

def sculpt(
    terrain: Terrain | Array | Path,
    mask: Field | Array | Path | None = None,
    *,
    strokes: Sequence[SculptStrokesRaise | SculptStrokesLower | SculptStrokesSmooth | SculptStrokesFlatten | SculptStrokesRamp | SculptStrokesRoughen | SculptStrokesErase] = [],
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """Strokes of a pen raise, lower, smooth, flatten, slope, roughen the ground, and are erased.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    mask : Field, optional
        where it is done, 0 to 1; everywhere if open
    
    Parameters
    ----------
    strokes : tools
        what the pen does, one stroke after another
        {"tool": "raise"}: puts ground on
          points : points
              places of the pen, at least one; a spline runs through them
          pressure : numbers
              how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]
          radius_m : number
              reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]
          hardness : number
              0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]
          height_m : number
              what it adds in the middle of the stroke [m, 0 to 10000, default 100]
        {"tool": "lower"}: takes ground off
          points : points
              places of the pen, at least one; a spline runs through them
          pressure : numbers
              how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]
          radius_m : number
              reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]
          hardness : number
              0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]
          depth_m : number
              what it takes off in the middle of the stroke [m, 0 to 10000, default 100]
        {"tool": "smooth"}: takes off forms up to about the radius
          points : points
              places of the pen, at least one; a spline runs through them
          pressure : numbers
              how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]
          radius_m : number
              reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]
          hardness : number
              0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]
          strength : number
              share of the detail that goes [0 to 1, default 1]
        {"tool": "flatten"}: brings ground to one height
          points : points
              places of the pen, at least one; a spline runs through them
          pressure : numbers
              how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]
          radius_m : number
              reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]
          hardness : number
              0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]
          height_m : number
              the height; the ground's where the stroke begins if absent [m, -12000 to 9000, derived if left out]
          strength : number
              how far it goes in the middle of the stroke: 0 not at all, 1 all the way [0 to 1, default 1]
        {"tool": "ramp"}: makes an even slope from where the stroke begins to where it ends
          points : points
              places of the pen, at least one; a spline runs through them
          pressure : numbers
              how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]
          radius_m : number
              reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]
          hardness : number
              0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]
          start_m : number
              height where the stroke begins; the ground's there if absent [m, -12000 to 9000, derived if left out]
          end_m : number
              height where the stroke ends; the ground's there if absent [m, -12000 to 9000, derived if left out]
          strength : number
              how far it goes in the middle of the stroke: 0 not at all, 1 all the way [0 to 1, default 1]
        {"tool": "roughen"}: gives ground natural detail
          points : points
              places of the pen, at least one; a spline runs through them
          pressure : numbers
              how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]
          radius_m : number
              reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]
          hardness : number
              0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]
          amplitude_m : number
              how far ground goes up or down where it goes furthest [m, 0 to 10000, default 50]
          wavelength_m : number
              size of the largest forms; detail of half the size follows, and so on [m, 0.1 to 1000000, default 600]
        {"tool": "erase"}: brings back the ground as it came into the step
          points : points
              places of the pen, at least one; a spline runs through them
          pressure : numbers
              how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]
          radius_m : number
              reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]
          hardness : number
              0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]
          strength : number
              share of the earlier strokes that goes [0 to 1, default 1]
    
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

def paint(
    values: Field | Array | Path | None = None,
    terrain: Terrain | Array | Path | None = None,
    *,
    base: float = 0,
    unknown: bool = False,
    strokes: Sequence[PaintStrokesBrush | PaintStrokesArea | PaintStrokesErase] = [],
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Field:
    """A field painted with a pen: a mask, a density, a hardness, where ground is to be made anew.
    
    Inputs
    ------
    values : Field, optional
        what is painted on; `base` everywhere if open
    terrain : Terrain, optional
        where the field is to lie; its heights do not count
    
    Parameters
    ----------
    base : number
        value where nothing is painted and no values come in [-1000000 to 1000000, default 0]
    unknown : switch
        where nothing is painted nothing is known, in place of `base`: for the levelset of learned.sketch [default False]
    strokes : tools
        what is painted, one stroke after another
        {"tool": "brush"}: paints a value along a stroke
          points : points
              places of the pen, at least one; a spline runs through them
          pressure : numbers
              how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]
          radius_m : number
              reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]
          hardness : number
              0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]
          value : number
              what is painted [-1000000 to 1000000, default 1]
          opacity : number
              how much of what is there is covered in the middle: 0 nothing, 1 all [0 to 1, default 1]
        {"tool": "area"}: fills areas with a value
          polygons : polygons
              what is filled, at least one; an outline may cross itself
          value : number
              what is painted [-1000000 to 1000000, default 1]
          opacity : number
              how much of what is there is covered in the middle: 0 nothing, 1 all [0 to 1, default 1]
          feather_m : number
              over which it fades beyond its edge [m, 0 to 1000000, default 0]
        {"tool": "erase"}: brings back what was there before the step
          points : points
              places of the pen, at least one; a spline runs through them
          pressure : numbers
              how hard the pen was pressed at each point: share of what the stroke does; none: 1 [0 to 1]
          radius_m : number
              reach to either side, where the stroke ends [m, 0.01 to 1000000, default 500]
          hardness : number
              0: soft from the middle on; 1: the same all over, with a sharp edge [0 to 1, default 0]
          opacity : number
              share of the earlier strokes that goes [0 to 1, default 1]
    
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
    values : Field
        the painted field
    """
    ...

def mask(
    terrain: Terrain | Array | Path,
    labels: Labels | Array | Path | None = None,
    drawing: Drawing | Shapes | Path | None = None,
    values: Field | Array | Path | None = None,
    mask: Field | Array | Path | None = None,
    *,
    criteria: Sequence[MaskCriteriaHeight | MaskCriteriaDepth | MaskCriteriaSlope | MaskCriteriaAspect | MaskCriteriaCurvature | MaskCriteriaRegion | MaskCriteriaArea | MaskCriteriaLine | MaskCriteriaNoise | MaskCriteriaValue] = [],
    combine: Literal["product", "min", "max"] = 'product',
    invert: bool = False,
    low: float = 0,
    high: float = 1,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Field:
    """A soft selection by height, depth, slope, aspect, curvature, regions, drawn areas and lines, noise or any field.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    labels : Labels, optional
        its regions, for the criterion region
    drawing : Drawing, optional
        areas and lines, for the criteria area and line
    values : Field, optional
        any field, for the criterion value
    mask : Field, optional
        one more mask, combined like a criterion
    
    Parameters
    ----------
    criteria : tools
        what is selected; none: everything
        {"tool": "height"}: selects by height above the sea
          low_m : number
              lowest that is fully selected; no limit if absent [m, -12000 to 9000, derived if left out]
          high_m : number
              highest that is fully selected; no limit if absent [m, -12000 to 9000, derived if left out]
          falloff_m : number
              over which the selection fades beyond the limits [m, 0 to 20000, default 20]
          invert : switch
              select the rest [default False]
        {"tool": "depth"}: selects by depth below the sea
          low_m : number
              least depth that is fully selected [m, -9000 to 12000, default 0]
          high_m : number
              greatest depth that is fully selected [m, -9000 to 12000, derived if left out]
          falloff_m : number
              over which the selection fades beyond the limits [m, 0 to 20000, default 5]
          invert : switch
              select the rest [default False]
        {"tool": "slope"}: selects by steepness
          low_deg : number
              lowest that is fully selected; no limit if absent [deg, 0 to 90, derived if left out]
          high_deg : number
              highest that is fully selected; no limit if absent [deg, 0 to 90, derived if left out]
          falloff_deg : number
              over which the selection fades beyond the limits [deg, 0 to 90, default 5]
          scale_m : number
              smaller forms are not looked at [m, 0 to 100000, default 30]
          invert : switch
              select the rest [default False]
        {"tool": "aspect"}: selects by the bearing that the ground faces
          direction_deg : number
              bearing that the ground faces, clockwise from north [deg, -360 to 360, default 0]
          spread_deg : number
              width of the bearings that are fully selected [deg, 0 to 360, default 60]
          falloff_deg : number
              over which the selection fades beyond the limits [deg, 0 to 180, default 30]
          level_deg : number
              slope below which ground faces nowhere more and more [deg, 0 to 90, default 2]
          scale_m : number
              smaller forms are not looked at [m, 0 to 100000, default 30]
          invert : switch
              select the rest [default False]
        {"tool": "curvature"}: selects ridges or hollows
          bend : choice
              along the line of fall (profile), along the contour (plan), or their mean [one of profile, plan, mean,
              default mean]
          low_per_km : number
              least curvature that is fully selected: above 0 ridges, below 0 hollows, 1 a radius of a kilometre [1/km,
              -10000 to 10000, default 0.5]
          high_per_km : number
              highest that is fully selected; no limit if absent [1/km, -10000 to 10000, derived if left out]
          falloff_per_km : number
              over which the selection fades beyond the limits [1/km, 0 to 10000, default 0.5]
          scale_m : number
              size of the forms that are looked at [m, 0 to 100000, default 200]
          invert : switch
              select the rest [default False]
        {"tool": "region"}: selects by distance from a region of the label map
          region : choice
              region of the label map to whose border the distance is measured [one of mountain, beach, lagoon, reef,
              abyss, default beach]
          low_m : number
              least distance from the region that is fully selected, negative inside; no limit if absent [m, -10000000 to
              10000000, derived if left out]
          high_m : number
              greatest distance; 0: the region itself [m, -10000000 to 10000000, default 0]
          falloff_m : number
              over which the selection fades beyond the limits [m, 0 to 10000000, default 100]
          invert : switch
              select the rest [default False]
        {"tool": "area"}: selects drawn areas, or by distance from their border
          polygons : polygons
              areas drawn here; none: those of the input 'drawing', or what its lines enclose
          feature : text
              name of the area in the drawing; empty: all of them
          low_m : number
              least distance from the border that is fully selected, negative inside; no limit if absent [m, -10000000 to
              10000000, derived if left out]
          high_m : number
              greatest distance; 0: the areas themselves [m, -10000000 to 10000000, default 0]
          falloff_m : number
              feathering beyond the limits [m, 0 to 10000000, default 100]
          invert : switch
              select the rest [default False]
        {"tool": "line"}: selects by distance from a drawn line
          points : points
              a line drawn here; none: the lines of the input 'drawing'
          low_m : number
              least distance that is fully selected; no limit if absent [m, 0 to 10000000, derived if left out]
          high_m : number
              greatest distance that is fully selected [m, 0 to 10000000, default 0]
          falloff_m : number
              over which the selection fades beyond the limits [m, 0 to 10000000, default 200]
          invert : switch
              select the rest [default False]
        {"tool": "noise"}: selects patches of noise
          coverage : number
              share of the ground that is selected, about [0 to 1, default 0.5]
          softness : number
              0: patches with sharp borders; 1: soft clouds [0 to 1, default 0.5]
          wavelength_m : number
              size of the largest patches [m, 0.01 to 10000000, default 1000]
          octaves : integer
              layers of detail, each of half the size [1 to 16, default 5]
          gain : number
              strength of each layer over the one before [0.1 to 0.95, default 0.5]
          invert : switch
              select the rest [default False]
        {"tool": "value"}: selects by the input 'values'
          low : number
              least value of the input 'values' that is fully selected [derived if left out]
          high : number
              greatest value that is fully selected [derived if left out]
          falloff : number
              over which the selection fades beyond the limits [at least 0, default 0]
          invert : switch
              select the rest [default False]
    combine : choice
        how criteria are combined: product or min where all must hold, max where any [one of product, min, max, default
        product]
    invert : switch
        select what would not be [default False]
    low : number
        value of ground that is not selected; low 1 and high 10 make a hardness for erosion.run [-1000000 to 1000000,
        default 0]
    high : number
        value of ground that is selected; soft edges lie between [-1000000 to 1000000, default 1]
    
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
    mask : Field
        `low` (0) where nothing is selected, `high` (1) where all is
    """
    ...

def layers(
    terrain: Terrain | Array | Path,
    *,
    low_m: float | None = None,
    low_error_m: float | None = None,
    high_m: float | None = None,
    high_error_m: float | None = None,
    smooth: bool = True,
    variation: float = 0.5,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> LayersResult:
    """How much of each place is low, middle and high ground: three masks that sum to one.
    
    Source: P4 sec. 3.4, eq. 3-6.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    low_m : number
        height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as the
        style asks [m, -12000 to 9000, derived if left out]
    low_error_m : number
        height above low_m over which the low layer fades; by default 0.1 of the relief [m, 0 to 20000, derived if left
        out]
    high_m : number
        height from which the high layer takes over; by default 0.5 of the relief [m, -12000 to 9000, derived if left out]
    high_error_m : number
        height below high_m over which the high layer fades in; by default 0.05 of the relief [m, 0 to 20000, derived if
        left out]
    smooth : switch
        layers fade in and out softly; off: linearly, as in the paper [default True]
    variation : number
        how far borders stray from one height, by noise and on steep ground, which is more of the middle layer [0 to 1,
        default 0.5]
    
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
    low : Field
        share of the low layer
    middle : Field
        share of the middle layer
    high : Field
        share of the high layer
    """
    ...
