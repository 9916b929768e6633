// The plan of an island: its outlines from the centre outwards (P0 sec. 1.4.1, the top-view sketch).
//
// Outline 1 is the foot of the mountains, 2 the coast, 3 the end of the lagoon, 4 the end of the reef, 5 the end of the
// slope; region i (model/label_map.h) lies between outlines i and i + 1, outline 0 is the centre. They are given around
// a centre in polar form, as the paper does, or as areas of any form: drawn polygons, a real coastline, traced labels.
// What is not given is derived from the coast by widths.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/drawn.h"
#include "seamount/model/extent.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/ops/island/lobes.h"
#include "seamount/ops/island/width_params.h"

namespace seamount::island {

inline constexpr int kOutlineCount = 5;

/// Index into the outlines of a plan, which start at outline 1.
inline constexpr int kCoast = 1;

/// Names of the areas inside outlines 1 to 5, as island.outlines writes and island.build reads them.
inline constexpr std::array<const char*, kOutlineCount> kAreaNames = {"mountain", "beach", "lagoon", "reef", "abyss"};

/// Widths of the regions around the mountains. Metres, > 0.
struct RegionWidths {
  double beach_m = 0;
  double lagoon_m = 0;
  double reef_m = 0;
  double slope_m = 0;
};

struct Plan {
  /// Polar form: five outlines around the centre, ordered at every angle. Empty: `areas` holds the plan.
  std::vector<PolarOutline> polar;
  Vec2 centre;
  bool derived = false;  ///< all but the coast follow from it by widths

  /// General form: areas[i] is everything inside outline i + 1; those left empty follow from the next one inside by
  /// widths.
  std::array<std::vector<Polygon>, kOutlineCount> areas;
  RegionWidths widths;

  std::string crs;          ///< of the areas' coordinates, empty: local metres
  double land_m2 = 0;       ///< area inside the coast (of the innermost outline, if there is no land)
  double detail_m = 0;      ///< size of bays and headlands to add where nobody asks: 0 for whatever was drawn
  std::vector<Lobe> lobes;  ///< of the land, the largest first
};

/// Widths that suit an island with this much land: a beach of 1.2 %, a lagoon of 9 %, a reef of 7 % and a slope of 55 %
/// of its mean radius, within what real islands show.
RegionWidths natural_widths(double land_m2);

/// A plan from polar outlines: all five, or the coast alone. Throws InvalidArgument{"outlines"} for another number of
/// them, a radius that is not above 0, or outlines that cross (the message says which and at what angle).
Plan plan_from_polar(std::vector<PolarOutline> outlines, Vec2 centre, const GivenWidths& widths);

/// A plan from named areas ("mountain" ... "abyss" as in kAreaNames) or, if no area has such a name, from one coast.
/// Lines that close, alone or end to end, are areas too.
/// Throws InvalidArgument{name} for no area, defective polygons (which, where) or outlines that cross.
Plan plan_from_areas(const Drawing& drawing, const GivenWidths& widths, const std::string& name);

/// A plan from a label map: traced, so that its steps vanish. Throws InvalidArgument{"labels"} if all of it is abyss.
Plan plan_from_labels(const LabelMap& labels, const GivenWidths& widths, const RunContext& run = {});

/// A plausible coast when nothing is given: P0 eq. 1.16, r(theta) = r* + noise, r* = 0.26 of the frame's shorter side.
Plan random_plan(const GridFrame& frame, Vec2 centre, double irregularity, Seed seed, const GivenWidths& widths);

/// The land, or what the innermost outline encloses where there is none. Empty for polar plans.
const std::vector<Polygon>& land_of(const Plan& plan);

/// A polar plan in the general form; others as they are.
Plan as_areas(const Plan& plan);

/// Around the coast.
Extent extent_of(const Plan& plan);

/// `domain` if the coast lies inside it; else one around the island with its reef, of as many cells along its longer
/// side.
GridFrame frame_around(const Plan& plan, const GridFrame& domain);

/// Throws InvalidArgument{name} unless the coast lies inside the frame, saying how large the domain must be, and for a
/// coast less than two cells across.
void check_fits(const Plan& plan, const GridFrame& frame, const std::string& name);

/// Radii at `count` equal angles: periodic Catmull-Rom through those given.
std::vector<double> resample_radii(const std::vector<double>& radii, int count);

}  // namespace seamount::island
