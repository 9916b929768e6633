# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class MapLayers(TypedDict, total=False):
    low_m: float | None
    """height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as the style asks [m, -12000 to 9000, derived if left out]"""
    low_error_m: float | None
    """height above low_m over which the low layer fades; by default 0.1 of the relief [m, 0 to 20000, derived if left out]"""
    high_m: float | None
    """height from which the high layer takes over; by default 0.5 of the relief [m, -12000 to 9000, derived if left out]"""
    high_error_m: float | None
    """height below high_m over which the high layer fades in; by default 0.05 of the relief [m, 0 to 20000, derived if left out]"""
    smooth: bool
    """layers fade in and out softly; off: linearly, as in the paper [default True]"""
    variation: float
    """how far borders stray from one height, by noise and on steep ground, which is more of the middle layer [0 to 1, default 0.5]"""

class PerspectiveCamera(TypedDict, total=False):
    view: Literal["aerial", "hero", "canyon", "turntable"]
    """aerial: from above, so that all fits; hero: low, against the sky; canyon: from within the deepest valley; turntable: around all land, at the same distance from every side [one of aerial, hero, canyon, turntable, default aerial]"""
    azimuth_deg: float | None
    """bearing of the camera from the target, clockwise from north; 205 by default, in a canyon along the valley [deg, -360 to 360, derived if left out]"""
    elevation_deg: float | None
    """height of the camera above the horizon as seen from the target; by default 25, hero 7, turntable 30 [deg, -60 to 89, derived if left out]"""
    distance: float
    """distance from the target over that at which all just fits: 0.5 is half as far [0.02 to 10, default 1]"""
    target_x_m: float | None
    """where to look, east; by default the middle of the largest land or reef and what is near [m, derived if left out]"""
    target_y_m: float | None
    """where to look, north; by default the same [m, derived if left out]"""
    distance_m: float | None
    """metres from the target, which is then a place on the ground; under water the camera stays there; by default distance counts [m, 0.05 to 1000000, derived if left out]"""
    target_height_m: float
    """with distance_m or x_m: height of the target over the ground [m, -100 to 9000, default 0]"""
    x_m: float | None
    """where the camera stands, east; with y_m, instead of a distance [m, derived if left out]"""
    y_m: float | None
    """where the camera stands, north [m, derived if left out]"""
    height_m: float
    """with x_m and y_m: height of the camera over ground or water [m, 0.1 to 50000, default 20]"""
    field_of_view_deg: float | None
    """angle of view from top to bottom; by default 35, hero 28, canyon 60 [deg, 5 to 100, derived if left out]"""

class PerspectiveSun(TypedDict, total=False):
    light: Literal["afternoon", "morning", "noon", "evening"]
    """time of the day; azimuth_deg and elevation_deg overrule it [one of afternoon, morning, noon, evening, default afternoon]"""
    azimuth_deg: float | None
    """bearing of the sun, clockwise from north; afternoon 285, morning 80, evening 275, noon towards the equator [deg, -360 to 360, derived if left out]"""
    elevation_deg: float | None
    """height of the sun over the horizon; afternoon 30, morning 14, noon 65, evening 6 [deg, 2 to 89, derived if left out]"""

class PerspectiveClimate(TypedDict, total=False):
    preset: Literal["tropical", "temperate", "arid", "polar"] | None
    """values that belong together, by a word; what is stated besides wins [one of tropical, temperate, arid, polar, none if left out]"""
    latitude_deg: float | None
    """latitude, which decides how warm it is; by default that of the terrain's place if it has one, else -18 in a sea and 45 inland [deg, -90 to 90, derived if left out]"""
    rain_mm_yr: float | None
    """rain in a year, mean over the land; below 250 a desert; by default as usual for the latitude [mm/yr, 0 to 15000, derived if left out]"""
    wind_from_deg: float | None
    """bearing that the wind brings rain from: windward slopes are wet, leeward ones dry; by default trade winds or westerlies by the latitude [deg, -360 to 360, derived if left out]"""

