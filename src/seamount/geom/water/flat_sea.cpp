#include "seamount/geom/water/flat_sea.h"

#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/polygon/distance.h"

namespace seamount::geom {
namespace {

SEAMOUNT_VECTORISED int count_zeros(const float* heights, int count) {
  int zeros = 0;
  for (int i = 0; i < count; ++i) zeros += heights[i] == 0.0F ? 1 : 0;
  return zeros;
}

/// A look that most terrains end with: are there as many cells of 0 m as such a sea has?
bool may_have_one(const HeightField& terrain, const RunContext& run) {
  constexpr int64_t kRows = 64;
  const auto zeros = parallel_sum<int64_t>(run, terrain.height(), kRows, [&](int64_t begin, int64_t end) {
    int64_t count = 0;
    for (int64_t y = begin; y < end; ++y)
      count += count_zeros(terrain.row(static_cast<int>(y)).data(), terrain.width());
    return count;
  });
  return zeros * 100 >= static_cast<int64_t>(terrain.size());
}

}  // namespace

Grid<uint8_t> flat_sea(const HeightField& terrain, const RunContext& run) {
  if (!may_have_one(terrain, run)) return {};
  Grid<uint8_t> sea(terrain.frame());
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < terrain.width(); ++x) {
        bool flat = terrain(x, y) == 0.0F;
        for (int dy = -1; flat && dy <= 1; ++dy) {
          for (int dx = -1; flat && dx <= 1; ++dx) flat = terrain.clamped(x + dx, y + dy) == 0.0F;
        }
        sea(x, y) = flat ? 1 : 0;
      }
    }
  });
  int64_t count = 0;
  for (const uint8_t cell : sea.cells()) count += cell;
  if (count * 100 < static_cast<int64_t>(terrain.size())) return {};
  return sea;
}

Grid<uint8_t> flat_sea_to_coast(const HeightField& terrain, const RunContext& run) {
  const Grid<uint8_t> sea = flat_sea(terrain, run);
  if (sea.empty()) return sea;
  Grid<uint8_t> wide(sea.frame());
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < terrain.width(); ++x) {
        bool touches = sea(x, y) != 0;
        for (int k = 0; !touches && k < 9; ++k) touches = sea.clamped(x + k % 3 - 1, y + k / 3 - 1) != 0;
        wide(x, y) = touches && terrain(x, y) == 0.0F ? 1 : 0;
      }
    }
  });
  return wide;
}

void sink_flat_sea(HeightField& terrain, const Grid<uint8_t>& sea, const RunContext& run) {
  Grid<uint8_t> coast(sea.frame());
  for (size_t i = 0; i < sea.size(); ++i) coast.cells()[i] = sea.cells()[i] == 0 ? 1 : 0;
  const ScalarField distance = distance_to(coast, run);
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < terrain.width(); ++x) {
        if (sea(x, y) != 0) terrain(x, y) = -110.0F * (1.0F - std::exp(-distance(x, y) / 1400.0F)) - 1.0F;
      }
    }
  });
}

}  // namespace seamount::geom
