#include "seamount/ops/learned/island_planes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::learned {
namespace {

constexpr double kWaves[] = {6.0, 24.0, 96.0};    ///< of noise, in cells
constexpr double kReaches_m[] = {300.0, 2500.0};  ///< over which distance to the coast is seen

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
  std::vector<float> waves(static_cast<size_t>(3 * width), 0.0F);
  for (int k = 0; k < 3; ++k) {
    geom::fbm_row(seed_.derive("island noise", static_cast<uint64_t>(k)), {.wavelength_m = kWaves[k], .octaves = 1},
                  0.5, 1.0, y + 0.5,
                  std::span(waves).subspan(static_cast<size_t>(k * width), static_cast<size_t>(width)));
  }
  const Seed cells = seed_.derive("island cell");
  const double usual_cell = kIslandWidth_m / kIslandCells * map_.scale;
  const auto cell = static_cast<float>(0.5 * std::log2(map_.frame.cell_m / usual_cell));
  for (int x = 0; x < width; ++x) {
    float* const p = values + static_cast<size_t>(x) * kIslandPlanes;
    std::fill(p, p + kIslandPlanes, 0.0F);
    for (size_t region = 0; region < kRegionCount; ++region) p[region] = map_.shares[region](x, y);
    p[5] = map_.subsidence.empty() ? 0.0F : map_.subsidence(x, y);
    p[6] = cell_noise(cells, x, y);
    for (int k = 0; k < 3; ++k) p[7 + k] = waves[static_cast<size_t>(k * width + x)] / 0.35F;
    p[10] = cell;
    const double inland = std::clamp<double>(water_(x, y) - land_(x, y), -1e9, 1e9);
    for (int k = 0; k < 2; ++k) p[11 + k] = static_cast<float>(std::tanh(inland / (kReaches_m[k] * map_.scale)));
    if (map_.peak_m) {
      p[13] = island_code(*map_.peak_m, map_.scale);
      p[14] = 1;
    }
    if (map_.floor_m) {
      p[15] = island_code(*map_.floor_m, map_.scale);
      p[16] = 1;
    }
  }
}

}  // namespace seamount::learned
