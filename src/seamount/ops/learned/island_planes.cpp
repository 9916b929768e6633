#include "seamount/ops/learned/island_planes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "seamount/base/simd.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/learned/plane_lanes.h"
#include "seamount/ops/learned/plane_math.h"

namespace seamount::learned {
namespace {

constexpr double kWaves[] = {6.0, 24.0, 96.0};    ///< of noise, in cells
constexpr double kReaches_m[] = {300.0, 2500.0};  ///< over which distance to the coast is seen

/// How far inland, of a reach. One of the two distances is 0, and the other infinite where all is of one kind.
SEAMOUNT_VECTORISED void coast_row(const float* land, const float* water, float per_reach, int width, float* out) {
  for (int x = 0; x < width; ++x) out[x] = fast_tanh(per_reach * (water[x] - land[x]));
}

}  // namespace

float island_code(double z_m, double scale) {
  return static_cast<float>(std::copysign(std::sqrt(std::abs(z_m) / (1000 * scale)), z_m));
}

double island_height_m(float code, double scale) { return 1000 * scale * static_cast<double>(code) * std::abs(code); }

IslandPlanes::IslandPlanes(const IslandMap& map, Seed seed, const RunContext& run) : map_(map), seed_(seed) {
  Grid<uint8_t> land(map.frame, 0), water(map.frame, 0);
  for (size_t i = 0; i < land.size(); ++i) {
    land.data()[i] = map.shares[0].data()[i] + map.shares[1].data()[i] >= 0.5F;
    water.data()[i] = land.data()[i] == 0;
  }
  land_ = geom::distance_to(land, run);
  water_ = geom::distance_to(water, run);
}

Planes IslandPlanes::planes() const {
  Planes out{map_.frame.width, map_.frame.height, kIslandPlanes, {}};
  out.fill = [this](int begin, int end, std::span<float> values) {
    const size_t row = static_cast<size_t>(map_.frame.width) * kIslandPlanes;
    for (int y = begin; y < end; ++y) fill_row(y, values.data() + static_cast<size_t>(y - begin) * row);
  };
  return out;
}

void IslandPlanes::fill_row(int y, float* values) const {
  const int width = map_.frame.width;
  PlaneLanes lanes(width, kIslandPlanes);
  for (size_t region = 0; region < kRegionCount; ++region)
    std::copy_n(map_.shares[region].row(y).begin(), width, lanes[static_cast<int>(region)]);
  if (!map_.subsidence.empty()) std::copy_n(map_.subsidence.row(y).begin(), width, lanes[5]);
  const Seed cells = seed_.derive("island cell");
  for (int x = 0; x < width; ++x) lanes[6][x] = cell_noise(cells, x, y);
  for (int k = 0; k < 3; ++k) {
    const std::span<float> wave(lanes[7 + k], static_cast<size_t>(width));
    geom::fbm_row(seed_.derive("island noise", static_cast<uint64_t>(k)), {.wavelength_m = kWaves[k], .octaves = 1},
                  0.5, 1.0, y + 0.5, wave);
    for (float& w : wave) w /= 0.35F;
  }
  const double usual_cell = kIslandWidth_m / kIslandCells * map_.scale;
  std::fill_n(lanes[10], width, static_cast<float>(0.5 * std::log2(map_.frame.cell_m / usual_cell)));
  for (int k = 0; k < 2; ++k) {
    coast_row(land_.row(y).data(), water_.row(y).data(), static_cast<float>(1 / (kReaches_m[k] * map_.scale)), width,
              lanes[11 + k]);
  }
  const auto tell = [&](int plane, const std::optional<double>& height_m) {
    if (!height_m) return;
    std::fill_n(lanes[plane], width, island_code(*height_m, map_.scale));
    std::fill_n(lanes[plane + 1], width, 1.0F);
  };
  tell(13, map_.peak_m);
  tell(15, map_.floor_m);
  lanes.interleave(values);
}

}  // namespace seamount::learned
