# Made by `python3 -m seamount.stubs`; see apps/python/seamount/stubs.py.
from typing import Any, Callable, Literal, Mapping, NamedTuple, Sequence, TypedDict

from ._frame import Frame
from ._types import Array, Outline, Path, Point, Polygon, Region, River, Shapes, Stroke
from ._values import (Catalogue, Contours, Current, Drawing, Field, Image, Labels, Objects, Raster, Report, Terrain, Things,
                      Tin)

class GrowStarts(TypedDict, total=False):
    points: Sequence[Point]
    """places where growth starts; without any start each separate piece of habitat has one [m]"""
    line: Sequence[Point]
    """a line along which growth starts, such as a shelf edge [m]"""
    contour_m: float | None
    """growth starts along the contour at this height [m, -12000 to 9000, derived if left out]"""
    line_cover: float
    """share of lines where growth starts; the rest are passes [0 to 1, default 0.7]"""
    segment_m: float
    """length of a stretch of line with its pass [m, 1 to 10000000, default 2500]"""
    random: int
    """number of random places of the habitat, or of the input 'start': many small reefs, few large [0 to 100000, default 0]"""

class GrowBounds(TypedDict, total=False):
    light_depth_m: float
    """depth at which a tenth of the light is left, which corals need: 60 in the clearest ocean, 40 in clear water, 25 over shelves, 10 off muddy rivers [m, 1 to 200, default 40]"""
    low_m: float | None
    """no growth where the ground is lower; if absent, below light_depth_m (heights.mode proportional: none) [m, -12000 to 9000, derived if left out]"""
    high_m: float | None
    """no growth where the ground is higher; if absent, the sea's surface (heights.mode proportional: none) [m, -12000 to 9000, derived if left out]"""
    margin_m: float | None
    """no growth this near to the terrain's edge, in bays up to twice that; 3 kernel radii if absent [m, 0 to 10000000, derived if left out]"""

class GrowWalk(TypedDict, total=False):
    stickiness: float
    """chance to settle at a touch; low values give thick, rounded reefs [0.001 to 1, default 1]"""
    launch: Literal["ring", "anywhere"]
    """where walks start: on a ring around the reef, or anywhere on the lattice [one of ring, anywhere, default anywhere]"""
    current: float
    """how strongly currents carry the particles [0 to 1, default 0]"""
    current_to_deg: float
    """bearing to which currents flow [deg, -360 to 360, default 300]"""
    max_steps: int
    """steps after which a walk is given up [1 to 1000000000, default 200000]"""

class GrowKernel(TypedDict, total=False):
    radius_m: float | None
    """radius of the kernels around particles; 1.465 lattice_m if absent, as in P4 [m, 0.1 to 1000000, derived if left out]"""
    combine: Literal["union", "sum"]
    """how kernels go together: as one united outline, or summed (P4) [one of union, sum, default union]"""
    k: float
    """exponent of the normal kernel: steepness of the sides of the aggregate and of summed reefs [2 to 40, default 10]"""
    k1: float
    """the rim lies 1 / k1 of the radius inside the edge [1.1 to 40, default 5]"""
    k1_jitter: float
    """random share of k1, which makes the rim uneven [0 to 0.9, default 0.25]"""
    k2: float
    """exponent of the log-normal kernel: how squarely the rim stands; 10 in P4 [2 to 40, default 4]"""

class GrowHeights(TypedDict, total=False):
    mode: Literal["saturating", "proportional"]
    """saturating: up to the sea's surface; proportional: to the base over datum_m (P4) [one of saturating, proportional, default saturating]"""
    flat_m: float
    """height at which the normal lift saturates: the reef flat [m, -12000 to 9000, default -1.8]"""
    crest_m: float
    """height at which the rim saturates: the reef crest [m, -12000 to 9000, default -0.4]"""
    lift_m: float
    """height by which a reef lifts the ground at most (saturating) [m, 0 to 5000, default 60]"""
    rim_m: float
    """height that the edge kernel lifts the rim (saturating) [m, 0 to 500, default 2.5]"""
    lee_rim: float
    """share of the rim's height that is left in the lee of the swell [0 to 1, default 0.35]"""
    fore_slope_deg: float
    """slope of the fore reef to windward (saturating, union) [deg, 2 to 70, default 26]"""
    lee_slope_deg: float
    """slope of the reef's side in the lee [deg, 2 to 70, default 14]"""
    flat_width_m: float
    """width of the flat to windward, half of that in the lee; behind it wide reefs hold a lagoon [m, 1 to 100000, default 350]"""
    w0: float
    """weight of the base terrain over datum_m [0 to 10, default 1]"""
    w1: float
    """weight of the normal kernels [0 to 10, default 1]"""
    w2: float
    """weight of the log-normal kernels at the edge [0 to 10, default 1]"""
    datum_m: float
    """the zero of P4's heights: w0 and proportional lifts count from it [m, -12000 to 9000, default -250]"""

