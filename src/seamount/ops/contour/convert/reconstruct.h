// contour.reconstruct: a terrain from its contours or from a network.
//
// Source: P2 sec. 3.2, with the heights of the interpolation in their right places (geom/contour/interpolation.h), and
// its stair steps. Departures: `smooth`, the default, goes on across contours with the same slope (Hormann, Spinello
// and Schroeder 2003; ops/contour/convert/reconstruct_smooth.cpp), where the paper's interpolation breaks into
// terraces, and lets spurs and valleys between two branches of a contour be as steep as their sides. Summits, rims and
// basin floors, for which there is no further contour, get a shape from the slopes around them. Nothing passes the
// levels beyond. Water leaves every cell but in basins that a contour asks for, by every method but stairs, whose steps
// are level. `smooth` stays within half an interval of the plain interpolation, raises hollows instead of cutting
// through what is before them, and hangs continuously on the contours: points moved by a millimetre move heights by
// millimetres.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/grid.h"
#include "seamount/model/tin.h"

namespace seamount::contour {

/// How heights come about between contours.
enum class Method { smooth, interpolated, stairs };

struct ReconstructParams {
  Method method = Method::smooth;
  std::optional<double> cell_m;
  double summits = 0.6;

  static constexpr auto fields() {
    using P = ReconstructParams;
    return std::tuple(
        field(&P::method, "method",
              "smooth; interpolated: straight between the two nearest contours; stairs: level between contours. A "
              "network is interpolated in its triangles"),
        field(&P::cell_m, "cell_m", "m", between(1e-3, 1e6), "cell size of the terrain; the document's if absent"),
        field(&P::summits, "summits", "", between(0.05, 1),
              "how far summits may rise over the last contour and basins sink under it; 1: almost to the next one"));
  }
};

/// The terrain of nested contours, over the frame that they came with. Throws InvalidArgument for params out of range,
/// a set without contours, contours that cross or are wound or nested wrongly, more than 2^31 - 1 cells. About 300 ns a
/// cell (smooth), 150 ns (interpolated) or 10 ns (stairs), parallel; at most 6 copies of the terrain besides it.
HeightField reconstruct(const ContourSet& set, const ReconstructParams& params, const RunContext& run);

/// The terrain of a network: linear within its triangles. REQUIRES: geom::find_tin_defect() finds nothing. Throws
/// InvalidArgument for params out of range and a network without triangles or heights.
HeightField reconstruct(const Tin& tin, const ReconstructParams& params, const RunContext& run);

/// Of the one that is given. Throws IncompatibleInputs for none or both.
HeightField reconstruct(const ContourSet* set, const Tin* tin, const ReconstructParams& params, const RunContext& run);

}  // namespace seamount::contour

namespace seamount {
template <>
struct Choices<contour::Method> {
  static constexpr std::array<std::string_view, 3> names = {"smooth", "interpolated", "stairs"};
};
}  // namespace seamount
