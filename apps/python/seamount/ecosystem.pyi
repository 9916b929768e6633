# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class GrowSurroundings(TypedDict, total=False):
    water_level_m: float
    """height of the water [m, -20000 to 20000, default 0]"""
    current_m_s: float
    """speed of the undisturbed current [m/s, 0 to 100, default 0.2]"""
    towards_deg: float
    """where it flows to: 0 east, 90 north [deg, -360 to 360, default 180]"""
    venturi_1_m: float
    """by how much a metre between ground and water level speeds it up (k_w of eq. 1.52) [1/m, 0 to 10, default 0]"""
    broad_m: float
    """deviation of the broad blur of the ground (eq. 1.53) [m, 0 to 1000000, default 200]"""
    broad_weight: float
    """its share [0 to 1, default 0.8]"""
    broad_deviation: float
    """how strongly it turns the current [0 to 10000, default 30]"""
    fine_m: float
    """deviation of the fine blur [m, 0 to 1000000, default 50]"""
    fine_weight: float
    """its share [0 to 1, default 0.2]"""
    fine_deviation: float
    """how strongly it turns the current [0 to 10000, default 5]"""
    shore_m: float
    """depth below which water slows down towards the shore [m, 0 to 1000, default 2]"""
    blend_m: float
    """how far two equal heights rise where they join: 1/(2k) of the smooth maximum [m, 0 to 1000, default 1]"""

class GrowTimelineWaterLevel(TypedDict, total=False):
    tool: Literal["water_level"]
    start: float
    """iteration at which it begins [at least 0, default 0]"""
    end: float
    """iteration at which it is over [at least 0, default 1]"""
    change_m: float
    """below 0: it falls [m, -20000 to 20000, default 0]"""

class GrowTimelineGround(TypedDict, total=False):
    tool: Literal["ground"]
    start: float
    """iteration at which it begins [at least 0, default 0]"""
    end: float
    """iteration at which it is over [at least 0, default 1]"""
    place: Point
    """of the strongest change [default [0, 0]]"""
    change_m: float
    """there; below 0 it sinks [m, -20000 to 20000, default 0]"""
    radius_m: float
    """deviation of the falloff [m, 0.001 to 10000000, default 1000]"""

class GrowTimelineStorm(TypedDict, total=False):
    tool: Literal["storm"]
    start: float
    """iteration at which it begins [at least 0, default 0]"""
    end: float
    """iteration from which it is over [at least 0, default 1]"""
    place: Point
    """its centre [default [0, 0]]"""
    speed_m_s: float
    """of the water that it drives, at the centre [m/s, 0 to 100, default 3]"""
    towards_deg: float
    """where to: 0 east, 90 north [deg, -360 to 360, default 0]"""
    radius_m: float
    """deviation of the falloff [m, 0.001 to 10000000, default 1000]"""

class GrowTimelineCurrent(TypedDict, total=False):
    tool: Literal["current"]
    start: float
    """iteration at which it begins [at least 0, default 0]"""
    end: float
    """iteration from which it is over [at least 0, default 1000000000]"""
    points: Sequence[Point]
    """a spline through at least two points, in its direction"""
    speed_m_s: float
    """on the stroke; below 0 against it [m/s, -100 to 100, default 1]"""
    width_m: float
    """deviation of the falloff across it [m, 0.001 to 10000000, default 100]"""

GrowEditsAdd = TypedDict("GrowEditsAdd", {"after": int, "class": str, "points": Sequence[Point], "locked": bool, "keep": bool, "size": float}, total=False)

GroweditsmoveObject = TypedDict("GroweditsmoveObject", {"id": int, "class": str, "near": Point}, total=False)

class GrowEditsMove(TypedDict, total=False):
    tool: Literal["move"]
    after: int
    """iteration after which it is done [at least 0, default 0]"""
    object: GroweditsmoveObject
    """which one"""
    by: Point
    """metres east and north [default [0, 0]]"""

GroweditsbendObject = TypedDict("GroweditsbendObject", {"id": int, "class": str, "near": Point}, total=False)

