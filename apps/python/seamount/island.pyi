# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class BuildSummits(TypedDict, total=False):
    place: Point
    """where it stands, on land [default [0, 0]]"""
    height_m: float | None
    """height of the summit; that of an island as wide as the land around it if absent [m, 1 to 9000, derived if left out]"""
    profile: Sequence[Point]
    """share of the summit's height over 0 (the summit) to 1 (foot of the mountains): a cone, a plateau, a crater; that of the island if empty [0 to 2]"""

class BuildWidths(TypedDict, total=False):
    beach_m: float | None
    """width of the beach, inside the coast; derived from the land's area if absent [m, 0.1 to 100000, derived if left out]"""
    lagoon_m: float | None
    """width of the lagoon; derived if absent [m, 0.1 to 1000000, derived if left out]"""
    reef_m: float | None
    """width of the reef; derived if absent [m, 0.1 to 1000000, derived if left out]"""
    slope_m: float | None
    """width of the slope down to the sea floor; derived if absent [m, 0.1 to 1000000, derived if left out]"""

class BuildDetail(TypedDict, total=False):
    coast_m: float | None
    """size of bays and headlands below what the plan shows; none on drawn coasts if absent [m, 0 to 100000, derived if left out]"""
    valley_spacing_m: float | None
    """distance between the largest valleys; derived if absent [m, 1 to 1000000, derived if left out]"""
    width_variation: float
    """how uneven beach, lagoon and reef are along the coast, wide in bays, narrow off headlands, where the plan is one coast [0 to 1, default 0.35]"""
    smoothing: float
    """how much creases between far parts of the outlines are softened [0 to 1, default 0.6]"""
    noise_m: float
    """height of the fine noise [m, 0 to 1000, default 3]"""
    noise_wavelength_m: float
    """size of the largest bumps of the fine noise [m, 0.1 to 1000000, default 600]"""

class BuildResult(NamedTuple):
    terrain: Terrain
    labels: Labels
    coordinate: Field

class WindResult(NamedTuple):
    terrain: Terrain
    labels: Labels
    coordinate: Field

class CoralSection(TypedDict, total=False):
    crest_m: float
    """height of the reef crest [m, -200 to 50, default -2]"""
    back_m: float
    """height of the back reef and of the lagoon's floor [m, -500 to 50, default -20]"""
    abyss_m: float
    """height at the foot of the fore reef [m, -5000 to 50, default -100]"""
    back_start: float
    """where the back reef starts across the reef (0: inner border, 1: outer border) [0 to 1, default 0]"""
    back_end: float
    """where the back reef ends and rises to the crest [0 to 1, default 0.5]"""
    crest_start: float
    """where the crest starts [0 to 1, default 0.75]"""
    crest_end: float
    """where the crest ends and the fore reef falls [0 to 1, default 0.8]"""
    abyss_start: float
    """where the fore reef reaches abyss_m [0 to 1, default 1]"""
    fore_reef_slope_deg: float
    """slope on which the fore reef goes on beyond the reef; 0: stays at abyss_m [deg, 0 to 80, default 28]"""

class CoralResult(NamedTuple):
    terrain: Terrain
    labels: Labels

class ArchipelagoResult(NamedTuple):
    terrain: Terrain
    labels: Labels

