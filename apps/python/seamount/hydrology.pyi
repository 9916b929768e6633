# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class FillResult(NamedTuple):
    terrain: Terrain
    change: Field
    lakes: Drawing

class LakesResult(NamedTuple):
    surface: Terrain
    lake: Field
    sinks: Field
    lakes: Drawing

class FlowResult(NamedTuple):
    terrain: Terrain
    cells: Field
    area: Field
    direction: Field
    basins: Field
    catchments: Drawing

class DescribeResult(NamedTuple):
    report: Report
    peaks: Drawing

def fill(
    terrain: Terrain | Array | Path,
    *,
    depressions: Literal["fill", "breach"] = 'fill',
    descend: bool = True,
    sea: bool = True,
    min_sea_m2: float | None = None,
    max_cut_m: float = 50,
    max_length_m: float = 5000,
    min_lake_m2: float = 20000,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> FillResult:
    """A terrain without depressions: filled to their outlets, or breached; and the lakes.
    
    Source: Barnes, Lehman and Mulla 2014; Lindsay and Dhun 2015.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    depressions : choice
        fill: raise them to their outlets; breach: cut the cheapest way out [one of fill, breach, default fill]
    descend : switch
        let filled ground fall towards its outlet by the least step that a float can make [default True]
    sea : switch
        flow ends in cells at or below sea level; otherwise only at the terrain's edge [default True]
    min_sea_m2 : number
        enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m,
        or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2, 0 to 1e+15, derived
        if left out]
    max_cut_m : number
        breach: deepest cut; what needs more is filled [m, 0 to 10000, default 50]
    max_length_m : number
        breach: longest cut; what needs more is filled [m, 0 to 1000000, default 5000]
    min_lake_m2 : number
        smaller lakes are not traced [m2, 0 to 1e+12, default 20000]
    
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
        heights from which water runs off everywhere
    change : Field
        metres by which it was raised (positive) or cut
    lakes : Drawing
        areas with level_m, depth_m, area_m2 and volume_m3
    """
    ...

def lakes(
    terrain: Terrain | Array | Path,
    runoff: Field | Array | Path | None = None,
    *,
    runoff_mm_yr: float = 100,
    rain_mm_yr: float = 400,
    evaporation_mm_yr: float = 1200,
    min_depth_m: float = 5,
    min_lake_m2: float = 20000,
    sea: bool = True,
    min_sea_m2: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> LakesResult:
    """Lakes as a climate leaves them, with outlet and without: inflow against evaporation.
    
    Source: Barnes, Callaghan and Wickert 2020.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    runoff : Field, optional
        rain that runs off each cell in a year, in mm
    
    Parameters
    ----------
    runoff_mm_yr : number
        rain on dry ground that runs off, in a year; the input runoff says it for each cell [mm/yr, 0 to 20000, default
        100]
    rain_mm_yr : number
        rain that falls on a lake in a year [mm/yr, 0 to 20000, default 400]
    evaporation_mm_yr : number
        what a lake's surface loses to the air in a year: 600 in cool, 1200 in temperate dry, 2500 in hot dry places; 0
        fills all lakes to their outlets [mm/yr, 0 to 1000000, default 1200]
    min_depth_m : number
        depressions that are less deep count as roughness of the ground, full and without a lake [m, 0 to 10000, default
        5]
    min_lake_m2 : number
        smaller lakes are not traced [m2, 0 to 1e+12, default 20000]
    sea : switch
        flow ends in cells at or below sea level; otherwise only at the terrain's edge [default True]
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
    surface : Terrain
        heights of the ground and of the lakes' surfaces
    lake : Field
        metres of water over the ground; 0 where there is no lake
    sinks : Field
        1 where flow ends: in closed lakes, and on the lowest ground of dry depressions
    lakes : Drawing
        areas with level_m, depth_m, area_m2, volume_m3, closed, inflow_m3_s, outflow_m3_s
    """
    ...

def flow(
    terrain: Terrain | Array | Path,
    sinks: Field | Array | Path | None = None,
    *,
    method: Literal["d8", "dinf", "mfd"] = 'd8',
    exponent: float = 1.1,
    sea: bool = True,
    min_catchment_m2: float | None = None,
    min_sea_m2: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> FlowResult:
    """Where water runs and how much gathers: one neighbour, two or all (D8, D-infinity, multiple).
    
    Source: O'Callaghan and Mark 1984; Tarboton 1997; Holmgren 1994.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    sinks : Field, optional
        flow ends where it is above 0: the closed lakes of hydrology.lakes
    
    Parameters
    ----------
    method : choice
        d8: to the steepest neighbour; dinf: between two; mfd: over all that are lower [one of d8, dinf, mfd, default d8]
    exponent : number
        mfd: shares go with slope to this power; higher gathers more [0.1 to 20, default 1.1]
    sea : switch
        flow ends in cells at or below sea level; otherwise only at the terrain's edge [default True]
    min_catchment_m2 : number
        smaller catchments are not traced; a five-hundredth of the terrain's area if absent [m2, 0 to 1e+15, derived if
        left out]
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
    terrain : Terrain
        heights with depressions filled
    cells : Field
        cells that drain through each cell, itself included
    area : Field
        the same in square metres
    direction : Field
        bearing of the flow in degrees clockwise from north; -1 where it ends
    basins : Field
        number of the catchment, 1 the largest; 0 for open water
    catchments : Drawing
        areas of the larger catchments with area_m2, mouth_x and mouth_y
    """
    ...

def rivers(
    terrain: Terrain | Array | Path,
    sinks: Field | Array | Path | None = None,
    *,
    min_area_m2: float | None = None,
    runoff_mm_yr: float = 500,
    width_factor: float = 6,
    sea: bool = True,
    min_sea_m2: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Drawing:
    """The river network as lines with stream order, discharge and width.
    
    Source: Strahler 1957; Leopold and Maddock 1953.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    sinks : Field, optional
        flow ends where it is above 0: the closed lakes of hydrology.lakes
    
    Parameters
    ----------
    min_area_m2 : number
        catchment with which a river begins; a five-hundredth of the land if absent [m2, 1 to 1e+13, derived if left out]
    runoff_mm_yr : number
        rain that runs off, in a year [mm/yr, 0 to 20000, default 500]
    width_factor : number
        width in metres of a river of 1 m3/s; it goes with the square root of discharge [0 to 100, default 6]
    sea : switch
        flow ends in cells at or below sea level; otherwise only at the terrain's edge [default True]
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
    rivers : Drawing
        lines downstream with order, length_m, area_m2, discharge_m3_s, width_m and fall_m
    """
    ...

def ridges(
    terrain: Terrain | Array | Path,
    *,
    min_area_m2: float | None = None,
    sea: bool = True,
    min_sea_m2: float | None = None,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> Drawing:
    """The network of ridges as lines: the rivers of the inverted terrain.
    
    Source: P1 sec. 5.1.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    
    Parameters
    ----------
    min_area_m2 : number
        ground whose ways up join before a ridge begins; a five-hundredth of the land if absent [m2, 1 to 1e+13, derived
        if left out]
    sea : switch
        ridges stand on cells above sea level; otherwise everywhere [default True]
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
    ridges : Drawing
        lines uphill with order, length_m, area_m2 and rise_m
    """
    ...

def describe(
    terrain: Terrain | Array | Path,
    reference: Terrain | Array | Path | None = None,
    *,
    sea: bool = True,
    min_sea_m2: float | None = None,
    relief_window_m: float = 1000,
    channel_m2: float | None = None,
    min_prominence_m: float | None = None,
    cell_m: float | None = None,
    title: str = '',
    reference_title: str = '',
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> DescribeResult:
    """What a terrain is like in numbers and curves, and how far it is from a reference.
    
    Source: P2 sec. 6.5; Argudo, Guerin, Schott and Galin 2025.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    reference : Terrain, optional
        another terrain to compare with
    
    Parameters
    ----------
    sea : switch
        describe only what lies above sea level [default True]
    min_sea_m2 : number
        enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m,
        or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2, 0 to 1e+15, derived
        if left out]
    relief_window_m : number
        side of the square of local relief [m, 0.01 to 1000000, default 1000]
    channel_m2 : number
        catchment with which a river, or a ridge, begins; a 2000th of the smaller land if absent [m2, 1 to 1e+13, derived
        if left out]
    min_prominence_m : number
        least prominence of a peak; a 50th of the reference's relief if absent [m, 0.001 to 10000, derived if left out]
    cell_m : number
        cell size at which both are compared, no finer than theirs; the coarser of these if absent [m, 0.01 to 100000,
        derived if left out]
    title : text
        name of the terrain on the page
    reference_title : text
        name of the reference on the page
    
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
    report : Report
        descriptors with curves, measures and distances
    peaks : Drawing
        summits of the terrain with height_m, prominence_m and isolation_m
    """
    ...