class GrowEditsBend(TypedDict, total=False):
    tool: Literal["bend"]
    after: int
    """iteration after which it is done [at least 0, default 0]"""
    object: GroweditsbendObject
    """which one"""
    at: Point
    """where the handle takes hold [default [0, 0]]"""
    by: Point
    """metres east and north [default [0, 0]]"""
    radius_m: float
    """how far it reaches [m, 0.001 to 10000000, default 100]"""
    handle: Literal["gaussian", "kelvinlet"]
    """falloff of the handle: gaussian or kelvinlet [one of gaussian, kelvinlet, default gaussian]"""
    lock: bool
    """points that moved by more than half of it stay there [default True]"""

GroweditsholdObject = TypedDict("GroweditsholdObject", {"id": int, "class": str, "near": Point}, total=False)

class GrowEditsHold(TypedDict, total=False):
    tool: Literal["hold"]
    after: int
    """iteration after which it is done [at least 0, default 0]"""
    object: GroweditsholdObject
    """which one"""
    at: Point
    """its points around this place [default [0, 0]]"""
    radius_m: float
    """so far from it [m, 0 to 1000000000, default 1000000]"""
    hold: float
    """0 free, 1 locked, hindered in between [0 to 1, default 1]"""

GroweditsdeleteObject = TypedDict("GroweditsdeleteObject", {"id": int, "class": str, "near": Point}, total=False)

class GrowEditsDelete(TypedDict, total=False):
    tool: Literal["delete"]
    after: int
    """iteration after which it is done [at least 0, default 0]"""
    object: GroweditsdeleteObject
    """which one"""

GrowTargets = TypedDict("GrowTargets", {"class": str, "count": int}, total=False)

class GrowWindow(TypedDict, total=False):
    cell_m: float
    """cell size of the window; 0: the whole scene grows [m, 0 to 100000, default 0]"""
    centre: Point
    """its middle [default [0, 0]]"""
    width_m: float
    """west to east [m, 0.001 to 10000000, default 100]"""
    height_m: float
    """south to north [m, 0.001 to 10000000, default 100]"""

class GrowResult(NamedTuple):
    objects: Objects
    terrain: Terrain
    current: Current

class HeightResult(NamedTuple):
    terrain: Terrain
    current: Current

class ScatterThing(TypedDict, total=False):
    shape: Literal["rock", "pebble", "arch", "branching_coral", "massive_coral", "table_coral", "foliose_coral", "sea_fan", "sponge", "palm", "broadleaf", "conifer", "shrub", "mangrove", "seagrass", "kelp", "file"]
    """what it looks like; file: a mesh of your own [one of rock, pebble, arch, branching_coral, massive_coral, table_coral, foliose_coral, sea_fan, sponge, palm, broadleaf, conifer, shrub, mangrove, seagrass, kelp, file, default rock]"""
    file: Path
    """shape file: a GLB or OBJ file in metres, y up, its foot at the origin"""
    height_m: float | None
    """height of a thing of size 1; by default what is usual for the shape, or what the file has [m, 0.005 to 500, derived if left out]"""
    width_m: float | None
    """width of a thing of size 1; by default in proportion to its height [m, 0.005 to 500, derived if left out]"""
    variants: int
    """different models of it [1 to 64, default 5]"""
    size_variation: float
    """deviation of the sizes around 1, as a share [0 to 0.6, default 0.2]"""
    lean: float | None
    """how far it stands along the ground's normal: 0 upright, 1 square to the slope; by default as the shape does [0 to 1, derived if left out]"""
    colour: str
    """its main colour; black: the shape's own [default #000000]"""

