#include "seamount/ops/contour/convert/reconstruct.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/inputs.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/solve/drain.h"
#include "seamount/geom/tin/tin_raster.h"
#include "seamount/ops/contour/convert/face_ground.h"
#include "seamount/ops/contour/convert/tin_sinks.h"

namespace seamount::contour {
namespace {

/// The plain interpolation, with a shape for faces with one bound: the slope of the ground around them, less and less.
HeightField interpolated(FaceGround ground, const RunContext& run) {
  HeightField heights = std::move(ground.between.height_m);
  parallel_rows(run, heights.width(), heights.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < heights.width(); ++x) {
        const int32_t face = ground.between.face(x, y);
        if (!ground.open(face)) continue;
        const auto f = static_cast<size_t>(face);
        const float d = ground.between.low(x, y);
        const float leave = std::isfinite(d) ? saturated(ground.slope[f] * d / ground.reach_m[f]) : 0.5F;
        heights(x, y) += ground.sign(face) * ground.reach_m[f] * leave;
      }
    }
  });
  geom::drain(heights, basin_floors(ground, heights), run);
  return heights;
}

HeightField stairs(const ContourSet& set, const GridFrame& frame, const RunContext& run) {
  const geom::ContourFaces faces(set.contours);
  const double usual = usual_interval(set);
  const Grid<int32_t> face_of = geom::rasterise_faces(set.contours, frame, run);
  HeightField heights(frame);
  std::vector<float> steps;
  for (int32_t face = 0; face < faces.count(); ++face) {
    const bool falls = faces.bounds_of(face) == 1 && !faces.rises(face);
    const double step = faces.bounds_of(face) == 0 ? 0.0 : faces.low_m(face) - (falls ? usual : 0.0);
    steps.push_back(static_cast<float>(step));
  }
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) heights(x, y) = steps[static_cast<size_t>(face_of(x, y))];
    }
  });
  return heights;
}

GridFrame wanted_frame(const GridFrame& frame, const std::optional<double>& cell_m) {
  if (!cell_m || *cell_m == frame.cell_m) return frame;
  const double width = std::max(1.0, std::round(frame.width_m() / *cell_m));
  const double height = std::max(1.0, std::round(frame.height_m() / *cell_m));
  if (width * height > 2147483647.0)
    throw InvalidArgument("cell_m", format_number(*cell_m) + " makes a terrain of " + format_number(width) + " x " +
                                        format_number(height) + " cells; at most 2147483647 are allowed");
  GridFrame wanted = frame;
  wanted.width = static_cast<int>(width);
  wanted.height = static_cast<int>(height);
  wanted.cell_m = *cell_m;
  return wanted;
}

void check_contours(const ContourSet& set, const RunContext& run) {
  if (set.contours.empty()) throw InvalidArgument("contours", "there are none");
  if (const auto crossing = geom::find_contour_crossing(set.contours, run)) {
    const Contour& a = set.contours[crossing->first];
    const Contour& b = set.contours[crossing->second];
    throw InvalidArgument("contours", "those of " + format_number(a.height_m) + " m and " + format_number(b.height_m) +
                                          " m cross or touch at (" + format_number(crossing->at.x) + ", " +
                                          format_number(crossing->at.y) + ")");
  }
}

}  // namespace

HeightField reconstruct(const ContourSet& set, const ReconstructParams& params, const RunContext& run) {
  check_params(params);
  run.check_cancelled();
  check_contours(set, run);
  const GridFrame frame = wanted_frame(set.frame, params.cell_m);
  if (params.method == Method::stairs) return stairs(set, frame, run);
  FaceGround ground = make_face_ground(set, params.summits, frame, run.part(0.0, 0.3));
  if (params.method == Method::smooth) return smooth_surface(set, std::move(ground), run.part(0.3, 1.0));
  return interpolated(std::move(ground), run.part(0.3, 1.0));
}

HeightField reconstruct(const Tin& tin, const ReconstructParams& params, const RunContext& run) {
  check_params(params);
  run.check_cancelled();
  if (tin.nodes.empty() || tin.triangles.empty()) throw InvalidArgument("tin", "has no triangles");
  if (tin.height_m.empty()) throw InvalidArgument("tin", "has no heights yet; give it some with contour.heights");
  HeightField heights = geom::rasterise_tin(tin, wanted_frame(tin.frame, params.cell_m), run.part(0.0, 0.7));
  geom::drain(heights, sinks_of(tin, heights, run), run.part(0.7, 1.0));
  return heights;
}

HeightField reconstruct(const ContourSet* set, const Tin* tin, const ReconstructParams& params, const RunContext& run) {
  require_one("contours", set != nullptr, "tin", tin != nullptr);
  return tin != nullptr ? reconstruct(*tin, params, run) : reconstruct(*set, params, run);
}

}  // namespace seamount::contour
