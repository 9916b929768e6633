#include <algorithm>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/flow_flats.h"

namespace seamount::geom {
namespace {

constexpr float kDiagonal = 0.70710678F;

/// Steepest descent of the cells [1, count - 1) of a row; kPit where no neighbour is lower.
SEAMOUNT_VECTORISED void steepest_row(const float* north, const float* here, const float* south, float sea,
                                      uint8_t* out, int count) {
  for (int i = 1; i < count - 1; ++i) {
    const float z = here[i];
    const float drop[8] = {
        z - here[i + 1], (z - north[i + 1]) * kDiagonal, z - north[i], (z - north[i - 1]) * kDiagonal,
        z - here[i - 1], (z - south[i - 1]) * kDiagonal, z - south[i], (z - south[i + 1]) * kDiagonal};
    float best = 0.0F;
    int32_t code = kPit;
    for (int32_t k = 0; k < 8; ++k) {
      code = drop[k] > best ? k : code;
      best = drop[k] > best ? drop[k] : best;
    }
    out[i] = static_cast<uint8_t>(z <= sea ? kOutlet : code);
  }
}

/// A row with the sea at its surface.
SEAMOUNT_VECTORISED void clamp_row(const float* row, float sea, float* out, int count) {
  for (int i = 0; i < count; ++i) out[i] = row[i] > sea ? row[i] : sea;
}

void steepest_rows(const HeightField& terrain, float sea, FlowDirections& out, int begin, int end) {
  const int width = terrain.width();
  std::vector<float> surface(3 * static_cast<size_t>(width));
  const auto row_of = [&](int y) { return surface.data() + static_cast<size_t>(y % 3) * static_cast<size_t>(width); };
  for (int y = std::max(0, begin - 1); y < std::min(begin + 1, terrain.height()); ++y)
    clamp_row(terrain.row(y).data(), sea, row_of(y), width);
  for (int y = begin; y < end; ++y) {
    const auto row = out.row(y);
    if (y == 0 || y == terrain.height() - 1) {
      std::fill(row.begin(), row.end(), kOutlet);
      if (y + 1 < terrain.height()) clamp_row(terrain.row(y + 1).data(), sea, row_of(y + 1), width);
      continue;
    }
    clamp_row(terrain.row(y + 1).data(), sea, row_of(y + 1), width);
    steepest_row(row_of(y - 1), row_of(y), row_of(y + 1), sea, row.data(), width);
    row.front() = row.back() = kOutlet;
  }
}

}  // namespace

FlowDirections steepest_directions(const HeightField& terrain, float sea_level_m, const RunContext& run) {
  FlowDirections directions(terrain.frame());
  parallel_blocks(run, terrain.height(), 32, [&](int64_t begin, int64_t end) {
    steepest_rows(terrain, sea_level_m, directions, static_cast<int>(begin), static_cast<int>(end));
  });
  return directions;
}

FlowDirections flow_directions(const HeightField& terrain, float sea_level_m, const RunContext& run) {
  FlowDirections directions = steepest_directions(terrain, sea_level_m, run);
  drain_flats(terrain, directions, run);
  return directions;
}

int64_t count_pits(const FlowDirections& directions) {
  return std::count(directions.cells().begin(), directions.cells().end(), kPit);
}

}  // namespace seamount::geom
