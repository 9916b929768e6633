# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class RunResult(NamedTuple):
    terrain: Terrain
    surface: Terrain
    ice: Field
    worn: Field

def run(
    terrain: Terrain | Array | Path,
    hardness: Field | Array | Path | None = None,
    *,
    years: float = 100000,
    ela_m: float = 1800,
    balance_gradient_m_yr_km: float = 7,
    max_accumulation_m_yr: float = 1.5,
    abrasion: float = 0.0001,
    widening_m: float = 100,
    wall_angle_deg: float = 55,
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> RunResult:
    """Ice that gathers over the equilibrium line, flows, and carves valleys and cirques.
    
    Source: Mahaffy 1976; Oerlemans 1984; Braun, Zwartz and Tomkin 1999.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres
    hardness : Field, optional
        how many times as hard as `abrasion` says; 1 if absent
    
    Parameters
    ----------
    years : number
        how long glaciers carve; 0 shows the ice on the terrain as it is [yr, 0 to 10000000, default 100000]
    ela_m : number
        equilibrium line: height above which more snow falls in a year than melts [m, -12000 to 12000, default 1800]
    balance_gradient_m_yr_km : number
        ice gained or lost per year for each kilometre over or under the equilibrium line; 3 dry, 7 Alps, 15 wet [m/yr/km,
        0.1 to 50, default 7]
    max_accumulation_m_yr : number
        most ice that a year's snow makes [m/yr, 0.01 to 20, default 1.5]
    abrasion : number
        metres of bed that are carved for each metre that ice slides; hard rock 1e-5, soft 1e-3 [0 to 0.01, default
        0.0001]
    widening_m : number
        how far to the sides of its fastest ice a glacier carves: floors of valleys become wide and flat [m, 0 to 5000,
        default 100]
    wall_angle_deg : number
        steepest wall that stands over carved ground; what is steeper falls onto the ice [deg, 10 to 89, default 55]
    
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
        heights in metres when the ice has gone
    surface : Terrain
        heights of ground and ice in metres at the end of the years
    ice : Field
        thickness of the ice in metres at the end of the years
    worn : Field
        metres by which the ground was carved
    """
    ...
