#include "seamount/ops/render/light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"

namespace seamount::render {
namespace {

constexpr float kNoShadow = -1e9F;
constexpr int kLinesPerBlock = 512;

Grid<float> transposed(const Grid<float>& grid, const RunContext& run) {
  Grid<float> result(GridFrame{grid.height(), grid.width(), grid.cell_m(), 0.0, 0.0, {}});
  constexpr int kTile = 32;
  parallel_blocks(run, grid.height(), kTile, [&](int64_t begin, int64_t end) {
    for (int x0 = 0; x0 < grid.width(); x0 += kTile) {
      for (int x = x0; x < std::min(grid.width(), x0 + kTile); ++x) {
        for (auto y = static_cast<int>(begin); y < end; ++y) result(y, x) = grid(x, y);
      }
    }
  });
  return result;
}

/// One step of a block of lines: the shadow that arrives at the next row, then the higher of it and the ground there.
SEAMOUNT_VECTORISED void advance_shadow(const float* ground, float f, float drop, float* arriving, float* carried,
                                        int count) {
  for (int i = 0; i < count; ++i) {
    const float height = ground[i] + f * (ground[i + 1] - ground[i]);
    const float shadow = carried[i] - drop;
    arriving[i] = shadow;
    carried[i] = shadow > height ? shadow : height;
  }
}

/// Adds the lit share of cells from the shadows of the two lines that they lie between.
SEAMOUNT_VECTORISED void add_visibility(const float* arriving, float g, const float* ground, float sharpness,
                                        float weight, float* lit, int count) {
  for (int i = 0; i < count; ++i) {
    const float shadow = arriving[i] + g * (arriving[i + 1] - arriving[i]);
    float open = 0.5F + (ground[i] - shadow) * sharpness;
    open = open < 0.0F ? 0.0F : (open > 1.0F ? 1.0F : open);
    lit[i] += weight * open;
  }
}

/// A sweep over the rows for a sun whose bearing is nearer to the column axis: `along` = +1 where row 0 faces the sun,
/// `shear` columns a row (|shear| <= 1) away from it, `drop` metres a row.
struct Sweep {
  int along;
  double shear;
  double drop;
  float sharpness;  ///< 1 / metres over which an edge fades
  float weight;
};

void sweep_lines(const Grid<float>& ground, const Sweep& sweep, int64_t first, int64_t last, Grid<float>& lit,
                 const RunContext& run) {
  const int width = ground.width(), height = ground.height();
  const auto count = static_cast<int>(last - first) + 1;  // one line more than owned, to interpolate to
  std::vector<float> arriving(static_cast<size_t>(count) + 1, kNoShadow), carried(arriving);
  for (int step = 0; step < height; ++step) {
    run.check_cancelled();
    const int y = sweep.along > 0 ? step : height - 1 - step;
    const double offset = sweep.shear * step;
    const auto whole = static_cast<int64_t>(std::floor(offset));
    const auto fraction = static_cast<float>(offset - static_cast<double>(whole));
    const float* row = ground.row(y).data();
    // Line i passes this row at column i + offset, between cells i + whole and i + whole + 1.
    const int64_t from = std::max(first, -whole), to = std::min(last + 1, width - 1 - whole);
    if (to > from) {
      const auto skip = static_cast<size_t>(from - first);
      advance_shadow(row + from + whole, fraction, static_cast<float>(sweep.drop), arriving.data() + skip,
                     carried.data() + skip, static_cast<int>(to - from));
    }
    // Cell c lies between lines c - whole - 1 and c - whole (or on the latter where the fraction is 0).
    const int64_t lines_from = std::max(first, -whole - 1), lines_to = std::min(last, width - 1 - whole);
    if (lines_to > lines_from) {
      const auto column = static_cast<size_t>(lines_from + whole + 1);
      add_visibility(arriving.data() + (lines_from - first), 1.0F - fraction, row + column, sweep.sharpness,
                     sweep.weight, lit.row(y).data() + column, static_cast<int>(lines_to - lines_from));
    }
  }
}

void run_sweep(const Grid<float>& ground, const Sweep& sweep, Grid<float>& lit, const RunContext& run) {
  const double end = sweep.shear * ground.height();
  const auto first = static_cast<int64_t>(std::floor(std::min(0.0, -end))) - 2;
  const auto last = static_cast<int64_t>(std::ceil(ground.width() + std::max(0.0, -end))) + 2;
  parallel_blocks(run, last - first, kLinesPerBlock, [&](int64_t begin, int64_t finish) {
    sweep_lines(ground, sweep, first + begin, first + finish, lit, run);
  });
}

SEAMOUNT_VECTORISED void raise_horizon(const float* here, const float* there, float inverse_distance, float* tangent,
                                       int count) {
  for (int i = 0; i < count; ++i) {
    const float t = (there[i] - here[i]) * inverse_distance;
    tangent[i] = tangent[i] > t ? tangent[i] : t;
  }
}

SEAMOUNT_VECTORISED void add_open_sky(const float* tangent, float weight, float* sky, int count) {
  for (int i = 0; i < count; ++i) sky[i] += weight / (1.0F + tangent[i] * tangent[i]);
}

SEAMOUNT_VECTORISED void smooth_row(const float* a, const float* b, const float* c, const float* d, const float* e,
                                    float* out, int count) {
  for (int i = 0; i < count; ++i) {
    out[i] = 0.0625F * (a[i] + e[i]) + 0.25F * (b[i] + d[i]) + 0.375F * c[i];
  }
}

/// B3-spline smoothing with holes of `gap` cells (the a-trous wavelet's filter), edges clamped.
Grid<float> smoothed(const Grid<float>& grid, int gap, const RunContext& run) {
  const int width = grid.width(), height = grid.height();
  Grid<float> result(grid.frame());
  parallel_rows(run, width, height, [&](int begin, int end) {
    std::vector<float> padded(static_cast<size_t>(width + 4 * gap));
    for (int y = begin; y < end; ++y) {
      const auto at = [&](int dy) { return grid.row(std::clamp(y + dy, 0, height - 1)).data(); };
      float* middle = padded.data() + 2 * gap;
      smooth_row(at(-2 * gap), at(-gap), at(0), at(gap), at(2 * gap), middle, width);
      std::fill(padded.data(), middle, middle[0]);
      std::fill(middle + width, padded.data() + padded.size(), middle[width - 1]);
      smooth_row(middle - 2 * gap, middle - gap, middle, middle + gap, middle + 2 * gap, result.row(y).data(), width);
    }
  });
  return result;
}

constexpr int kDirections = 16;

void open_sky_row(const std::vector<Grid<float>>& smooth, int y, float cell_m, std::vector<float>& tangent,
                  std::span<float> sky) {
  const int width = smooth[0].width(), height = smooth[0].height();
  const std::span<const float> here = smooth[0].row(y);
  std::fill(sky.begin(), sky.end(), 0.0F);
  for (int direction = 0; direction < kDirections; ++direction) {
    const double angle = 2.0 * std::numbers::pi * (direction + 0.5) / kDirections;
    std::fill(tangent.begin(), tangent.end(), 0.0F);
    for (size_t scale = 0; scale < smooth.size(); ++scale) {
      const double distance = 1.5 * static_cast<double>(1 << scale);
      const auto dx = static_cast<int>(std::lround(distance * std::cos(angle)));
      const auto dy = static_cast<int>(std::lround(distance * std::sin(angle)));
      const int from = std::max(0, -dx), to = std::min(width, width - dx);
      if (y + dy < 0 || y + dy >= height || to <= from) continue;
      raise_horizon(here.data() + from, smooth[scale].row(y + dy).data() + from + dx,
                    1.0F / (cell_m * std::hypot(static_cast<float>(dx), static_cast<float>(dy))), tangent.data() + from,
                    to - from);
    }
    add_open_sky(tangent.data(), 1.0F / kDirections, sky.data(), width);
  }
}

}  // namespace

Grid<float> sun_visibility(const HeightField& surface, SunDirection sun, double softness, const RunContext& run) {
  // A disc of directions: elevations in equal steps, bearings alternating to both sides.
  constexpr std::array<std::array<double, 2>, 6> kDisc = {
      {{-0.4, -0.85}, {0.7, -0.5}, {-0.9, -0.15}, {0.9, 0.2}, {-0.6, 0.55}, {0.3, 0.9}}};
  const bool by_rows = std::abs(std::cos(sun.azimuth)) >= std::abs(std::sin(sun.azimuth));
  const Grid<float> turned = by_rows ? Grid<float>() : transposed(surface, run);
  const Grid<float>& ground = by_rows ? surface : turned;
  Grid<float> lit(ground.frame(), 0.0F);
  for (const auto& [side, up] : kDisc) {
    const double azimuth = sun.azimuth + side * softness / std::cos(sun.elevation);
    const double slope = std::tan(std::max(0.005, sun.elevation + up * softness));
    // Columns and rows towards the sun; transposing swaps them.
    const double east = std::sin(azimuth), south = -std::cos(azimuth);
    const double across = by_rows ? east : south, ahead = by_rows ? south : east;
    const double length = surface.cell_m() * std::sqrt(1.0 + (across / ahead) * (across / ahead));
    const double fade = length * slope + 1e-6;
    run_sweep(ground,
              {ahead < 0.0 ? 1 : -1, -across / std::abs(ahead), length * slope, static_cast<float>(1.0 / fade),
               1.0F / static_cast<float>(kDisc.size())},
              lit, run);
  }
  if (by_rows) return lit;
  Grid<float> result = transposed(lit, run);
  result.set_frame(surface.frame());
  return result;
}

Openness openness(const HeightField& surface, const RunContext& run) {
  const int side = std::max(surface.width(), surface.height());
  std::vector<Grid<float>> smooth;
  smooth.push_back(surface);
  // smooth[k] is blurred to about a fifth of the distance 1.5 * 2^k at which it is read.
  for (int k = 1; k < 9 && (1 << k) < side; ++k) {
    smooth.push_back(k < 3 ? smooth.back() : smoothed(smooth.back(), 1 << (k - 3), run));
  }
  size_t around = std::min<size_t>(3, smooth.size() - 1);
  while (around + 1 < smooth.size() && 0.35 * static_cast<double>(1 << around) < 0.02 * side) ++around;
  const auto radius = static_cast<float>(0.35 * static_cast<double>(1 << around) * surface.cell_m());
  Openness result{Grid<float>(surface.frame()), Grid<float>(surface.frame())};
  parallel_rows(run, surface.width(), surface.height(), [&](int begin, int end) {
    std::vector<float> tangent(static_cast<size_t>(surface.width()));
    for (int y = begin; y < end; ++y) {
      run.check_cancelled();
      open_sky_row(smooth, y, static_cast<float>(surface.cell_m()), tangent, result.sky.row(y));
      for (int x = 0; x < surface.width(); ++x) {
        result.concavity(x, y) = (smooth[around](x, y) - surface(x, y)) / radius;
      }
    }
  });
  return result;
}

HeightField reduce(const HeightField& surface, int limit, const RunContext& run) {
  if (surface.width() <= limit && surface.height() <= limit) return surface;
  const int width = (surface.width() + 1) / 2, height = (surface.height() + 1) / 2;
  GridFrame frame = surface.frame();
  frame.width = width;
  frame.height = height;
  frame.cell_m *= 2.0;
  HeightField half(frame);
  parallel_rows(run, width, height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const float* upper = surface.row(2 * y).data();
      const float* lower = surface.row(std::min(2 * y + 1, surface.height() - 1)).data();
      for (int x = 0; x < width; ++x) {
        const int left = 2 * x, right = std::min(2 * x + 1, surface.width() - 1);
        half(x, y) = 0.25F * (upper[left] + upper[right] + lower[left] + lower[right]);
      }
    }
  });
  return reduce(half, limit, run);
}

}  // namespace seamount::render