class PerspectiveLayers(TypedDict, total=False):
    low_m: float | None
    """height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as the style asks [m, -12000 to 9000, derived if left out]"""
    low_error_m: float | None
    """height above low_m over which the low layer fades; by default 0.1 of the relief [m, 0 to 20000, derived if left out]"""
    high_m: float | None
    """height from which the high layer takes over; by default 0.5 of the relief [m, -12000 to 9000, derived if left out]"""
    high_error_m: float | None
    """height below high_m over which the high layer fades in; by default 0.05 of the relief [m, 0 to 20000, derived if left out]"""
    smooth: bool
    """layers fade in and out softly; off: linearly, as in the paper [default True]"""
    variation: float
    """how far borders stray from one height, by noise and on steep ground, which is more of the middle layer [0 to 1, default 0.5]"""

class TextureClimate(TypedDict, total=False):
    preset: Literal["tropical", "temperate", "arid", "polar"] | None
    """values that belong together, by a word; what is stated besides wins [one of tropical, temperate, arid, polar, none if left out]"""
    latitude_deg: float | None
    """latitude, which decides how warm it is; by default that of the terrain's place if it has one, else -18 in a sea and 45 inland [deg, -90 to 90, derived if left out]"""
    rain_mm_yr: float | None
    """rain in a year, mean over the land; below 250 a desert; by default as usual for the latitude [mm/yr, 0 to 15000, derived if left out]"""
    wind_from_deg: float | None
    """bearing that the wind brings rain from: windward slopes are wet, leeward ones dry; by default trade winds or westerlies by the latitude [deg, -360 to 360, derived if left out]"""

class TextureLayers(TypedDict, total=False):
    low_m: float | None
    """height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as the style asks [m, -12000 to 9000, derived if left out]"""
    low_error_m: float | None
    """height above low_m over which the low layer fades; by default 0.1 of the relief [m, 0 to 20000, derived if left out]"""
    high_m: float | None
    """height from which the high layer takes over; by default 0.5 of the relief [m, -12000 to 9000, derived if left out]"""
    high_error_m: float | None
    """height below high_m over which the high layer fades in; by default 0.05 of the relief [m, 0 to 20000, derived if left out]"""
    smooth: bool
    """layers fade in and out softly; off: linearly, as in the paper [default True]"""
    variation: float
    """how far borders stray from one height, by noise and on steep ground, which is more of the middle layer [0 to 1, default 0.5]"""

class LayersLayers(TypedDict, total=False):
    low_m: float | None
    """height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as the style asks [m, -12000 to 9000, derived if left out]"""
    low_error_m: float | None
    """height above low_m over which the low layer fades; by default 0.1 of the relief [m, 0 to 20000, derived if left out]"""
    high_m: float | None
    """height from which the high layer takes over; by default 0.5 of the relief [m, -12000 to 9000, derived if left out]"""
    high_error_m: float | None
    """height below high_m over which the high layer fades in; by default 0.05 of the relief [m, 0 to 20000, derived if left out]"""
    smooth: bool
    """layers fade in and out softly; off: linearly, as in the paper [default True]"""
    variation: float
    """how far borders stray from one height, by noise and on steep ground, which is more of the middle layer [0 to 1, default 0.5]"""

class LayersResult(NamedTuple):
    low: Field
    middle: Field
    high: Field

