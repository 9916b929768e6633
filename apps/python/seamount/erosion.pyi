# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class RunRivers(TypedDict, total=False):
    deposition: float
    """how readily rivers drop their load (G): 0 never, 1 as in most rivers, more fills valleys [0 to 10, default 1]"""
    fan_m: float
    """width over which rivers lay down their load where they leave their valleys: 0 narrow beds, more makes fans and aprons [m, 0 to 100000, default 400]"""
    debris_ease: float
    """how much more easily rivers cut debris than bedrock [0.01 to 1000, default 2]"""
    sediment_ease: float
    """how much more easily rivers cut fine sediment than bedrock [0.01 to 1000, default 5]"""
    evaporation_per_km: float
    """share of a river's water that is lost on a kilometre [1/km, 0 to 1, default 0]"""
    channel_m2: float
    """area that is drained without a channel [m2, 0 to 100000000, default 1000]"""

class RunSlopes(TypedDict, total=False):
    bedrock_angle_deg: float
    """steepest slope of bedrock, which joints vary with hardness_variation; rock four times as hard stands twice as steep [deg, 1 to 89, default 40]"""
    debris_angle_deg: float
    """steepest slope of debris [deg, 1 to 89, default 33]"""
    sediment_angle_deg: float
    """steepest slope of fine sediment [deg, 1 to 89, default 22]"""
    creep_m2_yr: float
    """diffusivity of soil: rounds crests and spaces valleys; 0.001 dry to 0.05 wet [m2/yr, 0 to 10, default 0.005]"""
    weathering_mm_yr: float
    """bedrock that crumbles where it is bare and steep [mm/yr, 0 to 100, default 0.1]"""

class RunCoast(TypedDict, total=False):
    retreat_mm_yr: float
    """retreat of exposed cliffs [mm/yr, 0 to 10000, default 2]"""
    wave_base_m: float
    """depth down to which waves move sediment [m, 0.1 to 200, default 8]"""
    settling_m: float
    """distance over which most of a river's load settles in the sea [m, 1 to 1000000, default 4000]"""

class RunlithologyBeds(TypedDict, total=False):
    name: str
    """what the bed is called, for those who read the recipe"""
    thickness_m: float
    """thickness across the bed; beds of 0.1 to 10, caps of 10 to 100 [m, 0.1 to 10000, default 50]"""
    hardness: float
    """how many times as hard as `erodibility` says: shale 0.2 to 0.5, a cap 3 to 10; four times as hard stands twice as steep [0.01 to 1000, default 1]"""

class RunlithologyFaults(TypedDict, total=False):
    trace: Sequence[Point]
    """line of the fault at the height `top_m`, at least two points; it goes on straight beyond its ends [m]"""
    dip_deg: float
    """dip of the fault to the right of its trace [deg, 10 to 90, default 70]"""
    throw_m: float
    """how far the beds to the right of the trace have gone down; negative: up [m, -10000 to 10000, default 100]"""

class RunLithology(TypedDict, total=False):
    beds: Sequence[RunlithologyBeds]
    """beds of rock from the top down; none: rock without beds"""
    repeat: bool
    """the sequence repeats above and below; else its first and last bed have no end [default True]"""
    top_m: float
    """height of the first bed's top, before any uplift [m, -12000 to 12000, default 0]"""
    top_x_m: float
    """where it has that height, east [m, -10000000 to 10000000, default 0]"""
    top_y_m: float
    """where it has that height, north [m, -10000000 to 10000000, default 0]"""
    dip_deg: float
    """tilt of the beds: mesas 0, cuestas 2 to 15, hogbacks over 30 [deg, 0 to 85, default 0]"""
    strike_deg: float
    """bearing of level lines on the beds, clockwise from north; they dip to the right of it [deg, -360 to 360, default 0]"""
    fold_height_m: float
    """height of arches over troughs; 0: no folds [m, 0 to 5000, default 0]"""
    fold_wavelength_m: float
    """from one arch to the next [m, 10 to 1000000, default 6000]"""
    fold_axis_deg: float | None
    """bearing of arches and troughs; by default the strike [deg, -360 to 360, derived if left out]"""
    thickness_variation: float
    """share by which beds thicken and thin from place to place [0 to 0.9, default 0]"""
    faults: Sequence[RunlithologyFaults]
    """faults that have moved the beds"""

