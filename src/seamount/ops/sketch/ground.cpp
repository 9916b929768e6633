#include "seamount/ops/sketch/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/text.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/inland.h"

namespace seamount::sketch {
namespace {

constexpr double kSeaPart = 100.0;  // of the terrain

Mask land_of(const HeightField& heights, float sea_m) {
  Mask land(heights.frame());
  for (size_t i = 0; i < land.size(); ++i) land.data()[i] = heights.data()[i] > sea_m ? 1.0F : 0.0F;
  return land;
}

GridFrame coarser(const GridFrame& frame, double cell_m) {
  GridFrame coarse = frame;
  coarse.cell_m = std::max(frame.cell_m, cell_m);
  coarse.width = std::max(1, static_cast<int>(std::lround(frame.width_m() / coarse.cell_m)));
  coarse.height = std::max(1, static_cast<int>(std::lround(frame.height_m() / coarse.cell_m)));
  return coarse;
}

/// Cells whose neighbourhood is level and about at sea level.
Grid<uint8_t> level_cells(const HeightField& coarse, float sea_m) {
  constexpr float kNear = 5.0F, kLevel = 2.0F;  // metres
  Grid<uint8_t> level(coarse.frame(), 0);
  for (int y = 0; y < coarse.height(); ++y) {
    for (int x = 0; x < coarse.width(); ++x) {
      float low = coarse(x, y), high = low;
      for (size_t k = 0; k < 8; ++k) {
        const float z = coarse.clamped(x + geom::kFlowDx[k], y + geom::kFlowDy[k]);
        low = std::min(low, z);
        high = std::max(high, z);
      }
      level(x, y) = std::abs(coarse(x, y) - sea_m) < kNear && high - low < kLevel ? 1 : 0;
    }
  }
  return level;
}

/// Keeps the pieces (8-connected) that touch the edge and have at least so many cells. Returns the cells kept.
int64_t keep_open_water(Grid<uint8_t>& level, double least_cells) {
  constexpr uint8_t kUnseen = 1, kSeen = 2;
  const int width = level.width(), height = level.height();
  int64_t kept = 0;
  std::vector<int32_t> piece;
  for (int32_t first = 0; first < static_cast<int32_t>(level.size()); ++first) {
    if (level.data()[first] != kUnseen) continue;
    bool open = false;
    piece.assign(1, first);
    level.data()[first] = kSeen;
    for (size_t i = 0; i < piece.size(); ++i) {
      const int x = piece[i] % width, y = piece[i] / width;
      open = open || x == 0 || y == 0 || x == width - 1 || y == height - 1;
      for (size_t k = 0; k < 8; ++k) {
        const int u = x + geom::kFlowDx[k], v = y + geom::kFlowDy[k];
        if (!level.contains(u, v) || level(u, v) != kUnseen) continue;
        level(u, v) = kSeen;
        piece.push_back(v * width + u);
      }
    }
    const bool sea = open && static_cast<double>(piece.size()) >= least_cells;
    kept += sea ? static_cast<int64_t>(piece.size()) : 0;
    if (!sea)
      for (const int32_t cell : piece) level.data()[cell] = 0;
  }
  return kept;
}

/// Takes from the land what a coarse level sea covers, and its shore up to a few metres.
void drown(const HeightField& heights, const Grid<uint8_t>& sea, float sea_m, Mask& land) {
  constexpr float kShore = 5.0F;
  const GridFrame& frame = heights.frame();
  ScalarField soft(sea.frame());
  for (size_t i = 0; i < soft.size(); ++i) soft.data()[i] = sea.data()[i] != 0 ? 1.0F : 0.0F;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const float near = geom::sample_bilinear(soft, soft.frame().column(frame.x(x)), soft.frame().row(frame.y(y)));
      if (near >= 1.0F || (near > 0.0F && heights(x, y) - sea_m < kShore)) land(x, y) = 0.0F;
    }
  }
}

