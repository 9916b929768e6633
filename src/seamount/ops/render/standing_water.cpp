#include "seamount/ops/render/standing_water.h"

#include <algorithm>

#include "seamount/base/parallel.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/same_size.h"

namespace seamount::render {

Mask dry_below_sea(const HeightField& terrain, const std::optional<double>& min_sea_m2, const RunContext& run) {
  const Grid<uint8_t> hollows = geom::find_hollows(terrain, 0.0F, min_sea_m2, run);
  if (hollows.empty()) return {};
  const auto is_dry = [&](int x, int y) { return hollows.clamped(x, y) != 0 && terrain.clamped(x, y) < 0.0F; };
  Mask dry(terrain.frame());
  // No sea touches a hollow, so what is added around it is land.
  parallel_rows(run, dry.width(), dry.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < dry.width(); ++x) {
        bool near = false;
        for (int k = 0; k < 9 && !near; ++k) near = is_dry(x + k % 3 - 1, y + k / 3 - 1);
        dry(x, y) = near ? 1.0F : 0.0F;
      }
    }
  });
  return dry;
}

ScalarField depth_around_lakes(const HeightField& terrain, const ScalarField* lake, const RunContext& run) {
  if (lake == nullptr) return {};
  check_same_size("lake", lake->frame(), terrain.frame());
  if (std::none_of(lake->cells().begin(), lake->cells().end(), [](float depth) { return depth > 0.0F; })) return {};
  ScalarField depth(terrain.frame());
  parallel_rows(run, depth.width(), depth.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < depth.width(); ++x) {
        depth(x, y) = (*lake)(x, y);
        if (depth(x, y) > 0.0F) continue;
        float below = -kShoreLimit_m;
        for (int k = 0; k < 9; ++k) {
          const int nx = x + k % 3 - 1, ny = y + k / 3 - 1;
          if (const float there = lake->clamped(nx, ny); there > 0.0F)
            below = std::max(below, terrain.clamped(nx, ny) + there - terrain(x, y));
        }
        depth(x, y) = std::min(below, 0.0F);
      }
    }
  });
  return depth;
}

void raise_to_lakes(HeightField& ground, const ScalarField& depth) {
  for (size_t i = 0; i < depth.size(); ++i) ground.data()[i] += std::max(0.0F, depth.data()[i]);
}

}  // namespace seamount::render