class GrowSand(TypedDict, total=False):
    lagoon_m: float
    """floor of lagoons within wide or crowded reefs [m, -12000 to 9000, default -9]"""
    fill: float
    """how far sand fills the water between reefs, up to lagoon_m [0 to 1, default 0.8]"""
    knolls_per_km2: float
    """patch reefs on the floors of lagoons, many small and few large [1/km2, 0 to 1000, default 25]"""
    cays: int
    """islets of sand on the lee of flats; wide ones carry plants [0 to 10000, default 3]"""
    cay_m: float
    """height of the larger islets [m, 0 to 50, default 3]"""

class GrowPasses(TypedDict, total=False):
    least_km2: float
    """lagoons at least this large have a pass to the open sea (saturating) [km2, 0 to 1000000000, default 0.2]"""
    spacing_m: float
    """length of barrier for one pass: longer ones have more [m, 100 to 10000000, default 16000]"""
    width_m: float | None
    """width of passes; if absent 100 to 1000 by the size of the lagoon [m, 10 to 5000, derived if left out]"""
    depth_m: float | None
    """depth of passes, never below the ground on which the reef stands; if absent 10 to 60 by the size of the lagoon [m, 4 to 200, derived if left out]"""

class GrowDetail(TypedDict, total=False):
    relief_m: float
    """unevenness of reef flats and lagoon floors [m, 0 to 50, default 1]"""
    grooves_m: float
    """depth of spurs and grooves on the windward fore reef, where cells resolve them [m, 0 to 50, default 3]"""
    groove_spacing_m: float
    """distance from spur to spur [m, 1 to 5000, default 80]"""

class GrowFinish(TypedDict, total=False):
    blur_m: float
    """blur of the result; 0: none [m, 0 to 100000, default 0]"""
    normalise: bool
    """stretch the result to low_m ... high_m [default False]"""
    low_m: float
    """lowest height after normalising [m, -12000 to 9000, default -250]"""
    high_m: float
    """highest height after normalising [m, -12000 to 9000, default 250]"""

class GrowResult(NamedTuple):
    terrain: Terrain
    aggregate: Field
    labels: Labels
    outlines: Drawing

