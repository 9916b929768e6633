# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class EditEditsWarp(TypedDict, total=False):
    tool: Literal["warp"]
    stroke: Sequence[Point]
    """points of the stroke, at least two; a spline runs through them"""
    radius_m: float
    """radius of the disc that is dragged along the stroke [m, 0.1 to 1000000, default 500]"""
    strength: float
    """1 carries what lies at the stroke's beginning to its end, 0 moves nothing [0 to 1, default 1]"""
    k: int
    """how narrow the drag is across the disc: (4x(1-x))^k [1 to 16, default 2]"""
    profile: Sequence[Point]
    """drag across the disc from rim (0) to rim (1), in place of k: 0 at both, above 0 in the middle [0 to 1]"""
    step_m: float | None
    """length of the steps of the drag; at most 0.5, 0.64, 0.58 radii for k = 1, 2, 3; half that if derived [m, 0.001 to 1000000, derived if left out]"""

class EditEditsSlope(TypedDict, total=False):
    tool: Literal["slope"]
    stroke: Sequence[Point]
    """points of the curve; one alone works about a point"""
    radius_m: float
    """reach on both sides of the curve [m, 0.1 to 1000000, default 500]"""
    strength: float
    """above 0 steeper along the curve, below 0 gentler [-1 to 1, default 0.5]"""
    k: int
    """how narrow the ring is that gives way: (4x(1-x))^k [1 to 16, default 1]"""

class EditeditssmoothSelect(TypedDict, total=False):
    low_m: float | None
    """heights from here on [m, -12000 to 9000, derived if left out]"""
    high_m: float | None
    """heights up to here [m, -12000 to 9000, derived if left out]"""
    min_area_m2: float | None
    """enclosed areas from here on [m2, at least 0, derived if left out]"""
    max_area_m2: float | None
    """enclosed areas up to here [m2, at least 0, derived if left out]"""
    within: Sequence[Polygon]
    """those that lie wholly in one of these polygons"""
    at: Sequence[Point]
    """the contour nearest to each of these places"""
    index: Sequence[int]
    """these, by their number in the set, from 0 [at least 0]"""
    inner: bool
    """and everything that lies inside a contour so found [default False]"""

class EditEditsSmooth(TypedDict, total=False):
    tool: Literal["smooth"]
    select: EditeditssmoothSelect
    """the contours to smooth; all unless said"""
    radius_m: float
    """arc to either side that is averaged [m, 0.01 to 1000000, default 100]"""
    strength: float
    """share of the way to the mean [0 to 1, default 1]"""
    rounds: int
    """how often [1 to 100, default 2]"""

class EditEditsFractalize(TypedDict, total=False):
    tool: Literal["fractalize"]
    within: Sequence[Polygon]
    """where; everywhere unless said"""
    amplitude_m: float
    """displacement by the longest wavelength [m, 0 to 100000, default 60]"""
    wavelength_m: float
    """longest wavelength; each octave halves it [m, 1 to 1000000, default 800]"""
    octaves: int
    """how many wavelengths [1 to 12, default 5]"""
    gain: float
    """displacement by an octave over that by the one before [0 to 1, default 0.5]"""
    fade_m: float
    """over which it fades to nothing at the border [m, 0.1 to 1000000, default 300]"""

class EditeditsdeleteSelect(TypedDict, total=False):
    low_m: float | None
    """heights from here on [m, -12000 to 9000, derived if left out]"""
    high_m: float | None
    """heights up to here [m, -12000 to 9000, derived if left out]"""
    min_area_m2: float | None
    """enclosed areas from here on [m2, at least 0, derived if left out]"""
    max_area_m2: float | None
    """enclosed areas up to here [m2, at least 0, derived if left out]"""
    within: Sequence[Polygon]
    """those that lie wholly in one of these polygons"""
    at: Sequence[Point]
    """the contour nearest to each of these places"""
    index: Sequence[int]
    """these, by their number in the set, from 0 [at least 0]"""
    inner: bool
    """and everything that lies inside a contour so found [default False]"""

class EditEditsDelete(TypedDict, total=False):
    tool: Literal["delete"]
    select: EditeditsdeleteSelect
    """the contours to remove; something must be said"""