class RunResult(NamedTuple):
    terrain: Terrain
    debris: Field
    sediment: Field
    flow: Field
    lake: Field
    bed: Field
    labels: Labels
    balance: Report

def run(
    terrain: Terrain | Array | Path,
    hardness: Field | Array | Path | None = None,
    mask: Field | Array | Path | None = None,
    uplift: Field | Array | Path | None = None,
    rain: Field | Array | Path | None = None,
    debris: Field | Array | Path | None = None,
    sediment: Field | Array | Path | None = None,
    labels: Labels | Array | Path | None = None,
    *,
    preset: Literal["young", "mature", "old", "desert"] | None = None,
    method: Literal["hydraulic", "stream_power"] = 'hydraulic',
    years: float = 300000,
    uplift_mm_yr: float = 0,
    runoff_mm_yr: float = 1000,
    erodibility: float = 1e-05,
    hardness_variation: float = 0.6,
    sea_m: float = 0,
    rivers: RunRivers = {'channel_m2': 1000, 'debris_ease': 2, 'deposition': 1, 'evaporation_per_km': 0, 'fan_m': 400, 'sediment_ease': 5},
    slopes: RunSlopes = {'bedrock_angle_deg': 40, 'creep_m2_yr': 0.005, 'debris_angle_deg': 33, 'sediment_angle_deg': 22, 'weathering_mm_yr': 0.1},
    coast: RunCoast = {'retreat_mm_yr': 2, 'settling_m': 4000, 'wave_base_m': 8},
    lithology: RunLithology = {'beds': [], 'dip_deg': 0, 'faults': [], 'fold_axis_deg': None, 'fold_height_m': 0, 'fold_wavelength_m': 6000, 'repeat': True, 'strike_deg': 0, 'thickness_variation': 0, 'top_m': 0, 'top_x_m': 0, 'top_y_m': 0},
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> RunResult:
    """Years of rivers, slides, creep and waves on bedrock, debris and sediment; or a range that rises and wears.
    
    Source: P1 sec. 5.4; Braun and Willett 2013, Yuan et al. 2019, Tarboton 1997, Musgrave et al. 1989.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    hardness : Field, optional
        how many times as hard as `erodibility` says, 0.1 and more; 1 if absent. A mask or picture from 0 to 1 makes rock
        from 1 to 10 times as hard
    mask : Field, optional
        share of the change that is kept: 0 nothing, 1 all; over a hard edge it fades as gently as its depth asks for
    uplift : Field, optional
        share of `uplift_mm_yr`; 1 if absent
    rain : Field, optional
        share of `runoff_mm_yr`, as wet and dry sides of mountains; 1 if absent
    debris : Field, optional
        thickness of debris on the bedrock in metres; 0 if absent
    sediment : Field, optional
        thickness of fine sediment in metres; 0 if absent
    labels : Labels, optional
        its regions, which follow the new coast
    
    Parameters
    ----------
    preset : preset
        values that belong together, by a word; what is stated besides wins [one of young, mature, old, desert, none if
        left out]
        "young": steep land that the first gullies and gorges cut
        "mature": sharp ridges between branching valleys, with floors where rivers are large
        "old": the low rest of hills, rounded, over wide plains of their debris
        "desert": bare steep ranges cut by many gullies, over aprons of debris and dry basins
    method : choice
        hydraulic: rivers that also deposit, weathering, waves; stream_power: rivers that only cut, creep, failing slopes
        [one of hydraulic, stream_power, default hydraulic]
    years : number
        how long erosion acts [yr, 0 to 1000000000, default 300000]
    uplift_mm_yr : number
        rise of the land, times the input `uplift` [mm/yr, 0 to 100, default 0]
    runoff_mm_yr : number
        rain that runs off, times the input `rain` [mm/yr, 1 to 20000, default 1000]
    erodibility : number
        K in K sqrt(discharge) slope, the metres per year that rivers cut into bedrock by their discharge in m3/yr; hard
        rock 1e-6, soft 1e-4, loose ground 1e-3 [1/sqrt(m yr), 0 to 0.1, default 1e-05]
    hardness_variation : number
        how much bedrock's hardness varies from place to place: v makes it up to (1 + v) / (1 - v) times as hard [0 to
        0.95, default 0.6]
    sea_m : number
        level of the sea; far below the terrain for none [m, -12000 to 9000, default 0]
    rivers : group
        what rivers carry and where they drop it
        deposition : number
            how readily rivers drop their load (G): 0 never, 1 as in most rivers, more fills valleys [0 to 10, default 1]
        fan_m : number
            width over which rivers lay down their load where they leave their valleys: 0 narrow beds, more makes fans and
            aprons [m, 0 to 100000, default 400]
        debris_ease : number
            how much more easily rivers cut debris than bedrock [0.01 to 1000, default 2]
        sediment_ease : number
            how much more easily rivers cut fine sediment than bedrock [0.01 to 1000, default 5]
        evaporation_per_km : number
            share of a river's water that is lost on a kilometre [1/km, 0 to 1, default 0]
        channel_m2 : number
            area that is drained without a channel [m2, 0 to 100000000, default 1000]
    slopes : group
        what slopes can stand and how they wear
        bedrock_angle_deg : number
            steepest slope of bedrock, which joints vary with hardness_variation; rock four times as hard stands twice as
            steep [deg, 1 to 89, default 40]
        debris_angle_deg : number
            steepest slope of debris [deg, 1 to 89, default 33]
        sediment_angle_deg : number
            steepest slope of fine sediment [deg, 1 to 89, default 22]
        creep_m2_yr : number
            diffusivity of soil: rounds crests and spaces valleys; 0.001 dry to 0.05 wet [m2/yr, 0 to 10, default 0.005]
        weathering_mm_yr : number
            bedrock that crumbles where it is bare and steep [mm/yr, 0 to 100, default 0.1]
    coast : group
        what waves do to the coast
        retreat_mm_yr : number
            retreat of exposed cliffs [mm/yr, 0 to 10000, default 2]
        wave_base_m : number
            depth down to which waves move sediment [m, 0.1 to 200, default 8]
        settling_m : number
            distance over which most of a river's load settles in the sea [m, 1 to 1000000, default 4000]
    lithology : group
        beds of harder and softer rock in three dimensions
        beds : groups
            beds of rock from the top down; none: rock without beds
            name : text
                what the bed is called, for those who read the recipe
            thickness_m : number
                thickness across the bed; beds of 0.1 to 10, caps of 10 to 100 [m, 0.1 to 10000, default 50]
            hardness : number
                how many times as hard as `erodibility` says: shale 0.2 to 0.5, a cap 3 to 10; four times as hard stands
                twice as steep [0.01 to 1000, default 1]
        repeat : switch
            the sequence repeats above and below; else its first and last bed have no end [default True]
        top_m : number
            height of the first bed's top, before any uplift [m, -12000 to 12000, default 0]
        top_x_m : number
            where it has that height, east [m, -10000000 to 10000000, default 0]
        top_y_m : number
            where it has that height, north [m, -10000000 to 10000000, default 0]
        dip_deg : number
            tilt of the beds: mesas 0, cuestas 2 to 15, hogbacks over 30 [deg, 0 to 85, default 0]
        strike_deg : number
            bearing of level lines on the beds, clockwise from north; they dip to the right of it [deg, -360 to 360,
            default 0]
        fold_height_m : number
            height of arches over troughs; 0: no folds [m, 0 to 5000, default 0]
        fold_wavelength_m : number
            from one arch to the next [m, 10 to 1000000, default 6000]
        fold_axis_deg : number
            bearing of arches and troughs; by default the strike [deg, -360 to 360, derived if left out]
        thickness_variation : number
            share by which beds thicken and thin from place to place [0 to 0.9, default 0]
        faults : groups
            faults that have moved the beds
            trace : points
                line of the fault at the height `top_m`, at least two points; it goes on straight beyond its ends [m]
            dip_deg : number
                dip of the fault to the right of its trace [deg, 10 to 90, default 70]
            throw_m : number
                how far the beds to the right of the trace have gone down; negative: up [m, -10000 to 10000, default 100]
    
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
    debris : Field
        thickness of debris in metres
    sediment : Field
        thickness of fine sediment in metres
    flow : Field
        discharge in m3 per year
    lake : Field
        depth of standing water on land in metres
    bed : Field
        number of the bed at the top of the bedrock, from 1 for the first; 0 without beds
    labels : Labels
        its regions: land is beach or mountain, sea lagoon, reef or abyss; mountain and abyss if no labels were given
    balance : Report
        volumes in m3: bedrock worn, laid down on land and under water, left over the border; and the error
    """
    ...
