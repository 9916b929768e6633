#include "seamount/ops/ecosystem/deposits.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"

namespace seamount::ecosystem {
namespace {

constexpr double kReach = 4.0;           // deviations: exp(-8) = 0.0003
constexpr double kLeastDeviation = 0.5;  // of a cell

/// Cells [x0, x1] x [y0, y1] within a distance of a box, cut at the frame; empty where it lies outside.
struct CellBox {
  int x0 = 0, x1 = -1, y0 = 0, y1 = -1;
};

CellBox cells_around(const GridFrame& frame, const Polyline& points, double reach) {
  double west = points[0].x, east = west, south = points[0].y, north = south;
  for (const Vec2 p : points) {
    west = std::min(west, p.x);
    east = std::max(east, p.x);
    south = std::min(south, p.y);
    north = std::max(north, p.y);
  }
  const auto bound = [](double value, int most) { return static_cast<int>(std::clamp(value, -1.0, most + 0.0)); };
  return {std::max(0, bound(std::ceil(frame.column(west - reach)), frame.width)),
          std::min(frame.width - 1, bound(std::floor(frame.column(east + reach)), frame.width)),
          std::max(0, bound(std::ceil(frame.row(north + reach)), frame.height)),
          std::min(frame.height - 1, bound(std::floor(frame.row(south - reach)), frame.height))};
}

/// exp(-d^2 / (2 radius^2)) along one axis at columns or rows first ... last, `at` in cells.
std::vector<float> falloff(int first, int last, double at, double radius_cells) {
  std::vector<float> values;
  for (int i = first; i <= last; ++i) {
    const double d = (i - at) / radius_cells;
    values.push_back(static_cast<float>(std::exp(-0.5 * d * d)));
  }
  return values;
}

class Sources {
 public:
  Sources(const GridFrame& frame, ScalarField& field) : frame_(frame), field_(field) {}

  void add(const Skeleton& skeleton, const Exchange& exchange, double rate) {
    const double least = kLeastDeviation * frame_.cell_m;
    const double radius = std::max(exchange.radius_m, least);
    const double narrower = exchange.radius_m / radius;
    const CellBox box = cells_around(frame_, skeleton.points, kReach * radius);
    if (box.x0 > box.x1 || box.y0 > box.y1) return;
    if (skeleton.kind == SkeletonKind::point)
      return add_point(skeleton.points[0], radius, rate * narrower * narrower, box);
    add_extended(skeleton, radius, skeleton.kind == SkeletonKind::curve ? rate * narrower : rate, box);
  }

 private:
  void add_point(Vec2 at, double radius, double rate, const CellBox& box) {
    const double cells = radius / frame_.cell_m;
    const std::vector<float> across = falloff(box.x0, box.x1, frame_.column(at.x), cells);
    const std::vector<float> down = falloff(box.y0, box.y1, frame_.row(at.y), cells);
    for (int y = box.y0; y <= box.y1; ++y) {
      const float share = static_cast<float>(rate) * down[static_cast<size_t>(y - box.y0)];
      float* row = field_.row(y).data() + box.x0;
      for (size_t i = 0; i < across.size(); ++i) row[i] += share * across[i];
    }
  }

  void add_extended(const Skeleton& skeleton, double radius, double rate, const CellBox& box) {
    const int32_t owner = 0;
    const geom::SkeletonIndex index({&skeleton, 1}, {&owner, 1});
    const auto width = static_cast<size_t>(box.x1 - box.x0 + 1);
    std::vector<Vec2> places(width);
    std::vector<geom::NearestSkeleton> nearest(width);
    RunContext serial;
    serial.threads = 1;
    for (int y = box.y0; y <= box.y1; ++y) {
      for (size_t i = 0; i < width; ++i) places[i] = {frame_.x(box.x0 + static_cast<int>(i)), frame_.y(y)};
      index.nearest(places, {}, nearest, serial);
      float* row = field_.row(y).data() + box.x0;
      for (size_t i = 0; i < width; ++i) {
        const double d = nearest[i].inside ? 0.0 : nearest[i].distance / radius;
        if (d < kReach) row[i] += static_cast<float>(rate * std::exp(-0.5 * d * d));
      }
    }
  }

  const GridFrame& frame_;
  ScalarField& field_;
};

/// A class's exchanges of one material, absorption below 0.
std::vector<Exchange> exchanges_of(const ObjectClass& of, const ClassRules& rules, int material) {
  std::vector<Exchange> found;
  for (size_t i = 0; i < of.deposits.size(); ++i)
    if (rules.deposits[i] == material) found.push_back(of.deposits[i]);
  for (size_t i = 0; i < of.absorbs.size(); ++i) {
    if (rules.absorbs[i] != material) continue;
    found.push_back(of.absorbs[i]);
    found.back().rate_1_s = -found.back().rate_1_s;
  }
  return found;
}

ScalarField sources_of(const Scene& scene, const Rules& rules, const GridFrame& frame, int window, int material) {
  std::vector<std::vector<Exchange>> of_class;
  for (size_t c = 0; c < scene.catalogue.classes.size(); ++c)
    of_class.push_back(exchanges_of(scene.catalogue.classes[c], rules.classes[c], material));
  ScalarField field;
  for (const SceneObject& object : scene.objects) {
    for (const Exchange& exchange : of_class[static_cast<size_t>(object.of_class)]) {
      if (!seen_from(scene, object, window)) continue;
      if (field.empty()) field = ScalarField(frame, 0.0F);
      Sources(frame, field).add(object.skeleton, exchange, exchange.rate_1_s);
    }
  }
  return field;
}

}  // namespace

std::vector<ScalarField> material_sources(const Scene& scene, const Rules& rules, const GridFrame& frame, int window,
                                          const RunContext& run) {
  std::vector<ScalarField> sources(scene.catalogue.materials.size());
  parallel_blocks(run, static_cast<int64_t>(sources.size()), 1, [&](int64_t begin, int64_t) {
    sources[static_cast<size_t>(begin)] = sources_of(scene, rules, frame, window, static_cast<int>(begin));
  });
  return sources;
}

}  // namespace seamount::ecosystem