class EditeditscopySelect(TypedDict, total=False):
    low_m: float | None
    """heights from here on [m, -12000 to 9000, derived if left out]"""
    high_m: float | None
    """heights up to here [m, -12000 to 9000, derived if left out]"""
    min_area_m2: float | None
    """enclosed areas from here on [m2, at least 0, derived if left out]"""
    max_area_m2: float | None
    """enclosed areas up to here [m2, at least 0, derived if left out]"""
    within: Sequence[Polygon]
    """those that lie wholly in one of these polygons"""
    at: Sequence[Point]
    """the contour nearest to each of these places"""
    index: Sequence[int]
    """these, by their number in the set, from 0 [at least 0]"""
    inner: bool
    """and everything that lies inside a contour so found [default False]"""

class EditEditsCopy(TypedDict, total=False):
    tool: Literal["copy"]
    within: Sequence[Polygon]
    """the outline: one polygon"""
    select: EditeditscopySelect
    """in place of it: one contour, with all that lies inside it"""

class EditeditscutSelect(TypedDict, total=False):
    low_m: float | None
    """heights from here on [m, -12000 to 9000, derived if left out]"""
    high_m: float | None
    """heights up to here [m, -12000 to 9000, derived if left out]"""
    min_area_m2: float | None
    """enclosed areas from here on [m2, at least 0, derived if left out]"""
    max_area_m2: float | None
    """enclosed areas up to here [m2, at least 0, derived if left out]"""
    within: Sequence[Polygon]
    """those that lie wholly in one of these polygons"""
    at: Sequence[Point]
    """the contour nearest to each of these places"""
    index: Sequence[int]
    """these, by their number in the set, from 0 [at least 0]"""
    inner: bool
    """and everything that lies inside a contour so found [default False]"""

class EditEditsCut(TypedDict, total=False):
    tool: Literal["cut"]
    within: Sequence[Polygon]
    """the outline: one polygon"""
    select: EditeditscutSelect
    """in place of it: one contour, with all that lies inside it"""

class EditEditsPaste(TypedDict, total=False):
    tool: Literal["paste"]
    file: Path
    """pattern to paste, as contour.pattern makes it; else what was copied, else the input"""
    at: Point | None
    """where the middle of the pattern comes to lie, in metres; the other ways to say it follow [derived if left out]"""
    on: Literal["middle", "highest"]
    """without a place: the middle of the domain, or within the highest contour [one of middle, highest, default middle]"""
    longitude_deg: float | None
    """with latitude_deg: where, on WGS 84; the contours must have a coordinate system [deg, -540 to 540, derived if left out]"""
    latitude_deg: float | None
    """with longitude_deg: where [deg, -90 to 90, derived if left out]"""
    rotation_deg: float
    """turn, counter-clockwise [deg, -360 to 360, default 0]"""
    scale: float
    """horizontal scale [0.001 to 1000, default 1]"""
    height_scale: float
    """vertical scale; below 0: hollows for hills [-1000 to 1000, default 1]"""
    raise_m: float
    """added to the pattern's heights [m, -9000 to 9000, default 0]"""
    blend_m: float | None
    """width of the ring in which the two grounds blend; two fifths of the way to the middle if derived [m, 0 to 1000000, derived if left out]"""

class EditeditsfillSelect(TypedDict, total=False):
    low_m: float | None
    """heights from here on [m, -12000 to 9000, derived if left out]"""
    high_m: float | None
    """heights up to here [m, -12000 to 9000, derived if left out]"""
    min_area_m2: float | None
    """enclosed areas from here on [m2, at least 0, derived if left out]"""
    max_area_m2: float | None
    """enclosed areas up to here [m2, at least 0, derived if left out]"""
    within: Sequence[Polygon]
    """those that lie wholly in one of these polygons"""
    at: Sequence[Point]
    """the contour nearest to each of these places"""
    index: Sequence[int]
    """these, by their number in the set, from 0 [at least 0]"""
    inner: bool
    """and everything that lies inside a contour so found [default False]"""

class EditEditsFill(TypedDict, total=False):
    tool: Literal["fill"]
    within: Sequence[Polygon]
    """the outline: one polygon"""
    select: EditeditsfillSelect
    """in place of it: one contour, whose inside is made anew"""
    files: Sequence[Path]
    """patterns to choose from for a polygon, as contour.pattern makes them; else these contours"""
    relief: float
    """range of heights over that of the surroundings [0 to 10, default 1]"""
    wavelength_m: float
    """size of the largest landforms [m, 1 to 1000000, default 1000]"""