def map(
    terrain: Terrain | Array | Path,
    labels: Labels | Array | Path | None = None,
    lakes: Drawing | Shapes | Path | None = None,
    rivers: Drawing | Shapes | Path | None = None,
    ridges: Drawing | Shapes | Path | None = None,
    peaks: Drawing | Shapes | Path | None = None,
    current: Current | Path | None = None,
    objects: Objects | Path | None = None,
    lake: Field | Array | Path | None = None,
    *,
    width_px: int = 1600,
    title: str = '',
    theme: Literal["height", "regions"] = 'height',
    style: Literal["natural", "great_barrier_reef", "stone", "desert", "volcano"] = 'natural',
    layers: MapLayers = {'high_error_m': None, 'high_m': None, 'low_error_m': None, 'low_m': None, 'smooth': True, 'variation': 0.5},
    shading: float = 1,
    contours: bool = True,
    contour_interval_m: float | None = None,
    coast: bool = True,
    reef_crest: bool = True,
    legend: bool = True,
    scale_bar: bool = True,
    north_arrow: bool = True,
    arrow_spacing_px: float | None = None,
    object_legend: bool = True,
    min_sea_m2: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Image:
    """A map with tints by height and depth, relief, contours, legend and scale bar; rivers, lakes, ridges, peaks, currents
    and objects over it.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    labels : Labels, optional
        its regions: where beach, lagoon and reef are
    lakes : Drawing, optional
        areas to fill as water
    rivers : Drawing, optional
        lines of water, as wide as their order
    ridges : Drawing, optional
        lines of ridges
    peaks : Drawing, optional
        points with heights
    current : Current, optional
        a flow to draw as arrows as long as it is fast
    objects : Objects, optional
        regions, curves and points, in their classes' colours
    lake : Field, optional
        metres of standing water over it, as hydrology.lakes gives them
    
    Parameters
    ----------
    width_px : integer
        width of the picture in pixels [16 to 16384, default 1600]
    title : text
        text over the map; none if empty
    theme : choice
        what the colours show: heights and depths, or the regions of a label map [one of height, regions, default height]
    style : choice
        heights: natural tints by height, or three layers by height in a style (the reef's of the sea floor, the others of
        the land) [one of natural, great_barrier_reef, stone, desert, volcano, default natural]
    layers : group
        borders of the style's layers
        low_m : number
            height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as
            the style asks [m, -12000 to 9000, derived if left out]
        low_error_m : number
            height above low_m over which the low layer fades; by default 0.1 of the relief [m, 0 to 20000, derived if
            left out]
        high_m : number
            height from which the high layer takes over; by default 0.5 of the relief [m, -12000 to 9000, derived if left
            out]
        high_error_m : number
            height below high_m over which the high layer fades in; by default 0.05 of the relief [m, 0 to 20000, derived
            if left out]
        smooth : switch
            layers fade in and out softly; off: linearly, as in the paper [default True]
        variation : number
            how far borders stray from one height, by noise and on steep ground, which is more of the middle layer [0 to
            1, default 0.5]
    shading : number
        strength of the relief shading [0 to 1, default 1]
    contours : switch
        draw contour lines [default True]
    contour_interval_m : number
        height between contours; by default a round number for about twenty [m, 0.01 to 10000, derived if left out]
    coast : switch
        draw the coast line [default True]
    reef_crest : switch
        draw the outer edge of the reef; needs labels [default True]
    legend : switch
        explain the colours at the right [default True]
    scale_bar : switch
        show lengths below the map [default True]
    north_arrow : switch
        show where north is [default True]
    arrow_spacing_px : number
        distance between the arrows of a current, and the length of the longest; by default forty across [px, 6 to 1000,
        derived if left out]
    object_legend : switch
        explain the objects in a box below the map: each class with objects on it, and how many [default True]
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
        the picture
    """
    ...

def relief(
    terrain: Terrain | Array | Path,
    *,
    width_px: int = 1600,
    tint: Literal["grey", "height"] = 'grey',
    light_azimuth_deg: float = 315,
    light_elevation_deg: float = 45,
    ambient: float = 0.6,
    vertical_exaggeration: float | None = None,
    min_sea_m2: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Image:
    """Shaded relief with light from several directions.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    width_px : integer
        width of the picture in pixels [16 to 16384, default 1600]
    tint : choice
        colour of the ground: grey, or by height and depth [one of grey, height, default grey]
    light_azimuth_deg : number
        bearing of the main light, clockwise from north [deg, -360 to 360, default 315]
    light_elevation_deg : number
        height of the lights [deg, 10 to 80, default 45]
    ambient : number
        how much valleys that see little sky are darkened [0 to 1, default 0.6]
    vertical_exaggeration : number
        heights are shaded times this; by default so that steep ground of this terrain looks steep [0.01 to 100, derived
        if left out]
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
        the picture
    """
    ...

def perspective(
    terrain: Terrain | Array | Path,
    labels: Labels | Array | Path | None = None,
    things: Things | Path | None = None,
    lake: Field | Array | Path | None = None,
    rivers: Drawing | Shapes | Path | None = None,
    *,
    width_px: int = 1280,
    height_px: int = 720,
    camera: PerspectiveCamera = {'azimuth_deg': None, 'distance': 1, 'distance_m': None, 'elevation_deg': None, 'field_of_view_deg': None, 'height_m': 20, 'target_height_m': 0, 'target_x_m': None, 'target_y_m': None, 'view': 'aerial', 'x_m': None, 'y_m': None},
    sun: PerspectiveSun = {'azimuth_deg': None, 'elevation_deg': None, 'light': 'afternoon'},
    vertical_exaggeration: float = 1,
    haze: float = 1,
    exposure: float = 1,
    water: bool = True,
    water_level_m: float = 0,
    water_clarity: float = 1,
    surround: Literal["automatic", "sea", "block"] = 'automatic',
    climate: PerspectiveClimate = {'latitude_deg': None, 'rain_mm_yr': None, 'wind_from_deg': None},
    tree_line_m: float | None = None,
    snow_line_m: float | None = None,
    rock: Literal["automatic", "granite", "basalt", "limestone", "sandstone"] = 'automatic',
    style: Literal["natural", "great_barrier_reef", "stone", "desert", "volcano"] = 'natural',
    layers: PerspectiveLayers = {'high_error_m': None, 'high_m': None, 'low_error_m': None, 'low_m': None, 'smooth': True, 'variation': 0.5},
    min_sea_m2: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Image:
    """A picture from a point of view, with sun, shadows, sky and water.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    labels : Labels, optional
        its regions: where beach, lagoon and reef are
    things : Things, optional
        what stands on it, drawn from its models
    lake : Field, optional
        metres of standing water over it, as hydrology.lakes gives them
    rivers : Drawing, optional
        lines of running water, as wide as they say
    
    Parameters
    ----------
    width_px : integer
        width of the picture in pixels [16 to 8192, default 1280]
    height_px : integer
        height of the picture in pixels [16 to 8192, default 720]
    camera : group
        from where to look
        view : choice
            aerial: from above, so that all fits; hero: low, against the sky; canyon: from within the deepest valley;
            turntable: around all land, at the same distance from every side [one of aerial, hero, canyon, turntable,
            default aerial]
        azimuth_deg : number
            bearing of the camera from the target, clockwise from north; 205 by default, in a canyon along the valley
            [deg, -360 to 360, derived if left out]
        elevation_deg : number
            height of the camera above the horizon as seen from the target; by default 25, hero 7, turntable 30 [deg, -60
            to 89, derived if left out]
        distance : number
            distance from the target over that at which all just fits: 0.5 is half as far [0.02 to 10, default 1]
        target_x_m : number
            where to look, east; by default the middle of the largest land or reef and what is near [m, derived if left
            out]
        target_y_m : number
            where to look, north; by default the same [m, derived if left out]
        distance_m : number
            metres from the target, which is then a place on the ground; under water the camera stays there; by default
            distance counts [m, 0.05 to 1000000, derived if left out]
        target_height_m : number
            with distance_m or x_m: height of the target over the ground [m, -100 to 9000, default 0]
        x_m : number
            where the camera stands, east; with y_m, instead of a distance [m, derived if left out]
        y_m : number
            where the camera stands, north [m, derived if left out]
        height_m : number
            with x_m and y_m: height of the camera over ground or water [m, 0.1 to 50000, default 20]
        field_of_view_deg : number
            angle of view from top to bottom; by default 35, hero 28, canyon 60 [deg, 5 to 100, derived if left out]
    sun : group
        where the light comes from
        light : choice
            time of the day; azimuth_deg and elevation_deg overrule it [one of afternoon, morning, noon, evening, default
            afternoon]
        azimuth_deg : number
            bearing of the sun, clockwise from north; afternoon 285, morning 80, evening 275, noon towards the equator
            [deg, -360 to 360, derived if left out]
        elevation_deg : number
            height of the sun over the horizon; afternoon 30, morning 14, noon 65, evening 6 [deg, 2 to 89, derived if
            left out]
    vertical_exaggeration : number
        heights are drawn times this [0.1 to 20, default 1]
    haze : number
        haze with distance; 0 is clear [0 to 5, default 1]
    exposure : number
        brightness of the picture [0.1 to 10, default 1]
    water : switch
        fill the ground below the water level [default True]
    water_level_m : number
        height of the water's surface [m, -12000 to 9000, default 0]
    water_clarity : number
        how far one sees in water, 1 in clear tropical water [0.05 to 5, default 1]
    surround : choice
        what lies around the terrain [one of automatic, sea, block, default automatic]
    climate : group
        what grows on the land, in the natural style
        preset : preset
            values that belong together, by a word; what is stated besides wins [one of tropical, temperate, arid, polar,
            none if left out]
            "tropical": rain forest up to the clouds
            "temperate": meadows and woods, bare rock above, snow on high mountains
            "arid": bare rock and sand, hardly any green
            "polar": tundra along the coast under ice and snow
        latitude_deg : number
            latitude, which decides how warm it is; by default that of the terrain's place if it has one, else -18 in a
            sea and 45 inland [deg, -90 to 90, derived if left out]
        rain_mm_yr : number
            rain in a year, mean over the land; below 250 a desert; by default as usual for the latitude [mm/yr, 0 to
            15000, derived if left out]
        wind_from_deg : number
            bearing that the wind brings rain from: windward slopes are wet, leeward ones dry; by default trade winds or
            westerlies by the latitude [deg, -360 to 360, derived if left out]
    tree_line_m : number
        height over the water where forest ends; by default as usual for the latitude [m, 1 to 9000, derived if left out]
    snow_line_m : number
        height over the water where snow stays; by default as usual for the latitude [m, -1000 to 20000, derived if left
        out]
    rock : choice
        bare rock in the natural style; automatic is basalt in a warm sea, else granite [one of automatic, granite,
        basalt, limestone, sandstone, default automatic]
    style : choice
        what the ground is made of: natural, or three layers by height in a style [one of natural, great_barrier_reef,
        stone, desert, volcano, default natural]
    layers : group
        borders of the style's layers, as heights over the water
        low_m : number
            height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as
            the style asks [m, -12000 to 9000, derived if left out]
        low_error_m : number
            height above low_m over which the low layer fades; by default 0.1 of the relief [m, 0 to 20000, derived if
            left out]
        high_m : number
            height from which the high layer takes over; by default 0.5 of the relief [m, -12000 to 9000, derived if left
            out]
        high_error_m : number
            height below high_m over which the high layer fades in; by default 0.05 of the relief [m, 0 to 20000, derived
            if left out]
        smooth : switch
            layers fade in and out softly; off: linearly, as in the paper [default True]
        variation : number
            how far borders stray from one height, by noise and on steep ground, which is more of the middle layer [0 to
            1, default 0.5]
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
        the picture
    """
    ...

def texture(
    terrain: Terrain | Array | Path,
    labels: Labels | Array | Path | None = None,
    lake: Field | Array | Path | None = None,
    rivers: Drawing | Shapes | Path | None = None,
    *,
    size_px: int = 2048,
    baked_light: float = 0.5,
    water: bool = True,
    water_level_m: float = 0,
    water_clarity: float = 1,
    climate: TextureClimate = {'latitude_deg': None, 'rain_mm_yr': None, 'wind_from_deg': None},
    tree_line_m: float | None = None,
    snow_line_m: float | None = None,
    rock: Literal["automatic", "granite", "basalt", "limestone", "sandstone"] = 'automatic',
    style: Literal["natural", "great_barrier_reef", "stone", "desert", "volcano"] = 'natural',
    layers: TextureLayers = {'high_error_m': None, 'high_m': None, 'low_error_m': None, 'low_m': None, 'smooth': True, 'variation': 0.5},
    min_sea_m2: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Image:
    """The ground from above, as a texture for meshes.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    labels : Labels, optional
        its regions: where beach, lagoon and reef are
    lake : Field, optional
        metres of standing water over it, as hydrology.lakes gives them
    rivers : Drawing, optional
        lines of running water, as wide as they say
    
    Parameters
    ----------
    size_px : integer
        pixels along the terrain's longer side [1 to 16384, default 2048]
    baked_light : number
        soft light from the north-west and shade in valleys; 0 gives pure albedo for a lit renderer [0 to 1, default 0.5]
    water : switch
        show the sea floor as seen through the water [default True]
    water_level_m : number
        height of the water's surface [m, -12000 to 9000, default 0]
    water_clarity : number
        how far one sees in water, 1 in clear tropical water [0.05 to 5, default 1]
    climate : group
        what grows on the land, in the natural style
        preset : preset
            values that belong together, by a word; what is stated besides wins [one of tropical, temperate, arid, polar,
            none if left out]
            "tropical": rain forest up to the clouds
            "temperate": meadows and woods, bare rock above, snow on high mountains
            "arid": bare rock and sand, hardly any green
            "polar": tundra along the coast under ice and snow
        latitude_deg : number
            latitude, which decides how warm it is; by default that of the terrain's place if it has one, else -18 in a
            sea and 45 inland [deg, -90 to 90, derived if left out]
        rain_mm_yr : number
            rain in a year, mean over the land; below 250 a desert; by default as usual for the latitude [mm/yr, 0 to
            15000, derived if left out]
        wind_from_deg : number
            bearing that the wind brings rain from: windward slopes are wet, leeward ones dry; by default trade winds or
            westerlies by the latitude [deg, -360 to 360, derived if left out]
    tree_line_m : number
        height over the water where forest ends; by default as usual for the latitude [m, 1 to 9000, derived if left out]
    snow_line_m : number
        height over the water where snow stays; by default as usual for the latitude [m, -1000 to 20000, derived if left
        out]
    rock : choice
        bare rock in the natural style; automatic is basalt in a warm sea, else granite [one of automatic, granite,
        basalt, limestone, sandstone, default automatic]
    style : choice
        what the ground is made of: natural, or three layers by height in a style [one of natural, great_barrier_reef,
        stone, desert, volcano, default natural]
    layers : group
        borders of the style's layers, as heights over the water
        low_m : number
            height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as
            the style asks [m, -12000 to 9000, derived if left out]
        low_error_m : number
            height above low_m over which the low layer fades; by default 0.1 of the relief [m, 0 to 20000, derived if
            left out]
        high_m : number
            height from which the high layer takes over; by default 0.5 of the relief [m, -12000 to 9000, derived if left
            out]
        high_error_m : number
            height below high_m over which the high layer fades in; by default 0.05 of the relief [m, 0 to 20000, derived
            if left out]
        smooth : switch
            layers fade in and out softly; off: linearly, as in the paper [default True]
        variation : number
            how far borders stray from one height, by noise and on steep ground, which is more of the middle layer [0 to
            1, default 0.5]
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
        the picture
    """
    ...

def contours(
    contours: Contours | Path,
    *,
    width_px: int = 1600,
    title: str = '',
    index_every: int = 5,
    labels: bool = True,
    water: bool = True,
    basin_ticks: bool = True,
    scale_bar: bool = True,
    north_arrow: bool = True,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Image:
    """Contours as a topographic map: lines with their heights, water, scale bar.
    
    Inputs
    ------
    contours : Contours
        nested closed contours
    
    Parameters
    ----------
    width_px : integer
        width of the picture in pixels [16 to 16384, default 1600]
    title : text
        text over the map; none if empty
    index_every : integer
        every so many heights the line is stronger, counted from sea level where heights are multiples of their interval,
        else from the lowest [1 to 1000, default 5]
    labels : switch
        write the heights of the stronger lines into them [default True]
    water : switch
        tint what lies below a contour of sea level [default True]
    basin_ticks : switch
        draw ticks into basins, to tell them from hills [default True]
    scale_bar : switch
        show lengths, and the interval between contours, below the map [default True]
    north_arrow : switch
        show where north is [default True]
    
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
        the picture
    """
    ...

def layers(
    terrain: Terrain | Array | Path,
    *,
    style: Literal["natural", "great_barrier_reef", "stone", "desert", "volcano"] = 'natural',
    layers: LayersLayers = {'high_error_m': None, 'high_m': None, 'low_error_m': None, 'low_m': None, 'smooth': True, 'variation': 0.5},
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> LayersResult:
    """The layers of ground that a style's pictures show: three masks that sum to one, for splat maps.
    
    Source: P4 sec. 3.4, eq. 3-6.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    style : choice
        the style of the pictures that it goes with; natural: borders at shares of the relief, as terrain.layers [one of
        natural, great_barrier_reef, stone, desert, volcano, default natural]
    layers : group
        borders between the low layer (red), the middle (green), the high (blue)
        low_m : number
            height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as
            the style asks [m, -12000 to 9000, derived if left out]
        low_error_m : number
            height above low_m over which the low layer fades; by default 0.1 of the relief [m, 0 to 20000, derived if
            left out]
        high_m : number
            height from which the high layer takes over; by default 0.5 of the relief [m, -12000 to 9000, derived if left
            out]
        high_error_m : number
            height below high_m over which the high layer fades in; by default 0.05 of the relief [m, 0 to 20000, derived
            if left out]
        smooth : switch
            layers fade in and out softly; off: linearly, as in the paper [default True]
        variation : number
            how far borders stray from one height, by noise and on steep ground, which is more of the middle layer [0 to
            1, default 0.5]
    
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