def grow(
    terrain: Terrain | Array | Path,
    labels: Labels | Array | Path | None = None,
    habitat: Field | Array | Path | None = None,
    start: Field | Array | Path | None = None,
    drawing: Drawing | Shapes | Path | None = None,
    *,
    lattice_m: float | None = None,
    particles: int = 0,
    irregularity: float = 1,
    swell_from_deg: float = 130,
    lagoon_gap_m: float | None = None,
    starts: GrowStarts = {'contour_m': None, 'line': [], 'line_cover': 0.7, 'points': [], 'random': 0, 'segment_m': 2500},
    bounds: GrowBounds = {'high_m': None, 'light_depth_m': 40, 'low_m': None, 'margin_m': None},
    walk: GrowWalk = {'current': 0, 'current_to_deg': 300, 'launch': 'anywhere', 'max_steps': 200000, 'stickiness': 1},
    kernel: GrowKernel = {'combine': 'union', 'k': 10, 'k1': 5, 'k1_jitter': 0.25, 'k2': 4, 'radius_m': None},
    heights: GrowHeights = {'crest_m': -0.4, 'datum_m': -250, 'flat_m': -1.8, 'flat_width_m': 350, 'fore_slope_deg': 26, 'lee_rim': 0.35, 'lee_slope_deg': 14, 'lift_m': 60, 'mode': 'saturating', 'rim_m': 2.5, 'w0': 1, 'w1': 1, 'w2': 1},
    sand: GrowSand = {'cay_m': 3, 'cays': 3, 'fill': 0.8, 'knolls_per_km2': 25, 'lagoon_m': -9},
    passes: GrowPasses = {'depth_m': None, 'least_km2': 0.2, 'spacing_m': 16000, 'width_m': None},
    detail: GrowDetail = {'groove_spacing_m': 80, 'grooves_m': 3, 'relief_m': 1},
    finish: GrowFinish = {'blur_m': 0, 'high_m': 250, 'low_m': -250, 'normalise': False},
    domain: Frame | Raster | Mapping[str, Any] | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[float], object] | None = None,
) -> GrowResult:
    """Grows barrier reefs, ribbon reefs and patch reefs by diffusion-limited aggregation.
    
    Source: P4 sec. 3.2-3.3, eq. 1 and 2.
    
    Inputs
    ------
    terrain : Terrain
        heights in metres: the ground on which the reef grows
    labels : Labels, optional
        its regions; places without reef keep them
    habitat : Field, optional
        particles settle only where it is at least 0.5
    start : Field, optional
        random kernels lie where it is at least 0.5
    drawing : Drawing, optional
        lines along which, and areas in which growth starts
    
    Parameters
    ----------
    lattice_m : number
        cell of the lattice on which particles walk and settle; if absent 70, or the terrain's cells or 1 / 2048 of it
        where those are larger [m, 0.1 to 1000000, derived if left out]
    particles : integer
        particles to shoot; 0: one for 8 cells of wide habitat, one for 2 along its rim [0 to 4000000, default 0]
    irregularity : number
        how far particles, radii and outlines depart from the lattice [0 to 1, default 1]
    swell_from_deg : number
        bearing from which the swell comes [deg, -360 to 360, default 130]
    lagoon_gap_m : number
        water behind passes up to this width is labelled lagoon; 2 kernel radii if absent [m, 0 to 1000000, derived if
        left out]
    starts : group
        where growth starts
        points : points
            places where growth starts; without any start each separate piece of habitat has one [m]
        line : points
            a line along which growth starts, such as a shelf edge [m]
        contour_m : number
            growth starts along the contour at this height [m, -12000 to 9000, derived if left out]
        line_cover : number
            share of lines where growth starts; the rest are passes [0 to 1, default 0.7]
        segment_m : number
            length of a stretch of line with its pass [m, 1 to 10000000, default 2500]
        random : integer
            number of random places of the habitat, or of the input 'start': many small reefs, few large [0 to 100000,
            default 0]
    bounds : group
        where particles may settle
        light_depth_m : number
            depth at which a tenth of the light is left, which corals need: 60 in the clearest ocean, 40 in clear water,
            25 over shelves, 10 off muddy rivers [m, 1 to 200, default 40]
        low_m : number
            no growth where the ground is lower; if absent, below light_depth_m (heights.mode proportional: none) [m,
            -12000 to 9000, derived if left out]
        high_m : number
            no growth where the ground is higher; if absent, the sea's surface (heights.mode proportional: none) [m,
            -12000 to 9000, derived if left out]
        margin_m : number
            no growth this near to the terrain's edge, in bays up to twice that; 3 kernel radii if absent [m, 0 to
            10000000, derived if left out]
    walk : group
        how particles come to the reef
        stickiness : number
            chance to settle at a touch; low values give thick, rounded reefs [0.001 to 1, default 1]
        launch : choice
            where walks start: on a ring around the reef, or anywhere on the lattice [one of ring, anywhere, default
            anywhere]
        current : number
            how strongly currents carry the particles [0 to 1, default 0]
        current_to_deg : number
            bearing to which currents flow [deg, -360 to 360, default 300]
        max_steps : integer
            steps after which a walk is given up [1 to 1000000000, default 200000]
    kernel : group
        shape of the reef around each particle
        radius_m : number
            radius of the kernels around particles; 1.465 lattice_m if absent, as in P4 [m, 0.1 to 1000000, derived if
            left out]
        combine : choice
            how kernels go together: as one united outline, or summed (P4) [one of union, sum, default union]
        k : number
            exponent of the normal kernel: steepness of the sides of the aggregate and of summed reefs [2 to 40, default
            10]
        k1 : number
            the rim lies 1 / k1 of the radius inside the edge [1.1 to 40, default 5]
        k1_jitter : number
            random share of k1, which makes the rim uneven [0 to 0.9, default 0.25]
        k2 : number
            exponent of the log-normal kernel: how squarely the rim stands; 10 in P4 [2 to 40, default 4]
    heights : group
        how far the reef lifts the ground
        mode : choice
            saturating: up to the sea's surface; proportional: to the base over datum_m (P4) [one of saturating,
            proportional, default saturating]
        flat_m : number
            height at which the normal lift saturates: the reef flat [m, -12000 to 9000, default -1.8]
        crest_m : number
            height at which the rim saturates: the reef crest [m, -12000 to 9000, default -0.4]
        lift_m : number
            height by which a reef lifts the ground at most (saturating) [m, 0 to 5000, default 60]
        rim_m : number
            height that the edge kernel lifts the rim (saturating) [m, 0 to 500, default 2.5]
        lee_rim : number
            share of the rim's height that is left in the lee of the swell [0 to 1, default 0.35]
        fore_slope_deg : number
            slope of the fore reef to windward (saturating, union) [deg, 2 to 70, default 26]
        lee_slope_deg : number
            slope of the reef's side in the lee [deg, 2 to 70, default 14]
        flat_width_m : number
            width of the flat to windward, half of that in the lee; behind it wide reefs hold a lagoon [m, 1 to 100000,
            default 350]
        w0 : number
            weight of the base terrain over datum_m [0 to 10, default 1]
        w1 : number
            weight of the normal kernels [0 to 10, default 1]
        w2 : number
            weight of the log-normal kernels at the edge [0 to 10, default 1]
        datum_m : number
            the zero of P4's heights: w0 and proportional lifts count from it [m, -12000 to 9000, default -250]
    sand : group
        lagoons and cays
        lagoon_m : number
            floor of lagoons within wide or crowded reefs [m, -12000 to 9000, default -9]
        fill : number
            how far sand fills the water between reefs, up to lagoon_m [0 to 1, default 0.8]
        knolls_per_km2 : number
            patch reefs on the floors of lagoons, many small and few large [1/km2, 0 to 1000, default 25]
        cays : integer
            islets of sand on the lee of flats; wide ones carry plants [0 to 10000, default 3]
        cay_m : number
            height of the larger islets [m, 0 to 50, default 3]
    passes : group
        ways from lagoons to the open sea
        least_km2 : number
            lagoons at least this large have a pass to the open sea (saturating) [km2, 0 to 1000000000, default 0.2]
        spacing_m : number
            length of barrier for one pass: longer ones have more [m, 100 to 10000000, default 16000]
        width_m : number
            width of passes; if absent 100 to 1000 by the size of the lagoon [m, 10 to 5000, derived if left out]
        depth_m : number
            depth of passes, never below the ground on which the reef stands; if absent 10 to 60 by the size of the lagoon
            [m, 4 to 200, derived if left out]
    detail : group
        unevenness of the reef
        relief_m : number
            unevenness of reef flats and lagoon floors [m, 0 to 50, default 1]
        grooves_m : number
            depth of spurs and grooves on the windward fore reef, where cells resolve them [m, 0 to 50, default 3]
        groove_spacing_m : number
            distance from spur to spur [m, 1 to 5000, default 80]
    finish : group
        blur and range of the result
        blur_m : number
            blur of the result; 0: none [m, 0 to 100000, default 0]
        normalise : switch
            stretch the result to low_m ... high_m [default False]
        low_m : number
            lowest height after normalising [m, -12000 to 9000, default -250]
        high_m : number
            highest height after normalising [m, -12000 to 9000, default 250]
    
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
    aggregate : Field
        1 on the reef, 0 outside, soft at its edge
    labels : Labels
        reef, the lagoon behind it, land by height, abyss: the open sea
    outlines : Drawing
        the reef's outlines, as one area named reef
    """
    ...