def grow(
    terrain: Terrain | Array | Path,
    catalogue: Catalogue | Mapping[str, Any] | Path | None = None,
    objects: Objects | Path | None = None,
    focus: Field | Array | Path | None = None,
    current: Current | Path | None = None,
    *,
    iterations: int = 30,
    surroundings: GrowSurroundings = {'blend_m': 1, 'broad_deviation': 30, 'broad_m': 200, 'broad_weight': 0.8, 'current_m_s': 0.2, 'fine_deviation': 5, 'fine_m': 50, 'fine_weight': 0.2, 'shore_m': 2, 'towards_deg': 180, 'venturi_1_m': 0, 'water_level_m': 0},
    timeline: Sequence[GrowTimelineWaterLevel | GrowTimelineGround | GrowTimelineStorm | GrowTimelineCurrent] = [],
    timeline_file: Path = '',
    edits: Sequence[GrowEditsAdd | GrowEditsMove | GrowEditsBend | GrowEditsHold | GrowEditsDelete] = [],
    edits_file: Path = '',
    targets: Sequence[GrowTargets] = [],
    classes: Sequence[str] = [],
    window: GrowWindow = {'cell_m': 0, 'centre': [0, 0], 'height_m': 100, 'width_m': 100},
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> GrowResult:
    """Environmental objects that live where they are fit and change their surroundings: islands, reefs, corals, trees,
    rocks.
    
    Source: P3 sec. 1.4-1.7, Algorithms 1, 2 and 4.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres: the ground before any object
    catalogue : Catalogue, optional
        what may grow; with objects, in place of theirs
    objects : Objects, optional
        a scene to go on with
    focus : Field, optional
        factor of the fitness of what is to be born: 0 nowhere, 1 as it is
    current : Current, optional
        m/s, added to what the terrain, events and objects make of the water
    
    Parameters
    ----------
    iterations : integer
        so many more; fewer once every target is reached [0 to 100000, default 30]
    surroundings : group
        the water; objects that are given keep their own
        water_level_m : number
            height of the water [m, -20000 to 20000, default 0]
        current_m_s : number
            speed of the undisturbed current [m/s, 0 to 100, default 0.2]
        towards_deg : number
            where it flows to: 0 east, 90 north [deg, -360 to 360, default 180]
        venturi_1_m : number
            by how much a metre between ground and water level speeds it up (k_w of eq. 1.52) [1/m, 0 to 10, default 0]
        broad_m : number
            deviation of the broad blur of the ground (eq. 1.53) [m, 0 to 1000000, default 200]
        broad_weight : number
            its share [0 to 1, default 0.8]
        broad_deviation : number
            how strongly it turns the current [0 to 10000, default 30]
        fine_m : number
            deviation of the fine blur [m, 0 to 1000000, default 50]
        fine_weight : number
            its share [0 to 1, default 0.2]
        fine_deviation : number
            how strongly it turns the current [0 to 10000, default 5]
        shore_m : number
            depth below which water slows down towards the shore [m, 0 to 1000, default 2]
        blend_m : number
            how far two equal heights rise where they join: 1/(2k) of the smooth maximum [m, 0 to 1000, default 1]
    timeline : tools
        events, beside those of objects that are given
        {"tool": "water_level"}: the sea rises or falls (eq. 1.56)
          start : number
              iteration at which it begins [at least 0, default 0]
          end : number
              iteration at which it is over [at least 0, default 1]
          change_m : number
              below 0: it falls [m, -20000 to 20000, default 0]
        {"tool": "ground"}: the ground sinks or rises around a place (eq. 1.57)
          start : number
              iteration at which it begins [at least 0, default 0]
          end : number
              iteration at which it is over [at least 0, default 1]
          place : point
              of the strongest change [default [0, 0]]
          change_m : number
              there; below 0 it sinks [m, -20000 to 20000, default 0]
          radius_m : number
              deviation of the falloff [m, 0.001 to 10000000, default 1000]
        {"tool": "storm"}: a storm drives the water around a place (sec. 1.7.2)
          start : number
              iteration at which it begins [at least 0, default 0]
          end : number
              iteration from which it is over [at least 0, default 1]
          place : point
              its centre [default [0, 0]]
          speed_m_s : number
              of the water that it drives, at the centre [m/s, 0 to 100, default 3]
          towards_deg : number
              where to: 0 east, 90 north [deg, -360 to 360, default 0]
          radius_m : number
              deviation of the falloff [m, 0.001 to 10000000, default 1000]
        {"tool": "current"}: a drawn current (sec. 1.7.1)
          start : number
              iteration at which it begins [at least 0, default 0]
          end : number
              iteration from which it is over [at least 0, default 1000000000]
          points : points
              a spline through at least two points, in its direction
          speed_m_s : number
              on the stroke; below 0 against it [m/s, -100 to 100, default 1]
          width_m : number
              deviation of the falloff across it [m, 0.001 to 10000000, default 100]
    timeline_file : file
        a JSON file with more of them
    edits : tools
        what is done to objects by hand
        {"tool": "add"}: a new object, also where nothing would grow
          after : integer
              iteration after which it is done [at least 0, default 0]
          class : text
              of the catalogue
          points : points
              its skeleton: one point, a curve, or the outline of a region
          locked : switch
              its points stay where they are [default True]
          keep : switch
              it lives whatever its fitness [default True]
          size : number
              times the size of its class [0.001 to 1000, default 1]
        {"tool": "move"}: an object elsewhere
          after : integer
              iteration after which it is done [at least 0, default 0]
          object : group
              which one
              id : integer
                  number of the object; 0: the nearest one [at least 0, default 0]
              class : text
                  its class; empty: any
              near : point
                  without a number: the object nearest to this place [default [0, 0]]
          by : point
              metres east and north [default [0, 0]]
        {"tool": "bend"}: a curve or an outline drawn along by a handle
          after : integer
              iteration after which it is done [at least 0, default 0]
          object : group
              which one
              id : integer
                  number of the object; 0: the nearest one [at least 0, default 0]
              class : text
                  its class; empty: any
              near : point
                  without a number: the object nearest to this place [default [0, 0]]
          at : point
              where the handle takes hold [default [0, 0]]
          by : point
              metres east and north [default [0, 0]]
          radius_m : number
              how far it reaches [m, 0.001 to 10000000, default 100]
          handle : choice
              falloff of the handle: gaussian or kelvinlet [one of gaussian, kelvinlet, default gaussian]
          lock : switch
              points that moved by more than half of it stay there [default True]
        {"tool": "hold"}: points of a skeleton locked, hindered or set free
          after : integer
              iteration after which it is done [at least 0, default 0]
          object : group
              which one
              id : integer
                  number of the object; 0: the nearest one [at least 0, default 0]
              class : text
                  its class; empty: any
              near : point
                  without a number: the object nearest to this place [default [0, 0]]
          at : point
              its points around this place [default [0, 0]]
          radius_m : number
              so far from it [m, 0 to 1000000000, default 1000000]
          hold : number
              0 free, 1 locked, hindered in between [0 to 1, default 1]
        {"tool": "delete"}: an object taken away
          after : integer
              iteration after which it is done [at least 0, default 0]
          object : group
              which one
              id : integer
                  number of the object; 0: the nearest one [at least 0, default 0]
              class : text
                  its class; empty: any
              near : point
                  without a number: the object nearest to this place [default [0, 0]]
    edits_file : file
        a JSON file with more of them
    targets : groups
        how many of a class are wanted; growth ends once all are there
        class : text
            of the catalogue
        count : integer
            so many are to live, and no more [0 to 10000000, default 1]
    classes : texts
        only these are born; empty: all of the catalogue
    window : group
        a finer frame to grow in
        cell_m : number
            cell size of the window; 0: the whole scene grows [m, 0 to 100000, default 0]
        centre : point
            its middle [default [0, 0]]
        width_m : number
            west to east [m, 0.001 to 10000000, default 100]
        height_m : number
            south to north [m, 0.001 to 10000000, default 100]
    
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
    objects : Objects
        points, curves and regions with their classes
    terrain : Terrain
        the ground with them, of the scene or of the window
    current : Current
        m/s, over that ground
    """
    ...

def height(
    terrain: Terrain | Array | Path,
    objects: Objects | Path,
    current: Current | Path | None = None,
    *,
    window: int = 0,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> HeightResult:
    """The ground with what objects and events make of it.
    
    Source: P3 sec. 1.6.2, eq. 1.46-1.49.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres: the ground that the objects grew on
    objects : Objects
        the objects
    current : Current, optional
        m/s, added to what the terrain, events and objects make of the water
    
    Parameters
    ----------
    window : integer
        of the scene: 0 its own frame, else a window, counted from 1 [at least 0, default 0]
    
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
        heights in metres, of the scene or of a window
    current : Current
        m/s, over that ground
    """
    ...

def field(
    terrain: Terrain | Array | Path,
    objects: Objects | Path,
    current: Current | Path | None = None,
    *,
    of: str = '',
    fitness_of: str = '',
    window: int = 0,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Field:
    """A material, the current, a distance, a fitness, any expression of a scene as a raster.
    
    Source: P3 sec. 1.5.1, 1.6.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres: the ground that the objects grew on
    objects : Objects
        the objects
    current : Current, optional
        m/s, added to what the terrain, events and objects make of the water
    
    Parameters
    ----------
    of : text
        an expression as in catalogues: a material, current, distance(reef), ...
    fitness_of : text
        a class instead: where it would be born, as its fitness says
    window : integer
        of the scene: 0 its own frame, else a window, counted from 1 [at least 0, default 0]
    
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
    field : Field
        the value of the expression, in its unit
    """
    ...

def labels(
    objects: Objects | Path,
    *,
    window: int = 0,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Labels:
    """The label map of a scene: mountain, beach, lagoon, reef, abyss.
    
    Source: P3 fig. 1.45.
    
    Inputs
    ------
    objects : Objects
        the objects
    
    Parameters
    ----------
    window : integer
        of the scene: 0 its own frame, else a window, counted from 1 [at least 0, default 0]
    
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
        regions as island.coral and learned islands read them
    """
    ...

def things(
    terrain: Terrain | Array | Path,
    objects: Objects | Path,
    surface: Terrain | Array | Path | None = None,
    *,
    window: int = 0,
    max_triangles: int = 0,
    keep_ground: bool = True,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Things:
    """What the objects look like: corals, trees and rocks, standing on the ground.
    
    Source: P3 sec. 1.4.3, fig. 1.18, 1.21.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres: the ground that the objects grew on
    objects : Objects
        the objects
    surface : Terrain, optional
        what they stand on instead: worn ground, say
    
    Parameters
    ----------
    window : integer
        0: all of the scene, with what grew in its windows; else what lies within that window [at least 0, default 0]
    max_triangles : integer
        of all together: things get coarser, then fewer; 0: no limit [0 to 1000000000, default 0]
    keep_ground : switch
        what they stand on goes with them into files [default True]
    
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
    things : Things
        models and where they stand
    """
    ...

def scatter(
    terrain: Terrain | Array | Path,
    density: Field | Array | Path | None = None,
    places: Drawing | Shapes | Path | None = None,
    others: Things | Path | None = None,
    *,
    thing: ScatterThing = {'colour': '#000000', 'file': '', 'height_m': None, 'lean': None, 'shape': 'rock', 'size_variation': 0.2, 'variants': 5, 'width_m': None},
    spacing_m: float = 50,
    min_height_m: float = -12000,
    max_height_m: float = 9000,
    max_slope_deg: float = 90,
    health: float = 1,
    max_triangles: int = 0,
    keep_ground: bool = True,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Things:
    """Spreads trees, corals, rocks or models of your own over a terrain, at drawn places or by a density.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    density : Field, optional
        share of the places that are taken, 0 to 1
    places : Drawing, optional
        points: one stands on each; or areas that they stand in
    others : Things, optional
        things that come along
    
    Parameters
    ----------
    thing : group
        what it is
        shape : choice
            what it looks like; file: a mesh of your own [one of rock, pebble, arch, branching_coral, massive_coral,
            table_coral, foliose_coral, sea_fan, sponge, palm, broadleaf, conifer, shrub, mangrove, seagrass, kelp, file,
            default rock]
        file : file
            shape file: a GLB or OBJ file in metres, y up, its foot at the origin
        height_m : number
            height of a thing of size 1; by default what is usual for the shape, or what the file has [m, 0.005 to 500,
            derived if left out]
        width_m : number
            width of a thing of size 1; by default in proportion to its height [m, 0.005 to 500, derived if left out]
        variants : integer
            different models of it [1 to 64, default 5]
        size_variation : number
            deviation of the sizes around 1, as a share [0 to 0.6, default 0.2]
        lean : number
            how far it stands along the ground's normal: 0 upright, 1 square to the slope; by default as the shape does [0
            to 1, derived if left out]
        colour : colour
            its main colour; black: the shape's own [default #000000]
    spacing_m : number
        least distance of two, without drawn places [m, 0.01 to 100000, default 50]
    min_height_m : number
        none on lower ground [m, -12000 to 9000, default -12000]
    max_height_m : number
        none on higher ground [m, -12000 to 9000, default 9000]
    max_slope_deg : number
        none on steeper ground [deg, 0 to 90, default 90]
    health : number
        1 is whole; ailing things are paler and have less of all [0 to 1, default 1]
    max_triangles : integer
        of all together: things get coarser, then fewer; 0: no limit [0 to 1000000000, default 0]
    keep_ground : switch
        what they stand on goes with them into files [default True]
    
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
    things : Things
        models and where they stand
    """
    ...
