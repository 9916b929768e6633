#include "seamount/ops/learned/sketch_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/geom/grid/pyramid_fill.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/learned/plane_lanes.h"
#include "seamount/ops/learned/plane_math.h"

namespace seamount::learned {
namespace {

constexpr float kLine = 1.5F, kNear = 14.0F;      ///< reach of a line's two planes, in cells
constexpr float kPoint = 2.0F, kAround = 10.0F;   ///< of a cue's two planes
constexpr float kPrior = 0.35F;                   ///< mean ground, as a share of the relief
constexpr float kNothing = 15.0F, kLast = 3e-7F;  ///< exponent from which on a plane is 0, and what is left there
constexpr double kWaves[] = {6.0, 24.0, 96.0};    ///< of noise, in cells
constexpr double kCellOfZero = 60.0, kReliefOfZero = 1000.0;

void count_cells(ScalarField& distance, const RunContext& run) {
  const auto per_cell = static_cast<float>(1.0 / distance.cell_m());
  parallel_rows(run, distance.width(), distance.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (float& d : distance.row(y)) d *= per_cell;
  });
}

ScalarField cells_to(const Grid<uint8_t>& cells, const RunContext& run) {
  if (cells.empty()) return {};
  ScalarField distance = geom::distance_to(cells, run);
  count_cells(distance, run);
  return distance;
}

/// exp(-x), and 0 where nothing of it is left. No branch: vectors have none.
SEAMOUNT_INLINE float fading(float x) { return std::max(0.0F, fast_exp(-x) - kLast); }

/// The planes of a line: close to it, and around it.
SEAMOUNT_VECTORISED void line_row(const float* distance, int width, float* close, float* around) {
  for (int x = 0; x < width; ++x) {
    const float d = distance[x];
    close[x] = fading(d * d * (1 / (2 * kLine * kLine)));
    around[x] = fading(d * (1 / kNear));
  }
}

/// Those of heights; `shares`: of the nearest.
SEAMOUNT_VECTORISED void cue_row(const float* distance, const float* shares, int width, float* close, float* around) {
  for (int x = 0; x < width; ++x) {
    const float d = distance[x];
    close[x] = fading(d * d * (1 / (2 * kPoint * kPoint)));
    around[x] = shares[x] * fading(d * (1 / kAround));
  }
}

}  // namespace

SketchPlanes::SketchPlanes(const SketchMap& map, Seed seed, const RunContext& run)
    : map_(map), seed_(seed), river_(cells_to(map.river, run)), ridge_(cells_to(map.ridge, run)), base_(map.frame) {
  if (!(map.relief_m > 0)) throw InvalidArgument("relief_m", "must be above 0");
  Grid<float> weight(map.frame);
  const auto share = [&](float z) { return static_cast<float>((z - map.low_m) / map.relief_m); };
  const bool cues = !map.cue.empty(), known = !map.known_m.empty();
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < map.frame.width; ++x) {
        base_(x, y) = weight(x, y) = 0;
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
  geom::pyramid_fill(base_, std::move(weight), {.prior = kPrior, .fade = 0.75F}, run);
  if (!cues) return;
  geom::nearest_feature(map.cue, nearest_cue_, cue_, run);
  count_cells(cue_, run);
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
  PlaneLanes lanes(width, kSketchPlanes);
  if (!river_.empty()) line_row(river_.row(y).data(), width, lanes[0], lanes[1]);
  if (!ridge_.empty()) line_row(ridge_.row(y).data(), width, lanes[2], lanes[3]);
  if (!cue_.empty()) {
    std::vector<float> shares(static_cast<size_t>(width), 0.0F);
    for (int x = 0; x < width; ++x) {
      const int32_t nearest = nearest_cue_(x, y);
      if (nearest < 0 || cue_(x, y) > kNothing * kAround) continue;
      shares[static_cast<size_t>(x)] = static_cast<float>((map_.cue_m.data()[nearest] - map_.low_m) / map_.relief_m);
    }
    cue_row(cue_.row(y).data(), shares.data(), width, lanes[4], lanes[5]);
  }
  if (!map_.level.empty()) std::copy_n(map_.level.row(y).begin(), width, lanes[6]);
  std::copy_n(base_.row(y).begin(), width, lanes[9]);
  const Seed cells = seed_.derive("sketch cell");
  for (int x = 0; x < width; ++x) lanes[10][x] = cell_noise(cells, x, y);
  for (int k = 0; k < 3; ++k) {  // in cells, so that noise looks the same to the network at any cell size
    const std::span<float> wave(lanes[11 + k], static_cast<size_t>(width));
    geom::fbm_row(seed_.derive("sketch noise", static_cast<uint64_t>(k)), {.wavelength_m = kWaves[k], .octaves = 1},
                  0.5, 1.0, y + 0.5, wave);
    for (float& w : wave) w /= 0.35F;
  }
  std::fill_n(lanes[14], width, static_cast<float>(0.5 * std::log2(map_.frame.cell_m / kCellOfZero)));
  std::fill_n(lanes[15], width, static_cast<float>(0.5 * std::log2(map_.relief_m / kReliefOfZero)));
  lanes.interleave(values);
}

}  // namespace seamount::learned