def build(
    outlines: Drawing | Shapes | Path | Sequence[Outline] | None = None,
    labels: Labels | Array | Path | None = None,
    summits: Drawing | Shapes | Path | Sequence[Mapping[str, Any]] | None = None,
    *,
    preset: Literal["hotspot", "high", "old"] | None = None,
    coast: Path = '',
    feature: str = '',
    layer: str = '',
    crs: str = '',
    areas: Sequence[Polygon] = [],
    centre: Point = [0, 0],
    irregularity: float = 0.35,
    peak_m: float | None = None,
    floor_m: float | None = None,
    massif: float = 0.5,
    relief: float = 1,
    profile: Sequence[Point] = [],
    interpolation: Literal["monotone_cubic", "linear"] = 'monotone_cubic',
    widths: BuildWidths = {'beach_m': None, 'lagoon_m': None, 'reef_m': None, 'slope_m': None},
    detail: BuildDetail = {'coast_m': None, 'noise_m': 3, 'noise_wavelength_m': 600, 'smoothing': 0.6, 'valley_spacing_m': None, 'width_variation': 0.35},
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> BuildResult:
    """An island from its outlines (drawn, polar, a real coastline, painted labels, or a random one) and its profile.
    
    Source: P0 sec. 1.4.1, eq. 1.1-1.2, 1.16.
    
    Inputs
    ------
    outlines : Drawing, optional
        areas named mountain, beach, lagoon, reef, abyss, or one coast
    labels : Labels, optional
        a label map to trace the outlines from
    summits : Drawing, optional
        points with their heights, besides the parameter's summits
    
    Parameters
    ----------
    preset : preset
        values that belong together, by a word; what is stated besides wins [one of hotspot, high, old, none if left out]
        "hotspot": a young shield of lava: smooth, round, with a narrow fringing reef
        "high": jagged peaks over deep valleys in green slopes, and a lagoon
        "old": the low rest of a sunken island in a wide shallow lagoon inside its reef
    coast : file
        coastline to build on: areas or closed lines in a GeoJSON, GeoPackage, Shapefile or SVG, or a painted label image
        (.png)
    feature : text
        name of the feature in the coast file; empty: all of them
    layer : text
        layer of the coast file; empty: the first with areas, else with lines
    crs : text
        coordinate system of the coast file where it says none or a wrong one: EPSG:32627, or local for metres
    outlines : outlines
        polar outlines around the centre: the coast alone, or mountain, beach, lagoon, reef, abyss [m, at least 0]
    areas : polygons
        drawn polygons of the coast
    centre : point
        centre of polar outlines and of random islands [default [0, 0]]
    irregularity : number
        how much the coast of a random island departs from a circle [0 to 1, default 0.35]
    peak_m : number
        height of the highest summit, to the metre; derived from the land's width if absent [m, 0 to 9000, derived if left
        out]
    floor_m : number
        height of the sea floor; derived if absent [m, -12000 to -1, derived if left out]
    summits : groups
        summits with their heights; lobes of the land without one have their own, as high as their width lets them be
        place : point
            where it stands, on land [default [0, 0]]
        height_m : number
            height of the summit; that of an island as wide as the land around it if absent [m, 1 to 9000, derived if left
            out]
        profile : curve
            share of the summit's height over 0 (the summit) to 1 (foot of the mountains): a cone, a plateau, a crater;
            that of the island if empty [0 to 2]
    massif : number
        how unevenly the mountains rise: 0 smooth cones, 1 several massifs [0 to 1, default 0.5]
    relief : number
        depth of the valleys that run down the slopes [0 to 2, default 1]
    profile : curve
        height over the region coordinate 0 (summit) to 5 (sea floor); derived from peak_m and floor_m if empty [m, -12000
        to 12000]
    interpolation : choice
        how the profile runs between its knots [one of monotone_cubic, linear, default monotone_cubic]
    widths : group
        widths of the regions around the mountains, where the plan is one coast
        beach_m : number
            width of the beach, inside the coast; derived from the land's area if absent [m, 0.1 to 100000, derived if
            left out]
        lagoon_m : number
            width of the lagoon; derived if absent [m, 0.1 to 1000000, derived if left out]
        reef_m : number
            width of the reef; derived if absent [m, 0.1 to 1000000, derived if left out]
        slope_m : number
            width of the slope down to the sea floor; derived if absent [m, 0.1 to 1000000, derived if left out]
    detail : group
        forms smaller than the plan and the profile say
        coast_m : number
            size of bays and headlands below what the plan shows; none on drawn coasts if absent [m, 0 to 100000, derived
            if left out]
        valley_spacing_m : number
            distance between the largest valleys; derived if absent [m, 1 to 1000000, derived if left out]
        width_variation : number
            how uneven beach, lagoon and reef are along the coast, wide in bays, narrow off headlands, where the plan is
            one coast [0 to 1, default 0.35]
        smoothing : number
            how much creases between far parts of the outlines are softened [0 to 1, default 0.6]
        noise_m : number
            height of the fine noise [m, 0 to 1000, default 3]
        noise_wavelength_m : number
            size of the largest bumps of the fine noise [m, 0.1 to 1000000, default 600]
    
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
    labels : Labels
        its regions
    coordinate : Field
        region coordinate: 0 at the summit, i on outline i, 5 on the sea floor
    """
    ...

def wind(
    terrain: Terrain | Array | Path,
    labels: Labels | Array | Path | None = None,
    coordinate: Field | Array | Path | None = None,
    *,
    strokes: Sequence[Stroke] = [],
    resistance: Sequence[Point] = [[0, 0.85], [0.7, 0.7], [1, 0.35], [2, 0.05], [3, 0.15], [4, 0.4], [5, 1]],
    radial_count: int = 0,
    radial_width_m: float = 400,
    radial_strength_m: float = 350,
    centre: Point = [0, 0],
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> WindResult:
    """Pushes an island out of its symmetry along strokes of wind and waves, terrain and labels together.
    
    Source: P0 sec. 1.4.1, eq. 1.3-1.7, fig. 1.38.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    labels : Labels, optional
        regions, which move along
    coordinate : Field, optional
        region coordinate, as island.build makes it; derived from the labels if absent
    
    Parameters
    ----------
    strokes : strokes
        strokes of wind: points, width_m (deviation of the falloff), strength_m (displacement on the stroke)
    resistance : curve
        share of the displacement that is withheld, over the region coordinate 0 (summit) to 5 (sea floor) [0 to 1,
        default [[0, 0.85], [0.7, 0.7], [1, 0.35], [2, 0.05], [3, 0.15], [4, 0.4], [5, 1]]]
    radial_count : integer
        radial strokes from the centre outwards, landward and seaward in turn [0 to 1000, default 0]
    radial_width_m : number
        width of the radial strokes [m, 0.1 to 100000, default 400]
    radial_strength_m : number
        displacement on the radial strokes [m, 0 to 100000, default 350]
    centre : point
        centre of the radial strokes [default [0, 0]]
    
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
    labels : Labels
        its regions; all mountain if no labels were given
    coordinate : Field
        region coordinate; 0 everywhere if neither it nor labels were given
    """
    ...

def coral(
    terrain: Terrain | Array | Path,
    labels: Labels | Array | Path,
    coordinate: Field | Array | Path | None = None,
    *,
    subsidence: float = 0,
    swell_from_deg: float = 130,
    exposure: float = 0.5,
    passes: int = -1,
    pass_width_m: float = 350,
    pass_depth_m: float = 18,
    lagoon_relief_m: float = 5,
    islets: float = 0.3,
    islet_m: float = 3,
    blend_m: float = 1,
    floor_m: float | None = None,
    relabel: bool = True,
    section: CoralSection = {'abyss_m': -100, 'abyss_start': 1, 'back_end': 0.5, 'back_m': -20, 'back_start': 0, 'crest_end': 0.8, 'crest_m': -2, 'crest_start': 0.75, 'fore_reef_slope_deg': 28},
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> CoralResult:
    """Sinks an island and grows its reef: fringing reef, barrier reef, atoll.
    
    Source: P0 sec. 1.4.2, eq. 1.8-1.15.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    labels : Labels
        its regions
    coordinate : Field, optional
        region coordinate, as island.build makes it; derived from the labels if absent
    
    Parameters
    ----------
    subsidence : number
        share of its height over the sea floor by which the island has sunk [0 to 1, default 0]
    swell_from_deg : number
        bearing from which the swell comes [deg, -360 to 360, default 130]
    exposure : number
        how much the reef differs to windward, narrow, high and with long islets, and to leeward [0 to 1, default 0.5]
    passes : integer
        channels through the reef, the first off the largest rivers; -1: one for 16 km of reef, at least two [-1 to 200,
        default -1]
    pass_width_m : number
        width of a pass [m, 1 to 100000, default 350]
    pass_depth_m : number
        depth of a pass [m, 0 to 500, default 18]
    lagoon_relief_m : number
        height of patch reefs and hollows on the lagoon's floor [m, 0 to 100, default 5]
    islets : number
        share of the reef that carries islets of sand [0 to 1, default 0.3]
    islet_m : number
        height of the islets [m, 0 to 20, default 3]
    blend_m : number
        how much the smooth maximum of island and reef exceeds both where they are equal [m, 0.001 to 100, default 1]
    floor_m : number
        height that does not sink; the lowest of the terrain if absent [m, -12000 to 9000, derived if left out]
    relabel : switch
        label what has sunk below the sea and the deep back reef as lagoon, and beaches along the new coast [default True]
    section : group
        heights across the reef
        crest_m : number
            height of the reef crest [m, -200 to 50, default -2]
        back_m : number
            height of the back reef and of the lagoon's floor [m, -500 to 50, default -20]
        abyss_m : number
            height at the foot of the fore reef [m, -5000 to 50, default -100]
        back_start : number
            where the back reef starts across the reef (0: inner border, 1: outer border) [0 to 1, default 0]
        back_end : number
            where the back reef ends and rises to the crest [0 to 1, default 0.5]
        crest_start : number
            where the crest starts [0 to 1, default 0.75]
        crest_end : number
            where the crest ends and the fore reef falls [0 to 1, default 0.8]
        abyss_start : number
            where the fore reef reaches abyss_m [0 to 1, default 1]
        fore_reef_slope_deg : number
            slope on which the fore reef goes on beyond the reef; 0: stays at abyss_m [deg, 0 to 80, default 28]
    
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
    labels : Labels
        its regions
    """
    ...

def archipelago(
    terrain: Terrain | Array | Path,
    labels: Labels | Array | Path | None = None,
    terrain_2: Terrain | Array | Path | None = None,
    labels_2: Labels | Array | Path | None = None,
    terrain_3: Terrain | Array | Path | None = None,
    labels_3: Labels | Array | Path | None = None,
    terrain_4: Terrain | Array | Path | None = None,
    labels_4: Labels | Array | Path | None = None,
    terrain_5: Terrain | Array | Path | None = None,
    labels_5: Labels | Array | Path | None = None,
    terrain_6: Terrain | Array | Path | None = None,
    labels_6: Labels | Array | Path | None = None,
    terrain_7: Terrain | Array | Path | None = None,
    labels_7: Labels | Array | Path | None = None,
    terrain_8: Terrain | Array | Path | None = None,
    labels_8: Labels | Array | Path | None = None,
    *,
    places: Sequence[Point] = [],
    turns_deg: Sequence[float] = [],
    scales: Sequence[float] = [],
    blend_m: float = 1,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> ArchipelagoResult:
    """Several islands, or copies of one, in one sea.
    
    Source: P0 sec. 1.5.1, eq. 1.15.
    
    Inputs
    ------
    terrain : Terrain
        an island
    labels : Labels, optional
        its regions
    terrain_2 : Terrain, optional
        another island
    labels_2 : Labels, optional
        its regions
    terrain_3 : Terrain, optional
        another island
    labels_3 : Labels, optional
        its regions
    terrain_4 : Terrain, optional
        another island
    labels_4 : Labels, optional
        its regions
    terrain_5 : Terrain, optional
        another island
    labels_5 : Labels, optional
        its regions
    terrain_6 : Terrain, optional
        another island
    labels_6 : Labels, optional
        its regions
    terrain_7 : Terrain, optional
        another island
    labels_7 : Labels, optional
        its regions
    terrain_8 : Terrain, optional
        another island
    labels_8 : Labels, optional
        its regions
    
    Parameters
    ----------
    places : points
        where each island's centre goes; a single island is copied to every place; none: islands stay where they are
    turns_deg : numbers
        how far each island is turned, counter-clockwise; missing ones are 0 [deg, -360 to 360]
    scales : numbers
        how much each island is scaled, width and height of its land alike; reefs keep their depths; missing ones are 1
        [0.05 to 5]
    blend_m : number
        how much the smooth maximum exceeds two islands where they are equal [m, 0.001 to 100, default 1]
    
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
    labels : Labels
        its regions; all abyss unless every island has labels
    """
    ...

def outlines(
    labels: Labels | Array | Path,
    *,
    tolerance_m: float = 0,
    min_area_m2: float = 0,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Drawing:
    """Traces the outlines of a label map, as island.build reads them.
    
    Source: P0 sec. 1.4.1, fig. 1.23.
    
    Inputs
    ------
    labels : Labels
        its regions
    
    Parameters
    ----------
    tolerance_m : number
        how far simplified outlines may lie from the traced ones; 0: one quarter cell [m, 0 to 100000, default 0]
    min_area_m2 : number
        parts and holes smaller than this are left out [m2, 0 to 1e+12, default 0]
    
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
    outlines : Drawing
        nested areas named mountain, beach, lagoon, reef
    """
    ...
