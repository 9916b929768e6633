#include "seamount/ops/contour/growth/outline_detail.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/quantile.h"
#include "seamount/geom/scalar/spline.h"
#include "seamount/ops/contour/move/roughen.h"

namespace seamount::contour {
namespace {

constexpr double kDeviation = 0.2;   ///< of the displacement over a side's length, at irregularity 1
constexpr double kWavelength = 2.5;  ///< over a side's length
constexpr double kGain = 0.58;       ///< a coast of fractal dimension about 1.2
constexpr int kMostOctaves = 10;
constexpr double kMostPoints = 50000.0;  ///< of an outline
constexpr int kWeightCells = 128;
constexpr double kLongestSide = 0.1;  ///< of the domain

bool inside(const Ring& ring, const GridFrame& domain) {
  return std::all_of(ring.begin(), ring.end(), [&](Vec2 p) {
    return p.x > domain.west_m && p.x < domain.east_m() && p.y > domain.south_m() && p.y < domain.north_m;
  });
}

/// The median side of the outlines in the domain and of the rivers; at most a tenth of the domain, so that what reaches
/// beyond it does not count with its long sides.
double usual_side(const RegionTree& tree, const std::vector<RiverLine>& rivers, const GridFrame& domain) {
  std::vector<double> sides = {kLongestSide * std::min(domain.width_m(), domain.height_m())};
  const auto add = [&](Vec2 from, Vec2 to) {
    sides.push_back(std::min(sides[0], std::sqrt(dot(to - from, to - from))));
  };
  for (const GrowthRegion& region : tree.regions) {
    const Ring& ring = region.outline;
    if (!inside(ring, domain)) continue;
    for (size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
  }
  for (const RiverLine& river : rivers) {
    for (size_t i = 1; i < river.points.size(); ++i) add(river.points[i - 1], river.points[i]);
  }
  return std::max(geom::median(std::move(sides)), domain.cell_m);
}

/// The closed spline through a ring's points: that of the ring with three points more at both ends, without what those
/// shape.
Ring rounded(const Ring& ring, double step_m) {
  constexpr size_t kMore = 3;
  Polyline control;
  control.reserve(ring.size() + 2 * kMore);
  const size_t n = ring.size();
  for (size_t i = 0; i < n + 2 * kMore; ++i) control.push_back(ring[(i + n * kMore - kMore) % n]);
  const Polyline line = geom::sample_catmull_rom(control, step_m);
  const size_t before = n == kMore ? 1 : 0;  // of a triangle, the points added in front hold the first one as well
  auto first = std::find(line.begin(), line.end(), ring[0]);
  for (size_t i = 0; i < before; ++i) first = std::find(std::next(first), line.end(), ring[0]);
  const auto last = std::find(std::next(first), line.end(), ring[0]);
  return {first, last};
}

/// The same polygon with points at most step_m apart.
Ring subdivided(const Ring& ring, double step_m) {
  Ring fine;
  fine.reserve(2 * ring.size());
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 from = ring[i], side = ring[(i + 1) % ring.size()] - from;
    const int parts = std::max(1, static_cast<int>(std::ceil(std::sqrt(dot(side, side)) / step_m)));
    for (int part = 0; part < parts; ++part) fine.push_back(from + (static_cast<double>(part) / parts) * side);
  }
  return fine;
}

/// 1 but towards the domain's edge, where it falls to 0 over fade_m.
ScalarField edge_weight(const GridFrame& domain, double fade_m) {
  GridFrame frame = domain;
  frame.cell_m = std::max(domain.width_m(), domain.height_m()) / kWeightCells;
  frame.width = std::max(3, static_cast<int>(std::ceil(domain.width_m() / frame.cell_m)));
  frame.height = std::max(3, static_cast<int>(std::ceil(domain.height_m() / frame.cell_m)));
  ScalarField weight(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const int border = std::min({x, y, frame.width - 1 - x, frame.height - 1 - y});
      weight(x, y) = static_cast<float>(std::min(1.0, border * frame.cell_m / fade_m));
    }
  }
  return weight;
}

}  // namespace

void add_outline_detail(RegionTree& tree, std::vector<RiverLine>& rivers, double irregularity, const GridFrame& domain,
                        Seed seed, const RunContext& run) {
  const double side = usual_side(tree, rivers, domain);
  const double wavelength = kWavelength * side;
  const int octaves = std::clamp(static_cast<int>(std::log2(wavelength / (2.0 * domain.cell_m))), 1, kMostOctaves);
  const double fade = std::max(side, 2.0 * std::max(domain.width_m(), domain.height_m()) / kWeightCells);
  const ScalarField weight = edge_weight(domain, fade);
  const Roughen roughen({kDeviation * irregularity * side, wavelength, octaves, kGain}, weight, std::sqrt(2.0) / fade,
                        seed);
  for (GrowthRegion& region : tree.regions) {
    run.check_cancelled();
    const double step = std::max(domain.cell_m, geom::ring_length(region.outline) / kMostPoints);
    region.outline = inside(region.outline, domain) ? rounded(region.outline, step) : subdivided(region.outline, step);
    roughen.move(1.0, region.outline, run);
  }
  for (RiverLine& river : rivers) roughen.move(1.0, river.points, run);
  tree = nest_regions(std::move(tree.regions), domain, "outlines", run);
}

}  // namespace seamount::contour