/// Everything that is known; what is not lies a metre below it, where flow ends.
Ground all_known(const HeightField& terrain) {
  float lowest = std::numeric_limits<float>::infinity();
  bool all = true;
  for (const float z : terrain.cells()) {
    all = all && !std::isnan(z);
    lowest = std::min(lowest, std::isnan(z) ? lowest : z);
  }
  if (all) return {terrain, {}, geom::kNoSea};
  Ground ground{terrain, Mask(terrain.frame()), std::isfinite(lowest) ? lowest - 1.0F : 0.0F};
  for (size_t i = 0; i < terrain.size(); ++i) {
    float& z = ground.heights.data()[i];
    ground.land.data()[i] = std::isnan(z) ? 0.0F : 1.0F;
    if (std::isnan(z)) z = geom::kUnknownGround;
  }
  return ground;
}

}  // namespace

double Ground::land_share() const {
  double cells = 0;
  for (const float one : land.cells()) cells += static_cast<double>(one);
  return land.empty() ? 1.0 : cells / static_cast<double>(land.size());
}

Ground find_ground(const HeightField& terrain, bool sea, const std::optional<double>& min_sea_m2,
                   const RunContext& run) {
  if (!sea) return all_known(terrain);
  Ground ground{geom::raise_inland(terrain, 0.0F, min_sea_m2, run), {}, 0.0F};
  ground.land = land_of(ground.heights, ground.sea_m);
  const GridFrame& frame = terrain.frame();
  if (1.0 - ground.land_share() < 1.0 / kSeaPart) {
    constexpr double kCoarseCells = 128.0, kBlur = 0.7;
    const GridFrame coarse = coarser(frame, std::max(frame.width_m(), frame.height_m()) / kCoarseCells);
    Grid<uint8_t> level = level_cells(blurred_land(ground, kBlur * coarse.cell_m, coarse, run), ground.sea_m);
    const double least_m2 = min_sea_m2.value_or(frame.width_m() * frame.height_m() / kSeaPart);
    const double cell_m2 = coarse.cell_m * coarse.cell_m;
    if (const int64_t cells = keep_open_water(level, least_m2 / cell_m2); cells > 0) {
      drown(ground.heights, level, ground.sea_m, ground.land);
      run.say(format_number(1e-6 * std::round(static_cast<double>(cells) * cell_m2)) +
              " km2 of level ground within 5 m of sea level are taken for sea (\"sea\": false takes them for land)");
    }
  }
  const double share = ground.land_share();
  if (share == 0.0)
    run.say("nothing lies above sea level, so nothing is drawn (\"sea\": false takes the sea floor for land)");
  if (share == 1.0) ground.land = {};
  return ground;
}

HeightField blurred_land(const Ground& ground, double blur_m, const GridFrame& frame, const RunContext& run) {
  const auto resampled = [&](ScalarField fine) {
    return frame == fine.frame() ? std::move(fine) : geom::resample(fine, frame, run);
  };
  HeightField blurred = ground.heights;
  if (ground.land.empty()) {
    geom::gaussian_blur(blurred, blur_m, run);
    return resampled(std::move(blurred));
  }
  ScalarField share = ground.land;
  for (size_t i = 0; i < blurred.size(); ++i) blurred.data()[i] = ground.is_land(i) ? blurred.data()[i] : 0.0F;
  geom::gaussian_blur(blurred, blur_m, run);
  geom::gaussian_blur(share, blur_m, run);
  run.check_cancelled();
  for (size_t i = 0; i < blurred.size(); ++i)
    blurred.data()[i] = ground.is_land(i) ? blurred.data()[i] / share.data()[i] : 0.0F;
  share = {};
  HeightField out = resampled(std::move(blurred));
  const ScalarField land = resampled(ground.land);
  const float least = std::nextafter(ground.sea_m, INFINITY);
  for (size_t i = 0; i < out.size(); ++i) {
    const float part = land.data()[i];
    out.data()[i] = part < 0.5F ? ground.sea_m : std::max(out.data()[i] / part, least);
  }
  return out;
}

}  // namespace seamount::sketch
