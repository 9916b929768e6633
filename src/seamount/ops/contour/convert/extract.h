// contour.extract: the iso-contours of a network or of a terrain, all levels in one pass.
//
// Source: P2 sec. 4.4. Departures: every level is taken from one pass; rasters at full resolution by marching squares;
// contours that reach the border close a little beyond it without touching (geom/contour/marching_triangles.h,
// geom/contour/contour.h), so that each encloses its land; the tree of inclusion comes with them.
#pragma once

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/grid.h"
#include "seamount/model/tin.h"

namespace seamount::contour {

struct ExtractParams {
  std::vector<double> levels_m;
  std::optional<double> interval_m;
  double base_m = 0.0;
  int count = 20;
  double simplify_m = 0.0;
  double min_area_m2 = 0.0;
  double min_length_m = 0.0;

  static constexpr auto fields() {
    using P = ExtractParams;
    return std::tuple(
        field(&P::levels_m, "levels_m", "m", between(-20000, 20000), "heights of the contours; none: see interval_m"),
        field(&P::interval_m, "interval_m", "m", between(1e-3, 20000),
              "height between contours, counted from base_m; absent: see count"),
        field(&P::base_m, "base_m", "m", between(-20000, 20000), "a height that would have a contour"),
        field(&P::count, "count", "", between(1, 1000),
              "number of heights, evenly over the range, where neither levels_m nor interval_m is given"),
        field(&P::simplify_m, "simplify_m", "m", between(0, 1e5),
              "points are dropped that lie no further than this from the rest; 0: all are kept"),
        field(&P::min_area_m2, "min_area_m2", "m2", between(0, 1e12),
              "smaller contours are left out, with all that they enclose"),
        field(&P::min_length_m, "min_length_m", "m", between(0, 1e9), "the same for shorter ones"));
  }

  static constexpr std::array kFormerNames = {FormerName{"least_area_m2", "min_area_m2"},
                                              FormerName{"least_length_m", "min_length_m"}};
};

/// Contours of a network, in its frame. Throws InvalidArgument for params out of range, levels outside the heights by
/// more than a hundredth of them (nearer ones are left out and said) and
/// more than 5000 levels, for a network without triangles or heights. REQUIRES: geom::find_tin_defect() finds nothing.
/// Linear in the triangles and, times its logarithm, in the points.
ContourSet extract(const Tin& tin, const ExtractParams& params, const RunContext& run);

/// The same of a terrain; within holes of unknown cells (NaN) it lies below all levels, so that contours close along
/// their rims. Throws InvalidArgument for infinite heights, or none that is known.
ContourSet extract(const HeightField& terrain, const ExtractParams& params, const RunContext& run);

/// Of the one that is given. Throws IncompatibleInputs for none or both.
ContourSet extract(const Tin* tin, const HeightField* terrain, const ExtractParams& params, const RunContext& run);

}  // namespace seamount::contour