class PatternSelect(TypedDict, total=False):
    low_m: float | None
    """heights from here on [m, -12000 to 9000, derived if left out]"""
    high_m: float | None
    """heights up to here [m, -12000 to 9000, derived if left out]"""
    min_area_m2: float | None
    """enclosed areas from here on [m2, at least 0, derived if left out]"""
    max_area_m2: float | None
    """enclosed areas up to here [m2, at least 0, derived if left out]"""
    within: Sequence[Polygon]
    """those that lie wholly in one of these polygons"""
    at: Sequence[Point]
    """the contour nearest to each of these places"""
    index: Sequence[int]
    """these, by their number in the set, from 0 [at least 0]"""
    inner: bool
    """and everything that lies inside a contour so found [default False]"""

def grow(
    regions: Drawing | Shapes | Path | Path | None = None,
    contours: Contours | Path | None = None,
    mask: Field | Array | Path | None = None,
    probability: Field | Array | Path | Literal["uniform", "noise"] | None = None,
    rivers: Drawing | Shapes | Path | Sequence[River] | None = None,
    *,
    outlines: Sequence[Region] = [],
    feature: str = '',
    layer: str = '',
    height_field: str = '',
    crs: str = '',
    darkest_is_land: bool = False,
    irregularity: float | None = None,
    spacing_m: float | None = None,
    particles: int = 50000,
    probability_picture: Path = '',
    feature_m: float | None = None,
    octaves: int = 5,
    exponent: float = 2,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Tin:
    """Grows nested regions into a network whose nodes know in which order they rise, without basins.
    
    Source: P2 sec. 4.2, 4.3, 4.5, Algorithm 1.
    
    Inputs
    ------
    regions : Drawing, optional
        nested areas or closed lines; a line's value is its height
    contours : Contours, optional
        contours whose insides are the regions
    mask : Field, optional
        a picture of nested regions, darker lower, laid over the domain
    probability : Field, optional
        in [0, 1]: where it is high growth runs ahead and cuts valleys
    rivers : Drawing, optional
        lines from source to mouth, with their beds and widths as numbers
    
    Parameters
    ----------
    outlines : regions
        nested regions, each with a name, a ring, the height of its outline if wanted, and whether it is a basin [m,
        -12000 to 9000]
    regions : file
        the regions instead as a GeoJSON, GeoPackage, Shapefile or SVG, or as a picture whose grey levels are nested
        regions
    feature : text
        only the areas of this name in the file `regions`
    layer : text
        layer of the file `regions`; empty: the first with areas or lines
    height_field : text
        field of the file `regions` with the heights of outlines; empty: one named like a height
    crs : text
        coordinate system of the file `regions` where it says none or a wrong one: EPSG:32627, or local for metres
    rivers : rivers
        rivers from source to mouth, each with its bed at all points, at source and mouth, at the mouth, or none, and the
        width of its valley floor
    darkest_is_land : switch
        the darkest grey of a picture is the lowest region instead of the world outside [default False]
    irregularity : number
        detail given to outlines drawn with few points: round corners, bays and headlands smaller than their sides; 0
        keeps every point; absent: 0.4 where `outlines` are given, else 0 [0 to 1, derived if left out]
    spacing_m : number
        least distance between nodes; absent: what gives `particles` [m, 0.001 to 1000000, derived if left out]
    particles : integer
        number of nodes in the regions, within a few per cent; more where regions are too small for so few [1 to 16000000,
        default 50000]
    probability : choice
        where growth runs ahead and cuts valleys: uniform: nowhere, rings that follow the outline; noise: along fractal
        noise; the input 'probability' replaces it [one of uniform, noise, default noise]
    probability_picture : file
        the probability as a picture laid over the domain, black 0 to white 1
    feature_m : number
        size of the noise's largest forms; absent: a third of the regions' size [m, 0.001 to 10000000, derived if left
        out]
    octaves : integer
        layers of detail of the noise, each of half the size [1 to 16, default 5]
    exponent : number
        power to which probabilities are raised: higher values carve narrower, deeper valleys [0.05 to 20, default 2]
    
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
    tin : Tin
        a network with a rank per node and no heights yet
    """
    ...

def heights(
    tin: Tin | Path,
    terrain: Terrain | Array | Path | None = None,
    *,
    landform: Literal["mountain", "uniform", "hills", "plateau", "coastal", "volcano", "canyon"] = 'mountain',
    histogram: Sequence[float] = [],
    density: Sequence[Point] = [],
    min_m: float | None = None,
    max_m: float | None = None,
    measure_above_m: float | None = None,
    summits: Literal["by_size", "equal"] = 'by_size',
    outlines: Literal["follow", "loose"] = 'follow',
    spikes: Literal["cut", "keep"] = 'cut',
    basin_depth_m: float | None = None,
    shore_slope_deg: float = 12,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Tin:
    """Heights for a grown network from a distribution of heights, through outlines of given height.
    
    Source: P2 sec. 3.3, 4.4, fig. 8, 23.
    
    Inputs
    ------
    tin : Tin
        a network as contour.grow makes it
    terrain : Terrain, optional
        measured for its distribution of heights
    
    Parameters
    ----------
    landform : choice
        distribution of heights that makes such a landform [one of mountain, uniform, hills, plateau, coastal, volcano,
        canyon, default mountain]
    histogram : numbers
        instead: how much ground lies at each height, in equal steps from lowest to highest [at least 0]
    density : curve
        instead: a drawn density of heights, x from 0 (lowest) to 1 (highest) [at least 0]
    min_m : number
        lowest height; derived: the terrain's, else the lowest outline's, else 0 [m, -12000 to 9000, derived if left out]
    max_m : number
        highest height; derived: the terrain's, else a twelfth of the land's width above the highest outline [m, -12000 to
        9000, derived if left out]
    measure_above_m : number
        measure only the terrain's cells from this height up; derived: all [m, -12000 to 9000, derived if left out]
    summits : choice
        by_size: wider ground rises higher; equal: every summit reaches the top [one of by_size, equal, default by_size]
    outlines : choice
        follow: contours at their heights follow the outlines; loose: as the growth is [one of follow, loose, default
        follow]
    spikes : choice
        cut: ground far steeper than the rest is cut back to a slope; keep: every height of the distribution stays where
        the growth has it [one of cut, keep, default cut]
    basin_depth_m : number
        depth of basins below their outlines; derived: half way down to the next outline, less in narrow ones [m, 0.01 to
        9000, derived if left out]
    shore_slope_deg : number
        how steeply the sea floor falls away from the coast, ever less below 1200 m [deg, 0.1 to 60, default 12]
    
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
    tin : Tin
        the same network with a height per node
    """
    ...

def refine(
    tin: Tin | Path | None = None,
    contours: Contours | Path | int | None = None,
    probability: Field | Array | Path | Literal["uniform", "noise"] | None = None,
    rivers: Drawing | Shapes | Path | Sequence[River] | None = None,
    *,
    passes: int = 2,
    spacing_m: float | None = None,
    roughness: float = 1,
    feature_m: Sequence[float] = [],
    exponent: Sequence[float] = [2],
    octaves: int = 5,
    shore_slope_deg: float = 12,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Tin:
    """Makes a network finer pass by pass, between its own contours, which keep their places and heights.
    
    Source: P2 sec. 6.6.
    
    One of the inputs is needed.
    
    Inputs
    ------
    tin : Tin, optional
        a network with heights
    contours : Contours, optional
        or nested closed contours
    probability : Field, optional
        in [0, 1]: where it is high growth runs ahead and cuts valleys
    rivers : Drawing, optional
        lines from source to mouth, with their beds and widths as numbers
    
    Parameters
    ----------
    passes : integer
        how often the spacing shrinks, by the same factor [1 to 6, default 2]
    spacing_m : number
        least distance between nodes at the end; absent: each pass halves it [m, 0.001 to 1000000, derived if left out]
    contours : integer
        heights whose contours the first pass holds, besides the given outlines; each further pass doubles them; 0: as
        many as lie five spacings apart. Many keep the coarse layout, few leave room for detail [0 to 200, default 0]
    roughness : number
        detail that contours of coarse triangles are given; 0: they are only smoothed [0 to 2, default 1]
    probability : choice
        where growth runs ahead and cuts valleys between the contours; the input 'probability' replaces it [one of
        uniform, noise, default noise]
    feature_m : numbers
        size of the noise's largest forms, one a pass, the last for all further ones; none: twelve times the spacing that
        the pass refines [m, 0.001 to 10000000]
    exponent : numbers
        power to which probabilities are raised, one a pass as well: higher values carve narrower valleys [0.05 to 20,
        default [2]]
    octaves : integer
        layers of detail of the noise, each of half the size [1 to 16, default 5]
    rivers : rivers
        the rivers that the network was grown with, laid into each pass again
    shore_slope_deg : number
        how steeply the sea floor falls away from the coast, ever less below 1200 m [deg, 0.1 to 60, default 12]
    
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
    tin : Tin
        a finer network with heights, whose regions are the contours that were held
    """
    ...

def edit(
    contours: Contours | Path,
    pattern: Drawing | Shapes | Path | None = None,
    *,
    edits: Sequence[EditEditsWarp | EditEditsSlope | EditEditsSmooth | EditEditsFractalize | EditEditsDelete | EditEditsCopy | EditEditsCut | EditEditsPaste | EditEditsFill] = [],
    on_crossing: Literal["limit", "refuse"] = 'limit',
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Contours:
    """Edits contours by a list of tools that can be replayed; they never come to cross.
    
    Source: P2 sec. 5 and 6.6.
    
    Inputs
    ------
    contours : Contours
        nested closed contours
    pattern : Drawing, optional
        pasted where nothing was copied and no file is named
    
    Parameters
    ----------
    edits : tools
        the tools, in the order of their use
        {"tool": "warp"}: drags contours along a stroke: ridges, valleys, spurs
          stroke : points
              points of the stroke, at least two; a spline runs through them
          radius_m : number
              radius of the disc that is dragged along the stroke [m, 0.1 to 1000000, default 500]
          strength : number
              1 carries what lies at the stroke's beginning to its end, 0 moves nothing [0 to 1, default 1]
          k : integer
              how narrow the drag is across the disc: (4x(1-x))^k [1 to 16, default 2]
          profile : curve
              drag across the disc from rim (0) to rim (1), in place of k: 0 at both, above 0 in the middle [0 to 1]
          step_m : number
              length of the steps of the drag; at most 0.5, 0.64, 0.58 radii for k = 1, 2, 3; half that if derived [m,
              0.001 to 1000000, derived if left out]
        {"tool": "slope"}: draws contours towards a curve or pushes them off: steeper, gentler
          stroke : points
              points of the curve; one alone works about a point
          radius_m : number
              reach on both sides of the curve [m, 0.1 to 1000000, default 500]
          strength : number
              above 0 steeper along the curve, below 0 gentler [-1 to 1, default 0.5]
          k : integer
              how narrow the ring is that gives way: (4x(1-x))^k [1 to 16, default 1]
        {"tool": "smooth"}: rounds contours off; closed loops keep their area
          select : group
              the contours to smooth; all unless said
              low_m : number
                  heights from here on [m, -12000 to 9000, derived if left out]
              high_m : number
                  heights up to here [m, -12000 to 9000, derived if left out]
              min_area_m2 : number
                  enclosed areas from here on [m2, at least 0, derived if left out]
              max_area_m2 : number
                  enclosed areas up to here [m2, at least 0, derived if left out]
              within : polygons
                  those that lie wholly in one of these polygons
              at : points
                  the contour nearest to each of these places
              index : integers
                  these, by their number in the set, from 0 [at least 0]
              inner : switch
                  and everything that lies inside a contour so found [default False]
          radius_m : number
              arc to either side that is averaged [m, 0.01 to 1000000, default 100]
          strength : number
              share of the way to the mean [0 to 1, default 1]
          rounds : integer
              how often [1 to 100, default 2]
        {"tool": "fractalize"}: roughens contours, neighbours alike, by one field of noise
          within : polygons
              where; everywhere unless said
          amplitude_m : number
              displacement by the longest wavelength [m, 0 to 100000, default 60]
          wavelength_m : number
              longest wavelength; each octave halves it [m, 1 to 1000000, default 800]
          octaves : integer
              how many wavelengths [1 to 12, default 5]
          gain : number
              displacement by an octave over that by the one before [0 to 1, default 0.5]
          fade_m : number
              over which it fades to nothing at the border [m, 0.1 to 1000000, default 300]
        {"tool": "delete"}: removes contours
          select : group
              the contours to remove; something must be said
              low_m : number
                  heights from here on [m, -12000 to 9000, derived if left out]
              high_m : number
                  heights up to here [m, -12000 to 9000, derived if left out]
              min_area_m2 : number
                  enclosed areas from here on [m2, at least 0, derived if left out]
              max_area_m2 : number
                  enclosed areas up to here [m2, at least 0, derived if left out]
              within : polygons
                  those that lie wholly in one of these polygons
              at : points
                  the contour nearest to each of these places
              index : integers
                  these, by their number in the set, from 0 [at least 0]
              inner : switch
                  and everything that lies inside a contour so found [default False]
        {"tool": "copy"}: takes the contours within an outline up for the next paste
          within : polygons
              the outline: one polygon
          select : group
              in place of it: one contour, with all that lies inside it
              low_m : number
                  heights from here on [m, -12000 to 9000, derived if left out]
              high_m : number
                  heights up to here [m, -12000 to 9000, derived if left out]
              min_area_m2 : number
                  enclosed areas from here on [m2, at least 0, derived if left out]
              max_area_m2 : number
                  enclosed areas up to here [m2, at least 0, derived if left out]
              within : polygons
                  those that lie wholly in one of these polygons
              at : points
                  the contour nearest to each of these places
              index : integers
                  these, by their number in the set, from 0 [at least 0]
              inner : switch
                  and everything that lies inside a contour so found [default False]
        {"tool": "cut"}: copies, then removes what lies inside and closes the ground over it
          within : polygons
              the outline: one polygon
          select : group
              in place of it: one contour, with all that lies inside it
              low_m : number
                  heights from here on [m, -12000 to 9000, derived if left out]
              high_m : number
                  heights up to here [m, -12000 to 9000, derived if left out]
              min_area_m2 : number
                  enclosed areas from here on [m2, at least 0, derived if left out]
              max_area_m2 : number
                  enclosed areas up to here [m2, at least 0, derived if left out]
              within : polygons
                  those that lie wholly in one of these polygons
              at : points
                  the contour nearest to each of these places
              index : integers
                  these, by their number in the set, from 0 [at least 0]
              inner : switch
                  and everything that lies inside a contour so found [default False]
        {"tool": "paste"}: lays a pattern over the contours and blends it in
          file : file
              pattern to paste, as contour.pattern makes it; else what was copied, else the input
          at : point
              where the middle of the pattern comes to lie, in metres; the other ways to say it follow [derived if left
              out]
          on : choice
              without a place: the middle of the domain, or within the highest contour [one of middle, highest, default
              middle]
          longitude_deg : number
              with latitude_deg: where, on WGS 84; the contours must have a coordinate system [deg, -540 to 540, derived
              if left out]
          latitude_deg : number
              with longitude_deg: where [deg, -90 to 90, derived if left out]
          rotation_deg : number
              turn, counter-clockwise [deg, -360 to 360, default 0]
          scale : number
              horizontal scale [0.001 to 1000, default 1]
          height_scale : number
              vertical scale; below 0: hollows for hills [-1000 to 1000, default 1]
          raise_m : number
              added to the pattern's heights [m, -9000 to 9000, default 0]
          blend_m : number
              width of the ring in which the two grounds blend; two fifths of the way to the middle if derived [m, 0 to
              1000000, derived if left out]
        {"tool": "fill"}: makes the inside of an outline anew, like its surroundings
          within : polygons
              the outline: one polygon
          select : group
              in place of it: one contour, whose inside is made anew
              low_m : number
                  heights from here on [m, -12000 to 9000, derived if left out]
              high_m : number
                  heights up to here [m, -12000 to 9000, derived if left out]
              min_area_m2 : number
                  enclosed areas from here on [m2, at least 0, derived if left out]
              max_area_m2 : number
                  enclosed areas up to here [m2, at least 0, derived if left out]
              within : polygons
                  those that lie wholly in one of these polygons
              at : points
                  the contour nearest to each of these places
              index : integers
                  these, by their number in the set, from 0 [at least 0]
              inner : switch
                  and everything that lies inside a contour so found [default False]
          files : files
              patterns to choose from for a polygon, as contour.pattern makes them; else these contours
          relief : number
              range of heights over that of the surroundings [0 to 10, default 1]
          wavelength_m : number
              size of the largest landforms [m, 1 to 1000000, default 1000]
    on_crossing : choice
        of an edit that would make contours cross: limit its strength and say so, or refuse it [one of limit, refuse,
        default limit]
    
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
    contours : Contours
        nested closed contours
    """
    ...

def pattern(
    contours: Contours | Path,
    *,
    within: Sequence[Polygon] = [],
    select: PatternSelect = {'at': [], 'high_m': None, 'index': [], 'inner': False, 'low_m': None, 'max_area_m2': None, 'min_area_m2': None, 'within': []},
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Drawing:
    """The contours within an outline as a small drawing, to be stored and pasted elsewhere.
    
    Source: P2 sec. 6.2.
    
    Inputs
    ------
    contours : Contours
        nested closed contours
    
    Parameters
    ----------
    within : polygons
        the outline: one polygon; the whole domain unless said
    select : group
        in place of it: one contour, with all that lies inside it
        low_m : number
            heights from here on [m, -12000 to 9000, derived if left out]
        high_m : number
            heights up to here [m, -12000 to 9000, derived if left out]
        min_area_m2 : number
            enclosed areas from here on [m2, at least 0, derived if left out]
        max_area_m2 : number
            enclosed areas up to here [m2, at least 0, derived if left out]
        within : polygons
            those that lie wholly in one of these polygons
        at : points
            the contour nearest to each of these places
        index : integers
            these, by their number in the set, from 0 [at least 0]
        inner : switch
            and everything that lies inside a contour so found [default False]
    
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
    pattern : Drawing
        the outline and the lines within it, heights above the outline's
    """
    ...

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
) -> Contours:
    """Contours from a file of lines with heights, open ones closed at the sheet's border.
    
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
    contours : Contours
        nested closed contours
    """
    ...

def extract(
    tin: Tin | Path | None = None,
    terrain: Terrain | Array | Path | None = None,
    *,
    levels_m: Sequence[float] = [],
    interval_m: float | None = None,
    base_m: float = 0,
    count: int = 20,
    simplify_m: float = 0,
    min_area_m2: float = 0,
    min_length_m: float = 0,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Contours:
    """The contours of a network or of a terrain, closed and nested.
    
    Source: P2 sec. 4.4.
    
    One of the inputs is needed.
    
    Inputs
    ------
    tin : Tin, optional
        a network with heights
    terrain : Terrain, optional
        or heights in metres
    
    Parameters
    ----------
    levels_m : numbers
        heights of the contours; none: see interval_m [m, -20000 to 20000]
    interval_m : number
        height between contours, counted from base_m; absent: see count [m, 0.001 to 20000, derived if left out]
    base_m : number
        a height that would have a contour [m, -20000 to 20000, default 0]
    count : integer
        number of heights, evenly over the range, where neither levels_m nor interval_m is given [1 to 1000, default 20]
    simplify_m : number
        points are dropped that lie no further than this from the rest; 0: all are kept [m, 0 to 100000, default 0]
    min_area_m2 : number
        smaller contours are left out, with all that they enclose [m2, 0 to 1e+12, default 0]
    min_length_m : number
        the same for shorter ones [m, 0 to 1000000000, default 0]
    
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
    contours : Contours
        nested closed contours
    """
    ...

def reconstruct(
    contours: Contours | Path | None = None,
    tin: Tin | Path | None = None,
    *,
    method: Literal["smooth", "interpolated", "stairs"] = 'smooth',
    cell_m: float | None = None,
    summits: float = 0.6,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Terrain:
    """A terrain from its contours or from a network, at any resolution.
    
    Source: P2 sec. 3.2.
    
    One of the inputs is needed.
    
    Inputs
    ------
    contours : Contours, optional
        nested closed contours
    tin : Tin, optional
        or a network with heights
    
    Parameters
    ----------
    method : choice
        smooth; interpolated: straight between the two nearest contours; stairs: level between contours. A network is
        interpolated in its triangles [one of smooth, interpolated, stairs, default smooth]
    cell_m : number
        cell size of the terrain; the document's if absent [m, 0.001 to 1000000, derived if left out]
    summits : number
        how far summits may rise over the last contour and basins sink under it; 1: almost to the next one [0.05 to 1,
        default 0.6]
    
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
