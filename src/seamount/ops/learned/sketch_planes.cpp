#include "seamount/ops/learned/sketch_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/grid/pyramid_fill.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::learned {
namespace {

constexpr float kLine = 1.5F, kNear = 14.0F;     ///< reach of a line's two planes, in cells
constexpr float kPoint = 2.0F, kAround = 10.0F;  ///< of a cue's two planes
constexpr float kPrior = 0.35F;                  ///< mean ground, as a share of the relief
constexpr float kNothing = 15.0F;                ///< exponent below which a plane is 0
constexpr double kWaves[] = {6.0, 24.0, 96.0};   ///< of noise, in cells
constexpr double kCellOfZero = 60.0, kReliefOfZero = 1000.0;

ScalarField cells_to(const Grid<uint8_t>& cells, const RunContext& run) {
  if (cells.empty()) return {};
  ScalarField distance = geom::distance_to(cells, run);
  const auto per_cell = static_cast<float>(1.0 / cells.cell_m());
  for (float& d : distance.cells()) d *= per_cell;
  return distance;
}

/// exp(-x), and 0 where nothing of it is left.
float fading(float x) { return x > kNothing ? 0.0F : std::exp(-x); }
float line_near(float d) { return fading((d * d) / (2 * kLine * kLine)); }

}  // namespace

SketchPlanes::SketchPlanes(const SketchMap& map, Seed seed, const RunContext& run)
    : map_(map),
      seed_(seed),
      river_(cells_to(map.river, run)),
      ridge_(cells_to(map.ridge, run)),
      cue_(cells_to(map.cue, run)),
      base_(map.frame, 0.0F) {
  if (!(map.relief_m > 0)) throw InvalidArgument("relief_m", "must be above 0");
  Grid<float> weight(map.frame, 0.0F);
  const auto share = [&](float z) { return static_cast<float>((z - map.low_m) / map.relief_m); };
  const bool cues = !map.cue.empty(), known = !map.known_m.empty();
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < map.frame.width; ++x) {
        if (known && !std::isnan(map.known_m(x, y))) {
          base_(x, y) = share(map.known_m(x, y));
          weight(x, y) = 1;
        } else if (cues && map.cue(x, y) != 0) {
          base_(x, y) = share(map.cue_m(x, y));
          weight(x, y) = 1;
        }
      }
    }
  });
  geom::pyramid_fill(base_, weight, {.prior = kPrior, .fade = 0.75F}, run);
  if (cues) geom::nearest_feature(map.cue, nearest_cue_, run);
}

Planes SketchPlanes::planes() const {
  Planes out{map_.frame.width, map_.frame.height, kSketchPlanes, {}};
  out.fill = [this](int begin, int end, std::span<float> values) {
    const size_t row = static_cast<size_t>(map_.frame.width) * kSketchPlanes;
    for (int y = begin; y < end; ++y) fill_row(y, values.data() + static_cast<size_t>(y - begin) * row);
  };
  return out;
}

void SketchPlanes::fill_row(int y, float* values) const {
  const int width = map_.frame.width;
  std::vector<float> waves(static_cast<size_t>(3 * width), 0.0F);
  for (int k = 0; k < 3; ++k) {  // in cells, so that noise looks the same to the network at any cell size
    const std::span<float> wave = std::span(waves).subspan(static_cast<size_t>(k * width), static_cast<size_t>(width));
    geom::fbm_row(seed_.derive("sketch noise", static_cast<uint64_t>(k)), {.wavelength_m = kWaves[k], .octaves = 1},
                  0.5, 1.0, y + 0.5, wave);
  }
  const Seed cells = seed_.derive("sketch cell");
  const auto scale = static_cast<float>(0.5 * std::log2(map_.frame.cell_m / kCellOfZero));
  const auto relief = static_cast<float>(0.5 * std::log2(map_.relief_m / kReliefOfZero));
  for (int x = 0; x < width; ++x) {
    float* const p = values + static_cast<size_t>(x) * kSketchPlanes;
    std::fill(p, p + kSketchPlanes, 0.0F);
    if (!river_.empty()) {
      const float d = river_(x, y);
      p[0] = line_near(d);
      p[1] = fading(d / kNear);
    }
    if (!ridge_.empty()) {
      const float d = ridge_(x, y);
      p[2] = line_near(d);
      p[3] = fading(d / kNear);
    }
    if (!cue_.empty() && nearest_cue_(x, y) >= 0) {
      const float d = cue_(x, y);
      const float z = map_.cue_m.data()[nearest_cue_(x, y)];
      p[4] = fading((d * d) / (2 * kPoint * kPoint));
      p[5] = static_cast<float>((z - map_.low_m) / map_.relief_m) * fading(d / kAround);
    }
    if (!map_.level.empty()) p[6] = map_.level(x, y);
    p[9] = base_(x, y);
    p[10] = cell_noise(cells, x, y);
    for (int k = 0; k < 3; ++k) p[11 + k] = waves[static_cast<size_t>(k * width + x)] / 0.35F;
    p[14] = scale;
    p[15] = relief;
  }
}

}  // namespace seamount::learned
