// Made by `seamount schema typescript`; see src/seamount/recipe/typescript.h.

/** x east, y north, metres. */
export type Point = [number, number];
export type Curve = Point[];
/** A colour as "#rrggbb". */
export type Colour = string;
export interface Stroke {
  points: Point[];
  width_m?: number;
  strength_m?: number;
}
export type PolarOutline = number | number[];
export type Polygon = Point[] | { outer: Point[]; holes?: Point[][] };
export type Region =
  | Point[]
  | { name?: string; ring: Point[]; height_m?: number | null; peak_m?: number | null; basin?: boolean };
export type River = Point[] | { points: Point[]; bed_m?: number[]; source_width_m?: number; mouth_width_m?: number };

export interface OperatorParams {
  /** A terrain from a file, in metres and square cells */
  "terrain.import": {
    /** GeoTIFF, HGT, ASC, PNG, EXR, R16, R32 or NPY file */
    file?: string;
    /** cell size, where the file does not say [m] */
    cell_m?: number | null;
    /** height of the lowest code of an 8- or 16-bit image [m] */
    low_m?: number | null;
    /** height of the highest code of an 8- or 16-bit image [m] */
    high_m?: number | null;
    /** give cells without data the heights that the rims of their holes lead to; otherwise they stay unknown */
    fill_voids?: boolean;
    /** band of a raster with several; 0: the first, unless they are colours */
    band?: number;
    /** how heights are held: numbers, or in the colours of web map tiles: terrarium, mapbox (Terrain-RGB) */
    coding?: "numbers" | "terrarium" | "mapbox";
    /** unit of the heights, such as feet, where the file says none or a wrong one */
    unit?: string;
    /** coordinate system, such as EPSG:4326, where the file says none or a wrong one; local: metres */
    crs?: string;
    /** which byte of a sample of a raw 16-bit file comes first: little, big */
    byte_order?: "little" | "big";
  };
  /** Neighbouring files of elevation as one terrain, cell by cell */
  "terrain.join": {
    /** neighbouring files that say where they lie; where they overlap the first counts */
    files?: string[];
    /** height of the lowest code of 8- or 16-bit images [m] */
    low_m?: number | null;
    /** height of the highest code of 8- or 16-bit images [m] */
    high_m?: number | null;
    /** give cells without data the heights that the rims of their holes lead to; otherwise they stay unknown */
    fill_voids?: boolean;
    /** how heights are held: numbers, or in the colours of web map tiles: terrarium, mapbox (Terrain-RGB) */
    coding?: "numbers" | "terrarium" | "mapbox";
    /** unit of the heights, such as feet, where the files say none or a wrong one */
    unit?: string;
    /** coordinate system, such as EPSG:4326, where the files say none or a wrong one; local: metres */
    crs?: string;
  };
  /** Fractal noise: mountains with valleys, smooth or ridged */
  "terrain.noise": {
    /** smooth: rolling hills, half of them below base_m; ridged: sharp crests; mountains: land with valleys that run down its slopes */
    kind?: "smooth" | "ridged" | "mountains";
    /** height of the noise: about half the relief of smooth noise, all of it for the others; 400 by default, of mountains a quarter of the wavelength [m] */
    height_m?: number | null;
    /** size of the largest forms [m] */
    wavelength_m?: number;
    /** layers of detail, each of half the size */
    octaves?: number;
    /** height of each layer over that of the one before */
    gain?: number;
    /** height to which the noise is added [m] */
    base_m?: number;
  };
  /** A terrain at another cell size, or on the document's domain */
  "terrain.resample": {
    /** cell size over the terrain's own extent; if absent the terrain is brought to the document's domain [m] */
    cell_m?: number | null;
    /** to the domain: put the terrain's middle at the domain's middle; otherwise its coordinates count */
    centre?: boolean;
    /** stretches the terrain, width and height alike */
    scale?: number;
    /** what lies beyond the terrain: unknown, which later steps fill or respect; edge: its nearest cells */
    beyond?: "unknown" | "edge";
  };
  /** A plausible sea floor for elevation models of land, whose sea is 0 m everywhere */
  "terrain.sea_floor": {
    /** greatest depth, far from land [m] */
    depth_m?: number;
    /** slope of the floor at the coast, as a share of the land's */
    steepness?: number;
    /** least slope of the floor at the coast [deg] */
    min_slope_deg?: number;
    /** how far inland the slope of the land is measured [m] */
    shore_m?: number;
  };
  /** A terrain as the samples that game engines and tiles want, the outer ones on its edge */
  "terrain.samples": {
    /** square; whole: all of the terrain, as long as it is; tiles: all of it with its own cells, as whole tiles that share their border samples, the last ones padded with its edge */
    layout?: "square" | "whole" | "tiles";
    /** samples of a square's side, of the longer side of the whole, or of one tile; 0: the largest of `choices` that the terrain fills, the smallest if it fills none; without choices as many as it has */
    samples?: number;
    /** numbers to choose from where `samples` is 0 */
    choices?: number[];
    /** square, of a terrain that is none: crop takes the middle, pad keeps all and repeats its edge */
    fit?: "crop" | "pad";
  };
  /** Two terrains become one: mixed, the higher, the lower, added or subtracted, all over or by a mask */
  "terrain.blend": {
    /** mix: the second in place of the first; max, min: the higher, the lower; add, subtract: the second put on or carved out */
    mode?: "mix" | "max" | "min" | "add" | "subtract";
    /** how much of it is done; a mask is multiplied with it */
    strength?: number;
    /** max and min: how far the rounded result lies beyond both where they are equal; 0: a sharp crease [m] */
    smooth_m?: number;
  };
  /** Several terrains in one domain, moved, turned and scaled, with feathered seams */
  "terrain.compose": {
    /** where each terrain's middle goes; a single terrain is copied to every place; none: terrains lie where their coordinates put them */
    places?: Point[];
    /** how far each terrain is turned, counter-clockwise; missing ones are 0 [deg] */
    turns_deg?: number[];
    /** how much each terrain is scaled, width and height alike; missing ones are 1 */
    scales?: number[];
    /** how far each terrain is raised after scaling; missing ones are 0 [m] */
    raises_m?: number[];
    /** width of the seams; 0: cut sharply [m] */
    feather_m?: number;
    /** height of the plain on which all terrains lie; if absent such ground stays unknown, for learned.sketch to make [m] */
    outside_m?: number | null;
  };
  /** A part of a terrain around a place, its summit or its middle, where it lies */
  "terrain.crop": {
    /** extent from west to east [m] */
    width_m?: number;
    /** extent from south to north; by default the same [m] */
    height_m?: number | null;
    /** what is in the middle: the terrain's middle, its highest or its lowest cell */
    around?: "middle" | "highest" | "lowest";
    /** with y_m: the place in the middle instead, east [m] */
    x_m?: number | null;
    /** with x_m: the place in the middle, north [m] */
    y_m?: number | null;
    /** with latitude_deg: the place in the middle, on WGS 84; the terrain must have a coordinate system [deg] */
    longitude_deg?: number | null;
    /** with longitude_deg: the place in the middle [deg] */
    latitude_deg?: number | null;
  };
  /** A terrain with its detail taken off or exaggerated, all over or by a mask */
  "terrain.smooth": {
    /** size of what vanishes: deviation of the Gaussian [m] */
    radius_m?: number;
    /** 1 smooths wholly, 0 not at all; below 0 detail is exaggerated instead */
    strength?: number;
  };
  /** Slopes become treads and risers, as where hard beds lie in soft ones; erosion makes walls of them */
  "terrain.terrace": {
    /** mean height from tread to tread [m] */
    step_m?: number;
    /** 0 leaves the slope as it is, 1 makes treads level */
    flatness?: number;
    /** share of the slope that becomes the riser of a step */
    riser?: number;
    /** how much thicknesses of steps differ */
    variation?: number;
    /** how far a tread's height wanders from place to place [m] */
    wander_m?: number;
    /** over what distance it does [m] */
    wander_wavelength_m?: number;
  };
  /** Strokes of a pen raise, lower, smooth, flatten, slope, roughen the ground, and are erased */
  "terrain.sculpt": {
    /** what the pen does, one stroke after another */
    strokes?: (
      | {
          tool: "raise";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** how hard the pen was pressed at each point: share of what the stroke does; none: 1 */
          pressure?: number[];
          /** reach to either side, where the stroke ends [m] */
          radius_m?: number;
          /** 0: soft from the middle on; 1: the same all over, with a sharp edge */
          hardness?: number;
          /** what it adds in the middle of the stroke [m] */
          height_m?: number;
        }
      | {
          tool: "lower";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** how hard the pen was pressed at each point: share of what the stroke does; none: 1 */
          pressure?: number[];
          /** reach to either side, where the stroke ends [m] */
          radius_m?: number;
          /** 0: soft from the middle on; 1: the same all over, with a sharp edge */
          hardness?: number;
          /** what it takes off in the middle of the stroke [m] */
          depth_m?: number;
        }
      | {
          tool: "smooth";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** how hard the pen was pressed at each point: share of what the stroke does; none: 1 */
          pressure?: number[];
          /** reach to either side, where the stroke ends [m] */
          radius_m?: number;
          /** 0: soft from the middle on; 1: the same all over, with a sharp edge */
          hardness?: number;
          /** share of the detail that goes */
          strength?: number;
        }
      | {
          tool: "flatten";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** how hard the pen was pressed at each point: share of what the stroke does; none: 1 */
          pressure?: number[];
          /** reach to either side, where the stroke ends [m] */
          radius_m?: number;
          /** 0: soft from the middle on; 1: the same all over, with a sharp edge */
          hardness?: number;
          /** the height; the ground's where the stroke begins if absent [m] */
          height_m?: number | null;
          /** how far it goes in the middle of the stroke: 0 not at all, 1 all the way */
          strength?: number;
        }
      | {
          tool: "ramp";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** how hard the pen was pressed at each point: share of what the stroke does; none: 1 */
          pressure?: number[];
          /** reach to either side, where the stroke ends [m] */
          radius_m?: number;
          /** 0: soft from the middle on; 1: the same all over, with a sharp edge */
          hardness?: number;
          /** height where the stroke begins; the ground's there if absent [m] */
          start_m?: number | null;
          /** height where the stroke ends; the ground's there if absent [m] */
          end_m?: number | null;
          /** how far it goes in the middle of the stroke: 0 not at all, 1 all the way */
          strength?: number;
        }
      | {
          tool: "roughen";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** how hard the pen was pressed at each point: share of what the stroke does; none: 1 */
          pressure?: number[];
          /** reach to either side, where the stroke ends [m] */
          radius_m?: number;
          /** 0: soft from the middle on; 1: the same all over, with a sharp edge */
          hardness?: number;
          /** how far ground goes up or down where it goes furthest [m] */
          amplitude_m?: number;
          /** size of the largest forms; detail of half the size follows, and so on [m] */
          wavelength_m?: number;
        }
      | {
          tool: "erase";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** how hard the pen was pressed at each point: share of what the stroke does; none: 1 */
          pressure?: number[];
          /** reach to either side, where the stroke ends [m] */
          radius_m?: number;
          /** 0: soft from the middle on; 1: the same all over, with a sharp edge */
          hardness?: number;
          /** share of the earlier strokes that goes */
          strength?: number;
        }
    )[];
  };
  /** A field painted with a pen: a mask, a density, a hardness, where ground is to be made anew */
  "terrain.paint": {
    /** value where nothing is painted and no values come in */
    base?: number;
    /** where nothing is painted nothing is known, in place of `base`: for the levelset of learned.sketch */
    unknown?: boolean;
    /** what is painted, one stroke after another */
    strokes?: (
      | {
          tool: "brush";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** how hard the pen was pressed at each point: share of what the stroke does; none: 1 */
          pressure?: number[];
          /** reach to either side, where the stroke ends [m] */
          radius_m?: number;
          /** 0: soft from the middle on; 1: the same all over, with a sharp edge */
          hardness?: number;
          /** what is painted */
          value?: number;
          /** how much of what is there is covered in the middle: 0 nothing, 1 all */
          opacity?: number;
        }
      | {
          tool: "area";
          /** what is filled, at least one; an outline may cross itself */
          polygons?: Polygon[];
          /** what is painted */
          value?: number;
          /** how much of what is there is covered in the middle: 0 nothing, 1 all */
          opacity?: number;
          /** over which it fades beyond its edge [m] */
          feather_m?: number;
        }
      | {
          tool: "erase";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** how hard the pen was pressed at each point: share of what the stroke does; none: 1 */
          pressure?: number[];
          /** reach to either side, where the stroke ends [m] */
          radius_m?: number;
          /** 0: soft from the middle on; 1: the same all over, with a sharp edge */
          hardness?: number;
          /** share of the earlier strokes that goes */
          opacity?: number;
        }
    )[];
  };
  /** A soft selection by height, depth, slope, aspect, curvature, regions, drawn areas and lines, noise or any field */
  "terrain.mask": {
    /** what is selected; none: everything */
    criteria?: (
      | {
          tool: "height";
          /** lowest that is fully selected; no limit if absent [m] */
          low_m?: number | null;
          /** highest that is fully selected; no limit if absent [m] */
          high_m?: number | null;
          /** over which the selection fades beyond the limits [m] */
          falloff_m?: number;
          /** select the rest */
          invert?: boolean;
        }
      | {
          tool: "depth";
          /** least depth that is fully selected [m] */
          low_m?: number;
          /** greatest depth that is fully selected [m] */
          high_m?: number | null;
          /** over which the selection fades beyond the limits [m] */
          falloff_m?: number;
          /** select the rest */
          invert?: boolean;
        }
      | {
          tool: "slope";
          /** lowest that is fully selected; no limit if absent [deg] */
          low_deg?: number | null;
          /** highest that is fully selected; no limit if absent [deg] */
          high_deg?: number | null;
          /** over which the selection fades beyond the limits [deg] */
          falloff_deg?: number;
          /** smaller forms are not looked at [m] */
          scale_m?: number;
          /** select the rest */
          invert?: boolean;
        }
      | {
          tool: "aspect";
          /** bearing that the ground faces, clockwise from north [deg] */
          direction_deg?: number;
          /** width of the bearings that are fully selected [deg] */
          spread_deg?: number;
          /** over which the selection fades beyond the limits [deg] */
          falloff_deg?: number;
          /** slope below which ground faces nowhere more and more [deg] */
          level_deg?: number;
          /** smaller forms are not looked at [m] */
          scale_m?: number;
          /** select the rest */
          invert?: boolean;
        }
      | {
          tool: "curvature";
          /** along the line of fall (profile), along the contour (plan), or their mean */
          bend?: "profile" | "plan" | "mean";
          /** least curvature that is fully selected: above 0 ridges, below 0 hollows, 1 a radius of a kilometre [1/km] */
          low_per_km?: number;
          /** highest that is fully selected; no limit if absent [1/km] */
          high_per_km?: number | null;
          /** over which the selection fades beyond the limits [1/km] */
          falloff_per_km?: number;
          /** size of the forms that are looked at [m] */
          scale_m?: number;
          /** select the rest */
          invert?: boolean;
        }
      | {
          tool: "region";
          /** region of the label map to whose border the distance is measured */
          region?: "mountain" | "beach" | "lagoon" | "reef" | "abyss";
          /** least distance from the region that is fully selected, negative inside; no limit if absent [m] */
          low_m?: number | null;
          /** greatest distance; 0: the region itself [m] */
          high_m?: number;
          /** over which the selection fades beyond the limits [m] */
          falloff_m?: number;
          /** select the rest */
          invert?: boolean;
        }
      | {
          tool: "area";
          /** areas drawn here; none: those of the input 'drawing', or what its lines enclose */
          polygons?: Polygon[];
          /** name of the area in the drawing; empty: all of them */
          feature?: string;
          /** least distance from the border that is fully selected, negative inside; no limit if absent [m] */
          low_m?: number | null;
          /** greatest distance; 0: the areas themselves [m] */
          high_m?: number;
          /** feathering beyond the limits [m] */
          falloff_m?: number;
          /** select the rest */
          invert?: boolean;
        }
      | {
          tool: "line";
          /** a line drawn here; none: the lines of the input 'drawing' */
          points?: Point[];
          /** least distance that is fully selected; no limit if absent [m] */
          low_m?: number | null;
          /** greatest distance that is fully selected [m] */
          high_m?: number;
          /** over which the selection fades beyond the limits [m] */
          falloff_m?: number;
          /** select the rest */
          invert?: boolean;
        }
      | {
          tool: "noise";
          /** share of the ground that is selected, about */
          coverage?: number;
          /** 0: patches with sharp borders; 1: soft clouds */
          softness?: number;
          /** size of the largest patches [m] */
          wavelength_m?: number;
          /** layers of detail, each of half the size */
          octaves?: number;
          /** strength of each layer over the one before */
          gain?: number;
          /** select the rest */
          invert?: boolean;
        }
      | {
          tool: "value";
          /** least value of the input 'values' that is fully selected */
          low?: number | null;
          /** greatest value that is fully selected */
          high?: number | null;
          /** over which the selection fades beyond the limits */
          falloff?: number;
          /** select the rest */
          invert?: boolean;
        }
    )[];
    /** how criteria are combined: product or min where all must hold, max where any */
    combine?: "product" | "min" | "max";
    /** select what would not be */
    invert?: boolean;
    /** value of ground that is not selected; low 1 and high 10 make a hardness for erosion.run */
    low?: number;
    /** value of ground that is selected; soft edges lie between */
    high?: number;
  };
  /** How much of each place is low, middle and high ground: three masks that sum to one */
  "terrain.layers": {
    /** height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as the style asks [m] */
    low_m?: number | null;
    /** height above low_m over which the low layer fades; by default 0.1 of the relief [m] */
    low_error_m?: number | null;
    /** height from which the high layer takes over; by default 0.5 of the relief [m] */
    high_m?: number | null;
    /** height below high_m over which the high layer fades in; by default 0.05 of the relief [m] */
    high_error_m?: number | null;
    /** layers fade in and out softly; off: linearly, as in the paper */
    smooth?: boolean;
    /** how far borders stray from one height, by noise and on steep ground, which is more of the middle layer */
    variation?: number;
  };
  /** An island from its outlines (drawn, polar, a real coastline, painted labels, or a random one) and its profile */
  "island.build": {
    /** values that belong together, by a word; what is stated besides wins */
    preset?: "hotspot" | "high" | "old";
    /** coastline to build on: areas or closed lines in a GeoJSON, GeoPackage, Shapefile or SVG, or a painted label image (.png) */
    coast?: string;
    /** name of the feature in the coast file; empty: all of them */
    feature?: string;
    /** layer of the coast file; empty: the first with areas, else with lines */
    layer?: string;
    /** coordinate system of the coast file where it says none or a wrong one: EPSG:32627, or local for metres */
    crs?: string;
    /** polar outlines around the centre: the coast alone, or mountain, beach, lagoon, reef, abyss [m] */
    outlines?: PolarOutline[];
    /** drawn polygons of the coast */
    areas?: Polygon[];
    /** centre of polar outlines and of random islands */
    centre?: Point;
    /** how much the coast of a random island departs from a circle */
    irregularity?: number;
    /** height of the highest summit, to the metre; derived from the land's width if absent [m] */
    peak_m?: number | null;
    /** height of the sea floor; derived if absent [m] */
    floor_m?: number | null;
    /** summits with their heights; lobes of the land without one have their own, as high as their width lets them be */
    summits?: {
      /** where it stands, on land */
      place?: Point;
      /** height of the summit; that of an island as wide as the land around it if absent [m] */
      height_m?: number | null;
      /** share of the summit's height over 0 (the summit) to 1 (foot of the mountains): a cone, a plateau, a crater; that of the island if empty */
      profile?: Curve;
    }[];
    /** how unevenly the mountains rise: 0 smooth cones, 1 several massifs */
    massif?: number;
    /** depth of the valleys that run down the slopes */
    relief?: number;
    /** height over the region coordinate 0 (summit) to 5 (sea floor); derived from peak_m and floor_m if empty [m] */
    profile?: Curve;
    /** how the profile runs between its knots */
    interpolation?: "monotone_cubic" | "linear";
    /** widths of the regions around the mountains, where the plan is one coast */
    widths?: {
      /** width of the beach, inside the coast; derived from the land's area if absent [m] */
      beach_m?: number | null;
      /** width of the lagoon; derived if absent [m] */
      lagoon_m?: number | null;
      /** width of the reef; derived if absent [m] */
      reef_m?: number | null;
      /** width of the slope down to the sea floor; derived if absent [m] */
      slope_m?: number | null;
    };
    /** forms smaller than the plan and the profile say */
    detail?: {
      /** size of bays and headlands below what the plan shows; none on drawn coasts if absent [m] */
      coast_m?: number | null;
      /** distance between the largest valleys; derived if absent [m] */
      valley_spacing_m?: number | null;
      /** how uneven beach, lagoon and reef are along the coast, wide in bays, narrow off headlands, where the plan is one coast */
      width_variation?: number;
      /** how much creases between far parts of the outlines are softened */
      smoothing?: number;
      /** height of the fine noise [m] */
      noise_m?: number;
      /** size of the largest bumps of the fine noise [m] */
      noise_wavelength_m?: number;
    };
  };
  /** Pushes an island out of its symmetry along strokes of wind and waves, terrain and labels together */
  "island.wind": {
    /** strokes of wind: points, width_m (deviation of the falloff), strength_m (displacement on the stroke) */
    strokes?: Stroke[];
    /** share of the displacement that is withheld, over the region coordinate 0 (summit) to 5 (sea floor) */
    resistance?: Curve;
    /** radial strokes from the centre outwards, landward and seaward in turn */
    radial_count?: number;
    /** width of the radial strokes [m] */
    radial_width_m?: number;
    /** displacement on the radial strokes [m] */
    radial_strength_m?: number;
    /** centre of the radial strokes */
    centre?: Point;
  };
  /** Sinks an island and grows its reef: fringing reef, barrier reef, atoll */
  "island.coral": {
    /** share of its height over the sea floor by which the island has sunk */
    subsidence?: number;
    /** bearing from which the swell comes [deg] */
    swell_from_deg?: number;
    /** how much the reef differs to windward, narrow, high and with long islets, and to leeward */
    exposure?: number;
    /** channels through the reef, the first off the largest rivers; -1: one for 16 km of reef, at least two */
    passes?: number;
    /** width of a pass [m] */
    pass_width_m?: number;
    /** depth of a pass [m] */
    pass_depth_m?: number;
    /** height of patch reefs and hollows on the lagoon's floor [m] */
    lagoon_relief_m?: number;
    /** share of the reef that carries islets of sand */
    islets?: number;
    /** height of the islets [m] */
    islet_m?: number;
    /** how much the smooth maximum of island and reef exceeds both where they are equal [m] */
    blend_m?: number;
    /** height that does not sink; the lowest of the terrain if absent [m] */
    floor_m?: number | null;
    /** label what has sunk below the sea and the deep back reef as lagoon, and beaches along the new coast */
    relabel?: boolean;
    /** heights across the reef */
    section?: {
      /** height of the reef crest [m] */
      crest_m?: number;
      /** height of the back reef and of the lagoon's floor [m] */
      back_m?: number;
      /** height at the foot of the fore reef [m] */
      abyss_m?: number;
      /** where the back reef starts across the reef (0: inner border, 1: outer border) */
      back_start?: number;
      /** where the back reef ends and rises to the crest */
      back_end?: number;
      /** where the crest starts */
      crest_start?: number;
      /** where the crest ends and the fore reef falls */
      crest_end?: number;
      /** where the fore reef reaches abyss_m */
      abyss_start?: number;
      /** slope on which the fore reef goes on beyond the reef; 0: stays at abyss_m [deg] */
      fore_reef_slope_deg?: number;
    };
  };
  /** Several islands, or copies of one, in one sea */
  "island.archipelago": {
    /** where each island's centre goes; a single island is copied to every place; none: islands stay where they are */
    places?: Point[];
    /** how far each island is turned, counter-clockwise; missing ones are 0 [deg] */
    turns_deg?: number[];
    /** how much each island is scaled, width and height of its land alike; reefs keep their depths; missing ones are 1 */
    scales?: number[];
    /** how much the smooth maximum exceeds two islands where they are equal [m] */
    blend_m?: number;
  };
  /** Traces the outlines of a label map, as island.build reads them */
  "island.outlines": {
    /** how far simplified outlines may lie from the traced ones; 0: one quarter cell [m] */
    tolerance_m?: number;
    /** parts and holes smaller than this are left out [m2] */
    min_area_m2?: number;
  };
  /** Grows nested regions into a network whose nodes know in which order they rise, without basins */
  "contour.grow": {
    /** nested regions, each with a name, a ring, the height of its outline if wanted, and whether it is a basin [m] */
    outlines?: Region[];
    /** the regions instead as a GeoJSON, GeoPackage, Shapefile or SVG, or as a picture whose grey levels are nested regions */
    regions?: string;
    /** only the areas of this name in the file `regions` */
    feature?: string;
    /** layer of the file `regions`; empty: the first with areas or lines */
    layer?: string;
    /** field of the file `regions` with the heights of outlines; empty: one named like a height */
    height_field?: string;
    /** coordinate system of the file `regions` where it says none or a wrong one: EPSG:32627, or local for metres */
    crs?: string;
    /** rivers from source to mouth, each with its bed at all points, at source and mouth, at the mouth, or none, and the width of its valley floor */
    rivers?: River[];
    /** the darkest grey of a picture is the lowest region instead of the world outside */
    darkest_is_land?: boolean;
    /** detail given to outlines drawn with few points: round corners, bays and headlands smaller than their sides; 0 keeps every point; absent: 0.4 where `outlines` are given, else 0 */
    irregularity?: number | null;
    /** least distance between nodes; absent: what gives `particles` [m] */
    spacing_m?: number | null;
    /** number of nodes in the regions, within a few per cent; more where regions are too small for so few */
    particles?: number;
    /** where growth runs ahead and cuts valleys: uniform: nowhere, rings that follow the outline; noise: along fractal noise; the input 'probability' replaces it */
    probability?: "uniform" | "noise";
    /** the probability as a picture laid over the domain, black 0 to white 1 */
    probability_picture?: string;
    /** size of the noise's largest forms; absent: a third of the regions' size [m] */
    feature_m?: number | null;
    /** layers of detail of the noise, each of half the size */
    octaves?: number;
    /** power to which probabilities are raised: higher values carve narrower, deeper valleys */
    exponent?: number;
  };
  /** Heights for a grown network from a distribution of heights, through outlines of given height */
  "contour.heights": {
    /** distribution of heights that makes such a landform */
    landform?: "mountain" | "uniform" | "hills" | "plateau" | "coastal" | "volcano" | "canyon";
    /** instead: how much ground lies at each height, in equal steps from lowest to highest */
    histogram?: number[];
    /** instead: a drawn density of heights, x from 0 (lowest) to 1 (highest) */
    density?: Curve;
    /** lowest height; derived: the terrain's, else the lowest outline's, else 0 [m] */
    min_m?: number | null;
    /** highest height; derived: the terrain's, else a twelfth of the land's width above the highest outline [m] */
    max_m?: number | null;
    /** measure only the terrain's cells from this height up; derived: all [m] */
    measure_above_m?: number | null;
    /** by_size: wider ground rises higher; equal: every summit reaches the top */
    summits?: "by_size" | "equal";
    /** follow: contours at their heights follow the outlines; loose: as the growth is */
    outlines?: "follow" | "loose";
    /** cut: ground far steeper than the rest is cut back to a slope; keep: every height of the distribution stays where the growth has it */
    spikes?: "cut" | "keep";
    /** depth of basins below their outlines; derived: half way down to the next outline, less in narrow ones [m] */
    basin_depth_m?: number | null;
    /** how steeply the sea floor falls away from the coast, ever less below 1200 m [deg] */
    shore_slope_deg?: number;
  };
  /** Makes a network finer pass by pass, between its own contours, which keep their places and heights */
  "contour.refine": {
    /** how often the spacing shrinks, by the same factor */
    passes?: number;
    /** least distance between nodes at the end; absent: each pass halves it [m] */
    spacing_m?: number | null;
    /** heights whose contours the first pass holds, besides the given outlines; each further pass doubles them; 0: as many as lie five spacings apart. Many keep the coarse layout, few leave room for detail */
    contours?: number;
    /** detail that contours of coarse triangles are given; 0: they are only smoothed */
    roughness?: number;
    /** where growth runs ahead and cuts valleys between the contours; the input 'probability' replaces it */
    probability?: "uniform" | "noise";
    /** size of the noise's largest forms, one a pass, the last for all further ones; none: twelve times the spacing that the pass refines [m] */
    feature_m?: number[];
    /** power to which probabilities are raised, one a pass as well: higher values carve narrower valleys */
    exponent?: number[];
    /** layers of detail of the noise, each of half the size */
    octaves?: number;
    /** the rivers that the network was grown with, laid into each pass again */
    rivers?: River[];
    /** how steeply the sea floor falls away from the coast, ever less below 1200 m [deg] */
    shore_slope_deg?: number;
  };
  /** Edits contours by a list of tools that can be replayed; they never come to cross */
  "contour.edit": {
    /** the tools, in the order of their use */
    edits?: (
      | {
          tool: "warp";
          /** points of the stroke, at least two; a spline runs through them */
          stroke?: Point[];
          /** radius of the disc that is dragged along the stroke [m] */
          radius_m?: number;
          /** 1 carries what lies at the stroke's beginning to its end, 0 moves nothing */
          strength?: number;
          /** how narrow the drag is across the disc: (4x(1-x))^k */
          k?: number;
          /** drag across the disc from rim (0) to rim (1), in place of k: 0 at both, above 0 in the middle */
          profile?: Curve;
          /** length of the steps of the drag; at most 0.5, 0.64, 0.58 radii for k = 1, 2, 3; half that if derived [m] */
          step_m?: number | null;
        }
      | {
          tool: "slope";
          /** points of the curve; one alone works about a point */
          stroke?: Point[];
          /** reach on both sides of the curve [m] */
          radius_m?: number;
          /** above 0 steeper along the curve, below 0 gentler */
          strength?: number;
          /** how narrow the ring is that gives way: (4x(1-x))^k */
          k?: number;
        }
      | {
          tool: "smooth";
          /** the contours to smooth; all unless said */
          select?: {
            /** heights from here on [m] */
            low_m?: number | null;
            /** heights up to here [m] */
            high_m?: number | null;
            /** enclosed areas from here on [m2] */
            min_area_m2?: number | null;
            /** enclosed areas up to here [m2] */
            max_area_m2?: number | null;
            /** those that lie wholly in one of these polygons */
            within?: Polygon[];
            /** the contour nearest to each of these places */
            at?: Point[];
            /** these, by their number in the set, from 0 */
            index?: number[];
            /** and everything that lies inside a contour so found */
            inner?: boolean;
          };
          /** arc to either side that is averaged [m] */
          radius_m?: number;
          /** share of the way to the mean */
          strength?: number;
          /** how often */
          rounds?: number;
        }
      | {
          tool: "fractalize";
          /** where; everywhere unless said */
          within?: Polygon[];
          /** displacement by the longest wavelength [m] */
          amplitude_m?: number;
          /** longest wavelength; each octave halves it [m] */
          wavelength_m?: number;
          /** how many wavelengths */
          octaves?: number;
          /** displacement by an octave over that by the one before */
          gain?: number;
          /** over which it fades to nothing at the border [m] */
          fade_m?: number;
        }
      | {
          tool: "delete";
          /** the contours to remove; something must be said */
          select?: {
            /** heights from here on [m] */
            low_m?: number | null;
            /** heights up to here [m] */
            high_m?: number | null;
            /** enclosed areas from here on [m2] */
            min_area_m2?: number | null;
            /** enclosed areas up to here [m2] */
            max_area_m2?: number | null;
            /** those that lie wholly in one of these polygons */
            within?: Polygon[];
            /** the contour nearest to each of these places */
            at?: Point[];
            /** these, by their number in the set, from 0 */
            index?: number[];
            /** and everything that lies inside a contour so found */
            inner?: boolean;
          };
        }
      | {
          tool: "copy";
          /** the outline: one polygon */
          within?: Polygon[];
          /** in place of it: one contour, with all that lies inside it */
          select?: {
            /** heights from here on [m] */
            low_m?: number | null;
            /** heights up to here [m] */
            high_m?: number | null;
            /** enclosed areas from here on [m2] */
            min_area_m2?: number | null;
            /** enclosed areas up to here [m2] */
            max_area_m2?: number | null;
            /** those that lie wholly in one of these polygons */
            within?: Polygon[];
            /** the contour nearest to each of these places */
            at?: Point[];
            /** these, by their number in the set, from 0 */
            index?: number[];
            /** and everything that lies inside a contour so found */
            inner?: boolean;
          };
        }
      | {
          tool: "cut";
          /** the outline: one polygon */
          within?: Polygon[];
          /** in place of it: one contour, with all that lies inside it */
          select?: {
            /** heights from here on [m] */
            low_m?: number | null;
            /** heights up to here [m] */
            high_m?: number | null;
            /** enclosed areas from here on [m2] */
            min_area_m2?: number | null;
            /** enclosed areas up to here [m2] */
            max_area_m2?: number | null;
            /** those that lie wholly in one of these polygons */
            within?: Polygon[];
            /** the contour nearest to each of these places */
            at?: Point[];
            /** these, by their number in the set, from 0 */
            index?: number[];
            /** and everything that lies inside a contour so found */
            inner?: boolean;
          };
        }
      | {
          tool: "paste";
          /** pattern to paste, as contour.pattern makes it; else what was copied, else the input */
          file?: string;
          /** where the middle of the pattern comes to lie, in metres; the other ways to say it follow */
          at?: Point | null;
          /** without a place: the middle of the domain, or within the highest contour */
          on?: "middle" | "highest";
          /** with latitude_deg: where, on WGS 84; the contours must have a coordinate system [deg] */
          longitude_deg?: number | null;
          /** with longitude_deg: where [deg] */
          latitude_deg?: number | null;
          /** turn, counter-clockwise [deg] */
          rotation_deg?: number;
          /** horizontal scale */
          scale?: number;
          /** vertical scale; below 0: hollows for hills */
          height_scale?: number;
          /** added to the pattern's heights [m] */
          raise_m?: number;
          /** width of the ring in which the two grounds blend; two fifths of the way to the middle if derived [m] */
          blend_m?: number | null;
        }
      | {
          tool: "fill";
          /** the outline: one polygon */
          within?: Polygon[];
          /** in place of it: one contour, whose inside is made anew */
          select?: {
            /** heights from here on [m] */
            low_m?: number | null;
            /** heights up to here [m] */
            high_m?: number | null;
            /** enclosed areas from here on [m2] */
            min_area_m2?: number | null;
            /** enclosed areas up to here [m2] */
            max_area_m2?: number | null;
            /** those that lie wholly in one of these polygons */
            within?: Polygon[];
            /** the contour nearest to each of these places */
            at?: Point[];
            /** these, by their number in the set, from 0 */
            index?: number[];
            /** and everything that lies inside a contour so found */
            inner?: boolean;
          };
          /** patterns to choose from for a polygon, as contour.pattern makes them; else these contours */
          files?: string[];
          /** range of heights over that of the surroundings */
          relief?: number;
          /** size of the largest landforms [m] */
          wavelength_m?: number;
        }
    )[];
    /** of an edit that would make contours cross: limit its strength and say so, or refuse it */
    on_crossing?: "limit" | "refuse";
  };
  /** The contours within an outline as a small drawing, to be stored and pasted elsewhere */
  "contour.pattern": {
    /** the outline: one polygon; the whole domain unless said */
    within?: Polygon[];
    /** in place of it: one contour, with all that lies inside it */
    select?: {
      /** heights from here on [m] */
      low_m?: number | null;
      /** heights up to here [m] */
      high_m?: number | null;
      /** enclosed areas from here on [m2] */
      min_area_m2?: number | null;
      /** enclosed areas up to here [m2] */
      max_area_m2?: number | null;
      /** those that lie wholly in one of these polygons */
      within?: Polygon[];
      /** the contour nearest to each of these places */
      at?: Point[];
      /** these, by their number in the set, from 0 */
      index?: number[];
      /** and everything that lies inside a contour so found */
      inner?: boolean;
    };
  };
  /** Areas, lines and points from a file, in metres */
  "drawing.import": {
    /** GeoJSON, GeoPackage, Shapefile or SVG file */
    file?: string;
    /** layer of a file with several; empty: the first that fits */
    layer?: string;
    /** only the features of this name, in any letter case; empty: all */
    feature?: string;
    /** field with the heights; empty: one named like a height, else z */
    height_field?: string;
    /** coordinate system of a file that says none or a wrong one: EPSG:32627, or local for metres on no map */
    crs?: string;
  };
  /** Contours from a file of lines with heights, open ones closed at the sheet's border */
  "contour.import": {
    /** GeoJSON, GeoPackage, Shapefile or SVG file */
    file?: string;
    /** layer of a file with several; empty: the first that fits */
    layer?: string;
    /** only the features of this name, in any letter case; empty: all */
    feature?: string;
    /** field with the heights; empty: one named like a height, else z */
    height_field?: string;
    /** coordinate system of a file that says none or a wrong one: EPSG:32627, or local for metres on no map */
    crs?: string;
  };
  /** The contours of a network or of a terrain, closed and nested */
  "contour.extract": {
    /** heights of the contours; none: see interval_m [m] */
    levels_m?: number[];
    /** height between contours, counted from base_m; absent: see count [m] */
    interval_m?: number | null;
    /** a height that would have a contour [m] */
    base_m?: number;
    /** number of heights, evenly over the range, where neither levels_m nor interval_m is given */
    count?: number;
    /** points are dropped that lie no further than this from the rest; 0: all are kept [m] */
    simplify_m?: number;
    /** smaller contours are left out, with all that they enclose [m2] */
    min_area_m2?: number;
    /** the same for shorter ones [m] */
    min_length_m?: number;
  };
  /** A terrain from its contours or from a network, at any resolution */
  "contour.reconstruct": {
    /** smooth; interpolated: straight between the two nearest contours; stairs: level between contours. A network is interpolated in its triangles */
    method?: "smooth" | "interpolated" | "stairs";
    /** cell size of the terrain; the document's if absent [m] */
    cell_m?: number | null;
    /** how far summits may rise over the last contour and basins sink under it; 1: almost to the next one */
    summits?: number;
  };
  /** Grows barrier reefs, ribbon reefs and patch reefs by diffusion-limited aggregation */
  "reef.grow": {
    /** cell of the lattice on which particles walk and settle; if absent 70, or the terrain's cells or 1 / 2048 of it where those are larger [m] */
    lattice_m?: number | null;
    /** particles to shoot; 0: one for 8 cells of wide habitat, one for 2 along its rim */
    particles?: number;
    /** how far particles, radii and outlines depart from the lattice */
    irregularity?: number;
    /** bearing from which the swell comes [deg] */
    swell_from_deg?: number;
    /** water behind passes up to this width is labelled lagoon; 2 kernel radii if absent [m] */
    lagoon_gap_m?: number | null;
    /** where growth starts */
    starts?: {
      /** places where growth starts; without any start each separate piece of habitat has one [m] */
      points?: Point[];
      /** a line along which growth starts, such as a shelf edge [m] */
      line?: Point[];
      /** growth starts along the contour at this height [m] */
      contour_m?: number | null;
      /** share of lines where growth starts; the rest are passes */
      line_cover?: number;
      /** length of a stretch of line with its pass [m] */
      segment_m?: number;
      /** number of random places of the habitat, or of the input 'start': many small reefs, few large */
      random?: number;
    };
    /** where particles may settle */
    bounds?: {
      /** depth at which a tenth of the light is left, which corals need: 60 in the clearest ocean, 40 in clear water, 25 over shelves, 10 off muddy rivers [m] */
      light_depth_m?: number;
      /** no growth where the ground is lower; if absent, below light_depth_m (heights.mode proportional: none) [m] */
      low_m?: number | null;
      /** no growth where the ground is higher; if absent, the sea's surface (heights.mode proportional: none) [m] */
      high_m?: number | null;
      /** no growth this near to the terrain's edge, in bays up to twice that; 3 kernel radii if absent [m] */
      margin_m?: number | null;
    };
    /** how particles come to the reef */
    walk?: {
      /** chance to settle at a touch; low values give thick, rounded reefs */
      stickiness?: number;
      /** where walks start: on a ring around the reef, or anywhere on the lattice */
      launch?: "ring" | "anywhere";
      /** how strongly currents carry the particles */
      current?: number;
      /** bearing to which currents flow [deg] */
      current_to_deg?: number;
      /** steps after which a walk is given up */
      max_steps?: number;
    };
    /** shape of the reef around each particle */
    kernel?: {
      /** radius of the kernels around particles; 1.465 lattice_m if absent, as in P4 [m] */
      radius_m?: number | null;
      /** how kernels go together: as one united outline, or summed (P4) */
      combine?: "union" | "sum";
      /** exponent of the normal kernel: steepness of the sides of the aggregate and of summed reefs */
      k?: number;
      /** the rim lies 1 / k1 of the radius inside the edge */
      k1?: number;
      /** random share of k1, which makes the rim uneven */
      k1_jitter?: number;
      /** exponent of the log-normal kernel: how squarely the rim stands; 10 in P4 */
      k2?: number;
    };
    /** how far the reef lifts the ground */
    heights?: {
      /** saturating: up to the sea's surface; proportional: to the base over datum_m (P4) */
      mode?: "saturating" | "proportional";
      /** height at which the normal lift saturates: the reef flat [m] */
      flat_m?: number;
      /** height at which the rim saturates: the reef crest [m] */
      crest_m?: number;
      /** height by which a reef lifts the ground at most (saturating) [m] */
      lift_m?: number;
      /** height that the edge kernel lifts the rim (saturating) [m] */
      rim_m?: number;
      /** share of the rim's height that is left in the lee of the swell */
      lee_rim?: number;
      /** slope of the fore reef to windward (saturating, union) [deg] */
      fore_slope_deg?: number;
      /** slope of the reef's side in the lee [deg] */
      lee_slope_deg?: number;
      /** width of the flat to windward, half of that in the lee; behind it wide reefs hold a lagoon [m] */
      flat_width_m?: number;
      /** weight of the base terrain over datum_m */
      w0?: number;
      /** weight of the normal kernels */
      w1?: number;
      /** weight of the log-normal kernels at the edge */
      w2?: number;
      /** the zero of P4's heights: w0 and proportional lifts count from it [m] */
      datum_m?: number;
    };
    /** lagoons and cays */
    sand?: {
      /** floor of lagoons within wide or crowded reefs [m] */
      lagoon_m?: number;
      /** how far sand fills the water between reefs, up to lagoon_m */
      fill?: number;
      /** patch reefs on the floors of lagoons, many small and few large [1/km2] */
      knolls_per_km2?: number;
      /** islets of sand on the lee of flats; wide ones carry plants */
      cays?: number;
      /** height of the larger islets [m] */
      cay_m?: number;
    };
    /** ways from lagoons to the open sea */
    passes?: {
      /** lagoons at least this large have a pass to the open sea (saturating) [km2] */
      least_km2?: number;
      /** length of barrier for one pass: longer ones have more [m] */
      spacing_m?: number;
      /** width of passes; if absent 100 to 1000 by the size of the lagoon [m] */
      width_m?: number | null;
      /** depth of passes, never below the ground on which the reef stands; if absent 10 to 60 by the size of the lagoon [m] */
      depth_m?: number | null;
    };
    /** unevenness of the reef */
    detail?: {
      /** unevenness of reef flats and lagoon floors [m] */
      relief_m?: number;
      /** depth of spurs and grooves on the windward fore reef, where cells resolve them [m] */
      grooves_m?: number;
      /** distance from spur to spur [m] */
      groove_spacing_m?: number;
    };
    /** blur and range of the result */
    finish?: {
      /** blur of the result; 0: none [m] */
      blur_m?: number;
      /** stretch the result to low_m ... high_m */
      normalise?: boolean;
      /** lowest height after normalising [m] */
      low_m?: number;
      /** highest height after normalising [m] */
      high_m?: number;
    };
  };
  /** A terrain without depressions: filled to their outlets, or breached; and the lakes */
  "hydrology.fill": {
    /** fill: raise them to their outlets; breach: cut the cheapest way out */
    depressions?: "fill" | "breach";
    /** let filled ground fall towards its outlet by the least step that a float can make */
    descend?: boolean;
    /** flow ends in cells at or below sea level; otherwise only at the terrain's edge */
    sea?: boolean;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
    /** breach: deepest cut; what needs more is filled [m] */
    max_cut_m?: number;
    /** breach: longest cut; what needs more is filled [m] */
    max_length_m?: number;
    /** smaller lakes are not traced [m2] */
    min_lake_m2?: number;
  };
  /** Lakes as a climate leaves them, with outlet and without: inflow against evaporation */
  "hydrology.lakes": {
    /** rain on dry ground that runs off, in a year; the input runoff says it for each cell [mm/yr] */
    runoff_mm_yr?: number;
    /** rain that falls on a lake in a year [mm/yr] */
    rain_mm_yr?: number;
    /** what a lake's surface loses to the air in a year: 600 in cool, 1200 in temperate dry, 2500 in hot dry places; 0 fills all lakes to their outlets [mm/yr] */
    evaporation_mm_yr?: number;
    /** depressions that are less deep count as roughness of the ground, full and without a lake [m] */
    min_depth_m?: number;
    /** smaller lakes are not traced [m2] */
    min_lake_m2?: number;
    /** flow ends in cells at or below sea level; otherwise only at the terrain's edge */
    sea?: boolean;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
  };
  /** Where water runs and how much gathers: one neighbour, two or all (D8, D-infinity, multiple) */
  "hydrology.flow": {
    /** d8: to the steepest neighbour; dinf: between two; mfd: over all that are lower */
    method?: "d8" | "dinf" | "mfd";
    /** mfd: shares go with slope to this power; higher gathers more */
    exponent?: number;
    /** flow ends in cells at or below sea level; otherwise only at the terrain's edge */
    sea?: boolean;
    /** smaller catchments are not traced; a five-hundredth of the terrain's area if absent [m2] */
    min_catchment_m2?: number | null;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
  };
  /** The river network as lines with stream order, discharge and width */
  "hydrology.rivers": {
    /** catchment with which a river begins; a five-hundredth of the land if absent [m2] */
    min_area_m2?: number | null;
    /** rain that runs off, in a year [mm/yr] */
    runoff_mm_yr?: number;
    /** width in metres of a river of 1 m3/s; it goes with the square root of discharge */
    width_factor?: number;
    /** flow ends in cells at or below sea level; otherwise only at the terrain's edge */
    sea?: boolean;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
  };
  /** The network of ridges as lines: the rivers of the inverted terrain */
  "hydrology.ridges": {
    /** ground whose ways up join before a ridge begins; a five-hundredth of the land if absent [m2] */
    min_area_m2?: number | null;
    /** ridges stand on cells above sea level; otherwise everywhere */
    sea?: boolean;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
  };
  /** What a terrain is like in numbers and curves, and how far it is from a reference */
  "hydrology.describe": {
    /** describe only what lies above sea level */
    sea?: boolean;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
    /** side of the square of local relief [m] */
    relief_window_m?: number;
    /** catchment with which a river, or a ridge, begins; a 2000th of the smaller land if absent [m2] */
    channel_m2?: number | null;
    /** least prominence of a peak; a 50th of the reference's relief if absent [m] */
    min_prominence_m?: number | null;
    /** cell size at which both are compared, no finer than theirs; the coarser of these if absent [m] */
    cell_m?: number | null;
    /** name of the terrain on the page */
    title?: string;
    /** name of the reference on the page */
    reference_title?: string;
  };
  /** Years of rivers, slides, creep and waves on bedrock, debris and sediment; or a range that rises and wears */
  "erosion.run": {
    /** values that belong together, by a word; what is stated besides wins */
    preset?: "young" | "mature" | "old" | "desert";
    /** hydraulic: rivers that also deposit, weathering, waves; stream_power: rivers that only cut, creep, failing slopes */
    method?: "hydraulic" | "stream_power";
    /** how long erosion acts [yr] */
    years?: number;
    /** rise of the land, times the input `uplift` [mm/yr] */
    uplift_mm_yr?: number;
    /** rain that runs off, times the input `rain` [mm/yr] */
    runoff_mm_yr?: number;
    /** K in K sqrt(discharge) slope, the metres per year that rivers cut into bedrock by their discharge in m3/yr; hard rock 1e-6, soft 1e-4, loose ground 1e-3 [1/sqrt(m yr)] */
    erodibility?: number;
    /** how much bedrock's hardness varies from place to place: v makes it up to (1 + v) / (1 - v) times as hard */
    hardness_variation?: number;
    /** level of the sea; far below the terrain for none [m] */
    sea_m?: number;
    /** what rivers carry and where they drop it */
    rivers?: {
      /** how readily rivers drop their load (G): 0 never, 1 as in most rivers, more fills valleys */
      deposition?: number;
      /** width over which rivers lay down their load where they leave their valleys: 0 narrow beds, more makes fans and aprons [m] */
      fan_m?: number;
      /** how much more easily rivers cut debris than bedrock */
      debris_ease?: number;
      /** how much more easily rivers cut fine sediment than bedrock */
      sediment_ease?: number;
      /** share of a river's water that is lost on a kilometre [1/km] */
      evaporation_per_km?: number;
      /** area that is drained without a channel [m2] */
      channel_m2?: number;
    };
    /** what slopes can stand and how they wear */
    slopes?: {
      /** steepest slope of bedrock, which joints vary with hardness_variation; rock four times as hard stands twice as steep [deg] */
      bedrock_angle_deg?: number;
      /** steepest slope of debris [deg] */
      debris_angle_deg?: number;
      /** steepest slope of fine sediment [deg] */
      sediment_angle_deg?: number;
      /** diffusivity of soil: rounds crests and spaces valleys; 0.001 dry to 0.05 wet [m2/yr] */
      creep_m2_yr?: number;
      /** bedrock that crumbles where it is bare and steep [mm/yr] */
      weathering_mm_yr?: number;
    };
    /** what waves do to the coast */
    coast?: {
      /** retreat of exposed cliffs [mm/yr] */
      retreat_mm_yr?: number;
      /** depth down to which waves move sediment [m] */
      wave_base_m?: number;
      /** distance over which most of a river's load settles in the sea [m] */
      settling_m?: number;
    };
    /** beds of harder and softer rock in three dimensions */
    lithology?: {
      /** beds of rock from the top down; none: rock without beds */
      beds?: {
        /** what the bed is called, for those who read the recipe */
        name?: string;
        /** thickness across the bed; beds of 0.1 to 10, caps of 10 to 100 [m] */
        thickness_m?: number;
        /** how many times as hard as `erodibility` says: shale 0.2 to 0.5, a cap 3 to 10; four times as hard stands twice as steep */
        hardness?: number;
      }[];
      /** the sequence repeats above and below; else its first and last bed have no end */
      repeat?: boolean;
      /** height of the first bed's top, before any uplift [m] */
      top_m?: number;
      /** where it has that height, east [m] */
      top_x_m?: number;
      /** where it has that height, north [m] */
      top_y_m?: number;
      /** tilt of the beds: mesas 0, cuestas 2 to 15, hogbacks over 30 [deg] */
      dip_deg?: number;
      /** bearing of level lines on the beds, clockwise from north; they dip to the right of it [deg] */
      strike_deg?: number;
      /** height of arches over troughs; 0: no folds [m] */
      fold_height_m?: number;
      /** from one arch to the next [m] */
      fold_wavelength_m?: number;
      /** bearing of arches and troughs; by default the strike [deg] */
      fold_axis_deg?: number | null;
      /** share by which beds thicken and thin from place to place */
      thickness_variation?: number;
      /** faults that have moved the beds */
      faults?: {
        /** line of the fault at the height `top_m`, at least two points; it goes on straight beyond its ends [m] */
        trace?: Point[];
        /** dip of the fault to the right of its trace [deg] */
        dip_deg?: number;
        /** how far the beds to the right of the trace have gone down; negative: up [m] */
        throw_m?: number;
      }[];
    };
  };
  /** The erosion of a coarse terrain carried on to smaller cells: valleys of the one, gullies and detail of the other, however large */
  "erosion.refine": {
    /** how long gullies cut into the slopes: 0 leaves them to the terrain's own detail [yr] */
    years?: number;
    /** share of the terrain's own detail, finer than the coarse cells, that stays where little was worn or laid down */
    detail?: number;
    /** depth of the gullies that run down bare slopes: 0 none, 1 as in old volcanic islands */
    gullies?: number;
    /** rain that runs off, as for erosion.run [mm/yr] */
    runoff_mm_yr?: number;
    /** K in K sqrt(discharge) slope, as for erosion.run [1/sqrt(m yr)] */
    erodibility?: number;
    /** area that is drained without a channel [m2] */
    channel_m2?: number;
    /** steepest slope over gullies and rivers [deg] */
    angle_deg?: number;
    /** diffusivity of soil: rounds crests [m2/yr] */
    creep_m2_yr?: number;
    /** level of the sea, below which nothing is cut; far below the terrain for none [m] */
    sea_m?: number;
    /** steps over which water gathers on the fine cells, rounded up to a power of two; some times as many as fine cells lie along a coarse one. Larger, slower */
    gather_cells?: number;
  };
  /** Ice that gathers over the equilibrium line, flows, and carves valleys and cirques */
  "glacier.run": {
    /** how long glaciers carve; 0 shows the ice on the terrain as it is [yr] */
    years?: number;
    /** equilibrium line: height above which more snow falls in a year than melts [m] */
    ela_m?: number;
    /** ice gained or lost per year for each kilometre over or under the equilibrium line; 3 dry, 7 Alps, 15 wet [m/yr/km] */
    balance_gradient_m_yr_km?: number;
    /** most ice that a year's snow makes [m/yr] */
    max_accumulation_m_yr?: number;
    /** metres of bed that are carved for each metre that ice slides; hard rock 1e-5, soft 1e-3 */
    abrasion?: number;
    /** how far to the sides of its fastest ice a glacier carves: floors of valleys become wide and flat [m] */
    widening_m?: number;
    /** steepest wall that stands over carved ground; what is steeper falls onto the ice [deg] */
    wall_angle_deg?: number;
  };
  /** The sketch of a terrain: coarse rivers and ridges, one pixel wide, and heights of peaks and basins */
  "sketch.extract": {
    /** cell size on which water runs; a 128th of the terrain's longer side if absent [m] */
    coarse_m?: number | null;
    /** deviation of the blur before it: how little of the detail is drawn; 0.7 coarse cells if absent [m] */
    blur_m?: number | null;
    /** ground whose rain makes a river, or a ridge; a 500th of the land if absent [m2] */
    min_area_m2?: number | null;
    /** ground whose rain ends in one place and makes it a cue; a 150th of the land if absent [m2] */
    cue_area_m2?: number | null;
    /** probability with which a drop leaves a local minimum */
    leave?: number;
    /** relief that is none: minima no deeper hold no water, and valleys and crests that stand out no more are not drawn; if absent, a 200th of all relief (for valleys and crests a twentieth of a coarse cell if less), at least a hundredth of a coarse cell (10 m at most) and two steps of rounded heights [m] */
    shallow_m?: number | null;
    /** shortest branch and piece that is kept, in coarse cells */
    min_length?: number;
    /** rivers end at sea level and ridges stand above it; otherwise the sea floor is ground as well */
    sea?: boolean;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
    /** draw rivers */
    rivers?: boolean;
    /** draw ridges */
    ridges?: boolean;
    /** draw peaks and basins with their heights */
    cues?: boolean;
  };
  /** The high part of a terrain as an area */
  "sketch.levelset": {
    /** share of the land that lies lower than the levelset [%] */
    percentile?: number;
    /** deviation of the blur before it; a 64th of the terrain's longer side if absent [m] */
    blur_m?: number | null;
    /** only what lies above sea level counts; otherwise the sea floor is ground as well */
    sea?: boolean;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
  };
  /** Terrain from a sketch of ridges, rivers, heights, high ground and known ground in any mix, by a network */
  "learned.sketch": {
    /** crest lines */
    ridges?: {
      /** the line's points */
      points?: Point[];
    }[];
    /** rivers, in any direction */
    rivers?: {
      /** the line's points */
      points?: Point[];
    }[];
    /** places whose height is given: summits, basins, passes */
    heights?: {
      /** east of the domain's middle, or in its system [m] */
      x_m?: number;
      /** north of it [m] */
      y_m?: number;
      /** height of the ground there [m] */
      height_m?: number;
    }[];
    /** height of the low ground; if absent, the lowest that is drawn or known, or, where that is near the highest, two fifths of a usual relief below it (of the highest itself if less); 0 where nothing has a height [m] */
    low_m?: number | null;
    /** how far high ground rises above it; if absent, as heights and known ground say, else what is usual for mountains of the domain's width [m] */
    relief_m?: number | null;
    /** how closely what is drawn is met: 1 heights exactly, and lines carved and sharpened a little; 0 as the network sees fit */
    adherence?: number;
    /** network: a shipped one by its word, or a file of weights (safetensors) */
    model?: string;
    /** of the network's sums */
    precision?: "automatic" | "f32" | "bf16";
  };
  /** Island terrain from a map of its regions, painted or made, by a network */
  "learned.island": {
    /** picture over the domain in the colours of regions: mountain yellow, beach green, lagoon cyan, reef blue, abyss red; the darker, the more it has sunk */
    painting?: string;
    /** how far the island has sunk, where no painting and no field says */
    subsidence?: number;
    /** size of everything, heights too, against islands shown on 20 km; if absent, the domain's longer side over 20 km, at most 1 */
    scale?: number | null;
    /** height of the highest summit, met exactly; if absent, as the network sees fit [m] */
    peak_m?: number | null;
    /** height of the deepest sea floor, a two hundredth of it aside; if absent, as the network sees fit [m] */
    floor_m?: number | null;
    /** depth of the reef's crest where nothing has sunk; if absent, as the network sees fit [m] */
    reef_depth_m?: number | null;
    /** strokes of wind and waves along which the map is bent first, as island.wind does: points, width_m (deviation of the falloff), strength_m (displacement on the stroke) */
    strokes?: Stroke[];
    /** network: a shipped one by its word, or a file of weights (safetensors) */
    model?: string;
    /** of the network's sums */
    precision?: "automatic" | "f32" | "bf16";
  };
  /** Years of rivers, slides and creep in a moment, by a network that learned from erosion.run (early weights) */
  "learned.erode": {
    /** how long erosion acts [yr] */
    years?: number;
    /** share of the change that is kept, times the mask */
    strength?: number;
    /** level of the sea; far below the terrain for none [m] */
    sea_m?: number;
    /** network: a shipped one by its word, or a file of weights (safetensors) */
    model?: string;
    /** of the network's sums */
    precision?: "automatic" | "f32" | "bf16";
  };
  /** Environmental objects that live where they are fit and change their surroundings: islands, reefs, corals, trees, rocks */
  "ecosystem.grow": {
    /** so many more; fewer once every target is reached */
    iterations?: number;
    /** the water; objects that are given keep their own */
    surroundings?: {
      /** height of the water [m] */
      water_level_m?: number;
      /** speed of the undisturbed current [m/s] */
      current_m_s?: number;
      /** where it flows to: 0 east, 90 north [deg] */
      towards_deg?: number;
      /** by how much a metre between ground and water level speeds it up (k_w of eq. 1.52) [1/m] */
      venturi_1_m?: number;
      /** deviation of the broad blur of the ground (eq. 1.53) [m] */
      broad_m?: number;
      /** its share */
      broad_weight?: number;
      /** how strongly it turns the current */
      broad_deviation?: number;
      /** deviation of the fine blur [m] */
      fine_m?: number;
      /** its share */
      fine_weight?: number;
      /** how strongly it turns the current */
      fine_deviation?: number;
      /** depth below which water slows down towards the shore [m] */
      shore_m?: number;
      /** how far two equal heights rise where they join: 1/(2k) of the smooth maximum [m] */
      blend_m?: number;
    };
    /** events, beside those of objects that are given */
    timeline?: (
      | {
          tool: "water_level";
          /** iteration at which it begins */
          start?: number;
          /** iteration at which it is over */
          end?: number;
          /** below 0: it falls [m] */
          change_m?: number;
        }
      | {
          tool: "ground";
          /** iteration at which it begins */
          start?: number;
          /** iteration at which it is over */
          end?: number;
          /** of the strongest change */
          place?: Point;
          /** there; below 0 it sinks [m] */
          change_m?: number;
          /** deviation of the falloff [m] */
          radius_m?: number;
        }
      | {
          tool: "storm";
          /** iteration at which it begins */
          start?: number;
          /** iteration from which it is over */
          end?: number;
          /** its centre */
          place?: Point;
          /** of the water that it drives, at the centre [m/s] */
          speed_m_s?: number;
          /** where to: 0 east, 90 north [deg] */
          towards_deg?: number;
          /** deviation of the falloff [m] */
          radius_m?: number;
        }
      | {
          tool: "current";
          /** iteration at which it begins */
          start?: number;
          /** iteration from which it is over */
          end?: number;
          /** a spline through at least two points, in its direction */
          points?: Point[];
          /** on the stroke; below 0 against it [m/s] */
          speed_m_s?: number;
          /** deviation of the falloff across it [m] */
          width_m?: number;
        }
    )[];
    /** a JSON file with more of them */
    timeline_file?: string;
    /** what is done to objects by hand */
    edits?: (
      | {
          tool: "add";
          /** iteration after which it is done */
          after?: number;
          /** of the catalogue */
          class?: string;
          /** its skeleton: one point, a curve, or the outline of a region */
          points?: Point[];
          /** its points stay where they are */
          locked?: boolean;
          /** it lives whatever its fitness */
          keep?: boolean;
          /** times the size of its class */
          size?: number;
        }
      | {
          tool: "move";
          /** iteration after which it is done */
          after?: number;
          /** which one */
          object?: {
            /** number of the object; 0: the nearest one */
            id?: number;
            /** its class; empty: any */
            class?: string;
            /** without a number: the object nearest to this place */
            near?: Point;
          };
          /** metres east and north */
          by?: Point;
        }
      | {
          tool: "bend";
          /** iteration after which it is done */
          after?: number;
          /** which one */
          object?: {
            /** number of the object; 0: the nearest one */
            id?: number;
            /** its class; empty: any */
            class?: string;
            /** without a number: the object nearest to this place */
            near?: Point;
          };
          /** where the handle takes hold */
          at?: Point;
          /** metres east and north */
          by?: Point;
          /** how far it reaches [m] */
          radius_m?: number;
          /** falloff of the handle: gaussian or kelvinlet */
          handle?: "gaussian" | "kelvinlet";
          /** points that moved by more than half of it stay there */
          lock?: boolean;
        }
      | {
          tool: "hold";
          /** iteration after which it is done */
          after?: number;
          /** which one */
          object?: {
            /** number of the object; 0: the nearest one */
            id?: number;
            /** its class; empty: any */
            class?: string;
            /** without a number: the object nearest to this place */
            near?: Point;
          };
          /** its points around this place */
          at?: Point;
          /** so far from it [m] */
          radius_m?: number;
          /** 0 free, 1 locked, hindered in between */
          hold?: number;
        }
      | {
          tool: "delete";
          /** iteration after which it is done */
          after?: number;
          /** which one */
          object?: {
            /** number of the object; 0: the nearest one */
            id?: number;
            /** its class; empty: any */
            class?: string;
            /** without a number: the object nearest to this place */
            near?: Point;
          };
        }
    )[];
    /** a JSON file with more of them */
    edits_file?: string;
    /** how many of a class are wanted; growth ends once all are there */
    targets?: {
      /** of the catalogue */
      class?: string;
      /** so many are to live, and no more */
      count?: number;
    }[];
    /** only these are born; empty: all of the catalogue */
    classes?: string[];
    /** a finer frame to grow in */
    window?: {
      /** cell size of the window; 0: the whole scene grows [m] */
      cell_m?: number;
      /** its middle */
      centre?: Point;
      /** west to east [m] */
      width_m?: number;
      /** south to north [m] */
      height_m?: number;
    };
  };
  /** The ground with what objects and events make of it */
  "ecosystem.height": {
    /** of the scene: 0 its own frame, else a window, counted from 1 */
    window?: number;
  };
  /** A material, the current, a distance, a fitness, any expression of a scene as a raster */
  "ecosystem.field": {
    /** an expression as in catalogues: a material, current, distance(reef), ... */
    of?: string;
    /** a class instead: where it would be born, as its fitness says */
    fitness_of?: string;
    /** of the scene: 0 its own frame, else a window, counted from 1 */
    window?: number;
  };
  /** The label map of a scene: mountain, beach, lagoon, reef, abyss */
  "ecosystem.labels": {
    /** of the scene: 0 its own frame, else a window, counted from 1 */
    window?: number;
  };
  /** What the objects look like: corals, trees and rocks, standing on the ground */
  "ecosystem.things": {
    /** 0: all of the scene, with what grew in its windows; else what lies within that window */
    window?: number;
    /** of all together: things get coarser, then fewer; 0: no limit */
    max_triangles?: number;
    /** what they stand on goes with them into files */
    keep_ground?: boolean;
  };
  /** A terrain on cells of a half, a quarter or an eighth, with the detail of real ground */
  "amplify.sparse": {
    /** how many cells there are along each side for one: x2, x4, x8 */
    factor?: "x2" | "x4" | "x8";
    /** ground whose detail it gets: mountains, hills, canyons, or a file of `seamount train dictionary` */
    dictionary?: string;
    /** how strong the detail is; 0 refines without any */
    strength?: number;
  };
  /** Labels any terrain by depth, slope and exposure, so that it can enter the methods that build on labels */
  "classify.terrain": {
    /** height up to which land by the sea can be beach [m] */
    beach_m?: number;
    /** how far from the water beach reaches [m] */
    beach_width_m?: number;
    /** steepest beach [deg] */
    beach_slope_deg?: number;
    /** depth down to which ground breaks the swell [m] */
    bar_m?: number;
    /** distance over open water that counts as fully open [m] */
    fetch_m?: number;
    /** share of open directions from which water counts as exposed */
    exposed?: number;
    /** depth down to which exposed ground is reef [m] */
    reef_depth_m?: number;
    /** how far from exposed water bars are reef, and benches from deep water [m] */
    reef_width_m?: number;
    /** depth of the foot of the fore reef [m] */
    fore_reef_m?: number;
    /** least slope of the fore reef, from the reef's edge [deg] */
    fore_reef_slope_deg?: number;
    /** depth down to which sheltered water is lagoon [m] */
    lagoon_depth_m?: number;
    /** widest pass between two reefs of a belt; what lies behind a belt is lagoon [m] */
    belt_gap_m?: number;
    /** forms smaller than this do not count as slope [m] */
    scale_m?: number;
    /** smaller patches go to what lies around them [m2] */
    min_patch_m2?: number;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
  };
  /** Labels of a terrain that any steps have changed, from those before */
  "classify.follow": {
    /** level of the sea [m] */
    sea_m?: number;
  };
  /** Regions of an island painted with a pen, over those of a label map or from nothing, and its subsidence */
  "classify.paint": {
    /** region where nothing is painted and no labels come in */
    base?: "mountain" | "beach" | "lagoon" | "reef" | "abyss";
    /** what is painted, one stroke after another */
    strokes?: (
      | {
          tool: "region";
          /** what is painted */
          region?: "mountain" | "beach" | "lagoon" | "reef" | "abyss";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** half the width of the stroke [m] */
          radius_m?: number;
        }
      | {
          tool: "area";
          /** what is painted */
          region?: "mountain" | "beach" | "lagoon" | "reef" | "abyss";
          /** what is filled, at least one; an outline may cross itself */
          polygons?: Polygon[];
        }
      | {
          tool: "sink";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** how hard the pen was pressed at each point: share of what the stroke does; none: 1 */
          pressure?: number[];
          /** reach to either side, where the stroke ends [m] */
          radius_m?: number;
          /** 0: soft from the middle on; 1: the same all over, with a sharp edge */
          hardness?: number;
          /** in the middle of the stroke: 0 not at all, 1 wholly */
          subsidence?: number;
        }
      | {
          tool: "erase";
          /** places of the pen, at least one; a spline runs through them */
          points?: Point[];
          /** half the width of the stroke [m] */
          radius_m?: number;
        }
    )[];
  };
  /** Spreads trees, corals, rocks or models of your own over a terrain, at drawn places or by a density */
  "ecosystem.scatter": {
    /** what it is */
    thing?: {
      /** what it looks like; file: a mesh of your own */
      shape?: "rock" | "pebble" | "arch" | "branching_coral" | "massive_coral" | "table_coral" | "foliose_coral" | "sea_fan" | "sponge" | "palm" | "broadleaf" | "conifer" | "shrub" | "mangrove" | "seagrass" | "kelp" | "file";
      /** shape file: a GLB or OBJ file in metres, y up, its foot at the origin */
      file?: string;
      /** height of a thing of size 1; by default what is usual for the shape, or what the file has [m] */
      height_m?: number | null;
      /** width of a thing of size 1; by default in proportion to its height [m] */
      width_m?: number | null;
      /** different models of it */
      variants?: number;
      /** deviation of the sizes around 1, as a share */
      size_variation?: number;
      /** how far it stands along the ground's normal: 0 upright, 1 square to the slope; by default as the shape does */
      lean?: number | null;
      /** its main colour; black: the shape's own */
      colour?: Colour;
    };
    /** least distance of two, without drawn places [m] */
    spacing_m?: number;
    /** none on lower ground [m] */
    min_height_m?: number;
    /** none on higher ground [m] */
    max_height_m?: number;
    /** none on steeper ground [deg] */
    max_slope_deg?: number;
    /** 1 is whole; ailing things are paler and have less of all */
    health?: number;
    /** of all together: things get coarser, then fewer; 0: no limit */
    max_triangles?: number;
    /** what they stand on goes with them into files */
    keep_ground?: boolean;
  };
  /** A map with tints by height and depth, relief, contours, legend and scale bar; rivers, lakes, ridges, peaks, currents and objects over it */
  "render.map": {
    /** width of the picture in pixels */
    width_px?: number;
    /** text over the map; none if empty */
    title?: string;
    /** what the colours show: heights and depths, or the regions of a label map */
    theme?: "height" | "regions";
    /** heights: natural tints by height, or three layers by height in a style (the reef's of the sea floor, the others of the land) */
    style?: "natural" | "great_barrier_reef" | "stone" | "desert" | "volcano";
    /** borders of the style's layers */
    layers?: {
      /** height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as the style asks [m] */
      low_m?: number | null;
      /** height above low_m over which the low layer fades; by default 0.1 of the relief [m] */
      low_error_m?: number | null;
      /** height from which the high layer takes over; by default 0.5 of the relief [m] */
      high_m?: number | null;
      /** height below high_m over which the high layer fades in; by default 0.05 of the relief [m] */
      high_error_m?: number | null;
      /** layers fade in and out softly; off: linearly, as in the paper */
      smooth?: boolean;
      /** how far borders stray from one height, by noise and on steep ground, which is more of the middle layer */
      variation?: number;
    };
    /** strength of the relief shading */
    shading?: number;
    /** draw contour lines */
    contours?: boolean;
    /** height between contours; by default a round number for about twenty [m] */
    contour_interval_m?: number | null;
    /** draw the coast line */
    coast?: boolean;
    /** draw the outer edge of the reef; needs labels */
    reef_crest?: boolean;
    /** explain the colours at the right */
    legend?: boolean;
    /** show lengths below the map */
    scale_bar?: boolean;
    /** show where north is */
    north_arrow?: boolean;
    /** distance between the arrows of a current, and the length of the longest; by default forty across [px] */
    arrow_spacing_px?: number | null;
    /** explain the objects in a box below the map: each class with objects on it, and how many */
    object_legend?: boolean;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
  };
  /** Shaded relief with light from several directions */
  "render.relief": {
    /** width of the picture in pixels */
    width_px?: number;
    /** colour of the ground: grey, or by height and depth */
    tint?: "grey" | "height";
    /** bearing of the main light, clockwise from north [deg] */
    light_azimuth_deg?: number;
    /** height of the lights [deg] */
    light_elevation_deg?: number;
    /** how much valleys that see little sky are darkened */
    ambient?: number;
    /** heights are shaded times this; by default so that steep ground of this terrain looks steep */
    vertical_exaggeration?: number | null;
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
  };
  /** A picture from a point of view, with sun, shadows, sky and water */
  "render.perspective": {
    /** width of the picture in pixels */
    width_px?: number;
    /** height of the picture in pixels */
    height_px?: number;
    /** from where to look */
    camera?: {
      /** aerial: from above, so that all fits; hero: low, against the sky; canyon: from within the deepest valley; turntable: around all land, at the same distance from every side */
      view?: "aerial" | "hero" | "canyon" | "turntable";
      /** bearing of the camera from the target, clockwise from north; 205 by default, in a canyon along the valley [deg] */
      azimuth_deg?: number | null;
      /** height of the camera above the horizon as seen from the target; by default 25, hero 7, turntable 30 [deg] */
      elevation_deg?: number | null;
      /** distance from the target over that at which all just fits: 0.5 is half as far */
      distance?: number;
      /** where to look, east; by default the middle of the largest land or reef and what is near [m] */
      target_x_m?: number | null;
      /** where to look, north; by default the same [m] */
      target_y_m?: number | null;
      /** metres from the target, which is then a place on the ground; under water the camera stays there; by default distance counts [m] */
      distance_m?: number | null;
      /** with distance_m or x_m: height of the target over the ground [m] */
      target_height_m?: number;
      /** where the camera stands, east; with y_m, instead of a distance [m] */
      x_m?: number | null;
      /** where the camera stands, north [m] */
      y_m?: number | null;
      /** with x_m and y_m: height of the camera over ground or water [m] */
      height_m?: number;
      /** angle of view from top to bottom; by default 35, hero 28, canyon 60 [deg] */
      field_of_view_deg?: number | null;
    };
    /** where the light comes from */
    sun?: {
      /** time of the day; azimuth_deg and elevation_deg overrule it */
      light?: "afternoon" | "morning" | "noon" | "evening";
      /** bearing of the sun, clockwise from north; afternoon 285, morning 80, evening 275, noon towards the equator [deg] */
      azimuth_deg?: number | null;
      /** height of the sun over the horizon; afternoon 30, morning 14, noon 65, evening 6 [deg] */
      elevation_deg?: number | null;
    };
    /** heights are drawn times this */
    vertical_exaggeration?: number;
    /** haze with distance; 0 is clear */
    haze?: number;
    /** brightness of the picture */
    exposure?: number;
    /** fill the ground below the water level */
    water?: boolean;
    /** height of the water's surface [m] */
    water_level_m?: number;
    /** how far one sees in water, 1 in clear tropical water */
    water_clarity?: number;
    /** what lies around the terrain */
    surround?: "automatic" | "sea" | "block";
    /** what grows on the land, in the natural style */
    climate?: {
      /** values that belong together, by a word; what is stated besides wins */
      preset?: "tropical" | "temperate" | "arid" | "polar";
      /** latitude, which decides how warm it is; by default that of the terrain's place if it has one, else -18 in a sea and 45 inland [deg] */
      latitude_deg?: number | null;
      /** rain in a year, mean over the land; below 250 a desert; by default as usual for the latitude [mm/yr] */
      rain_mm_yr?: number | null;
      /** bearing that the wind brings rain from: windward slopes are wet, leeward ones dry; by default trade winds or westerlies by the latitude [deg] */
      wind_from_deg?: number | null;
    };
    /** height over the water where forest ends; by default as usual for the latitude [m] */
    tree_line_m?: number | null;
    /** height over the water where snow stays; by default as usual for the latitude [m] */
    snow_line_m?: number | null;
    /** bare rock in the natural style; automatic is basalt in a warm sea, else granite */
    rock?: "automatic" | "granite" | "basalt" | "limestone" | "sandstone";
    /** what the ground is made of: natural, or three layers by height in a style */
    style?: "natural" | "great_barrier_reef" | "stone" | "desert" | "volcano";
    /** borders of the style's layers, as heights over the water */
    layers?: {
      /** height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as the style asks [m] */
      low_m?: number | null;
      /** height above low_m over which the low layer fades; by default 0.1 of the relief [m] */
      low_error_m?: number | null;
      /** height from which the high layer takes over; by default 0.5 of the relief [m] */
      high_m?: number | null;
      /** height below high_m over which the high layer fades in; by default 0.05 of the relief [m] */
      high_error_m?: number | null;
      /** layers fade in and out softly; off: linearly, as in the paper */
      smooth?: boolean;
      /** how far borders stray from one height, by noise and on steep ground, which is more of the middle layer */
      variation?: number;
    };
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
  };
  /** The ground from above, as a texture for meshes */
  "render.texture": {
    /** pixels along the terrain's longer side */
    size_px?: number;
    /** soft light from the north-west and shade in valleys; 0 gives pure albedo for a lit renderer */
    baked_light?: number;
    /** show the sea floor as seen through the water */
    water?: boolean;
    /** height of the water's surface [m] */
    water_level_m?: number;
    /** how far one sees in water, 1 in clear tropical water */
    water_clarity?: number;
    /** what grows on the land, in the natural style */
    climate?: {
      /** values that belong together, by a word; what is stated besides wins */
      preset?: "tropical" | "temperate" | "arid" | "polar";
      /** latitude, which decides how warm it is; by default that of the terrain's place if it has one, else -18 in a sea and 45 inland [deg] */
      latitude_deg?: number | null;
      /** rain in a year, mean over the land; below 250 a desert; by default as usual for the latitude [mm/yr] */
      rain_mm_yr?: number | null;
      /** bearing that the wind brings rain from: windward slopes are wet, leeward ones dry; by default trade winds or westerlies by the latitude [deg] */
      wind_from_deg?: number | null;
    };
    /** height over the water where forest ends; by default as usual for the latitude [m] */
    tree_line_m?: number | null;
    /** height over the water where snow stays; by default as usual for the latitude [m] */
    snow_line_m?: number | null;
    /** bare rock in the natural style; automatic is basalt in a warm sea, else granite */
    rock?: "automatic" | "granite" | "basalt" | "limestone" | "sandstone";
    /** what the ground is made of: natural, or three layers by height in a style */
    style?: "natural" | "great_barrier_reef" | "stone" | "desert" | "volcano";
    /** borders of the style's layers, as heights over the water */
    layers?: {
      /** height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as the style asks [m] */
      low_m?: number | null;
      /** height above low_m over which the low layer fades; by default 0.1 of the relief [m] */
      low_error_m?: number | null;
      /** height from which the high layer takes over; by default 0.5 of the relief [m] */
      high_m?: number | null;
      /** height below high_m over which the high layer fades in; by default 0.05 of the relief [m] */
      high_error_m?: number | null;
      /** layers fade in and out softly; off: linearly, as in the paper */
      smooth?: boolean;
      /** how far borders stray from one height, by noise and on steep ground, which is more of the middle layer */
      variation?: number;
    };
    /** enclosed water below sea level that is smaller is no sea but a hollow; if absent, only what is deeper than 1000 m, or deeper than 10 m behind a rim of at most 10 m and a hundredth of the terrain, is sea [m2] */
    min_sea_m2?: number | null;
  };
  /** Contours as a topographic map: lines with their heights, water, scale bar */
  "render.contours": {
    /** width of the picture in pixels */
    width_px?: number;
    /** text over the map; none if empty */
    title?: string;
    /** every so many heights the line is stronger, counted from sea level where heights are multiples of their interval, else from the lowest */
    index_every?: number;
    /** write the heights of the stronger lines into them */
    labels?: boolean;
    /** tint what lies below a contour of sea level */
    water?: boolean;
    /** draw ticks into basins, to tell them from hills */
    basin_ticks?: boolean;
    /** show lengths, and the interval between contours, below the map */
    scale_bar?: boolean;
    /** show where north is */
    north_arrow?: boolean;
  };
  /** The layers of ground that a style's pictures show: three masks that sum to one, for splat maps */
  "render.layers": {
    /** the style of the pictures that it goes with; natural: borders at shares of the relief, as terrain.layers */
    style?: "natural" | "great_barrier_reef" | "stone" | "desert" | "volcano";
    /** borders between the low layer (red), the middle (green), the high (blue) */
    layers?: {
      /** height up to which all is the low layer; by default 0.3 of the relief, over the sea where there is some, or as the style asks [m] */
      low_m?: number | null;
      /** height above low_m over which the low layer fades; by default 0.1 of the relief [m] */
      low_error_m?: number | null;
      /** height from which the high layer takes over; by default 0.5 of the relief [m] */
      high_m?: number | null;
      /** height below high_m over which the high layer fades in; by default 0.05 of the relief [m] */
      high_error_m?: number | null;
      /** layers fade in and out softly; off: linearly, as in the paper */
      smooth?: boolean;
      /** how far borders stray from one height, by noise and on steep ground, which is more of the middle layer */
      variation?: number;
    };
  };
}

export type OperatorName = keyof OperatorParams;
