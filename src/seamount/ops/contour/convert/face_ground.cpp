#include "seamount/ops/contour/convert/face_ground.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "seamount/geom/scalar/quantile.h"

namespace seamount::contour {
namespace {

/// Mean distances of the cells of each face to its nearest bound, in cells; 0 where it has none.
std::vector<double> mean_distances(const FaceGround& ground) {
  std::vector<double> sums(static_cast<size_t>(ground.faces.count()), 0.0);
  std::vector<double> counts(sums.size(), 0.0);
  const std::span<const int32_t> faces = ground.between.face.cells();
  for (size_t i = 0; i < faces.size(); ++i) {
    const float d = std::min(ground.between.low.cells()[i], ground.between.high.cells()[i]);
    if (!std::isfinite(d)) continue;
    sums[static_cast<size_t>(faces[i])] += d;
    counts[static_cast<size_t>(faces[i])] += 1.0;
  }
  for (size_t i = 0; i < sums.size(); ++i) sums[i] = counts[i] > 0.0 ? sums[i] / counts[i] : 0.0;
  return sums;
}

}  // namespace

double usual_interval(const ContourSet& set) {
  std::vector<double> heights;
  heights.reserve(set.contours.size());
  for (const Contour& contour : set.contours) heights.push_back(contour.height_m);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  if (heights.size() < 2) return 0.05 * std::min(set.frame.width_m(), set.frame.height_m());
  std::vector<double> steps;
  steps.reserve(heights.size());
  for (size_t i = 1; i < heights.size(); ++i) steps.push_back(heights[i] - heights[i - 1]);
  return geom::median(std::move(steps));
}

FaceGround make_face_ground(const ContourSet& set, double summits, const GridFrame& frame, const RunContext& run) {
  geom::ContourFaces faces(set.contours);
  geom::ContourInterpolation between = geom::interpolate_contours(set.contours, faces, frame, run);
  run.check_cancelled();
  FaceGround ground{std::move(faces), std::move(between), {}, {}};
  const double usual = usual_interval(set);
  const std::vector<double> means = mean_distances(ground);
  run.check_cancelled();
  ground.reach_m.reserve(means.size());
  ground.slope.reserve(means.size());
  for (size_t face = 0; face < means.size(); ++face) {
    const int parent = face == 0 ? -1 : set.contours[face - 1].parent;
    double interval = usual;
    if (parent >= 0) {
      const double own = set.contours[face - 1].height_m;
      const double step = std::abs(own - set.contours[static_cast<size_t>(parent)].height_m);
      if (step > 0.0) interval = step;
    }
    // In a band between two contours the mean distance to the nearer is a quarter of the band's width.
    const auto around = static_cast<size_t>(face == 0 ? 0 : parent + 1);
    const double width = std::max({1.0, 4.0 * means[around], 2.0 * means[face]});
    ground.reach_m.push_back(static_cast<float>(summits * interval));
    ground.slope.push_back(static_cast<float>(interval / width));
  }
  return ground;
}

float saturated(float u) { return u / std::sqrt(1.0F + u * u); }

float saturated_late(float u) {
  const float squared = u * u;
  return u / std::sqrt(std::sqrt(1.0F + squared * squared));
}

std::vector<int64_t> basin_floors(const FaceGround& ground, const HeightField& heights) {
  std::vector<int64_t> lowest(static_cast<size_t>(ground.faces.count()), -1);
  const std::span<const float> z = heights.cells();
  for (size_t i = 0; i < z.size(); ++i) {
    const int32_t face = ground.between.face.cells()[i];
    if (!ground.faces.holds_water(face)) continue;
    int64_t& best = lowest[static_cast<size_t>(face)];
    if (best < 0 || z[i] < z[static_cast<size_t>(best)]) best = static_cast<int64_t>(i);
  }
  std::erase(lowest, -1);
  return lowest;
}

}  // namespace seamount::contour
