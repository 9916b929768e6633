#include "seamount/train/detail_measures.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include "seamount/geom/grid/fourier.h"

namespace seamount::train {
namespace {

constexpr int kQuantiles = 200;

std::array<double, kOctaves> octaves_of(const HeightField& terrain, const RunContext& run) {
  const geom::ComplexPlane plane = spectrum_of(terrain, run);
  const int n = plane.n;
  std::array<double, kOctaves> power{};
  for (int v = 0; v < n; ++v) {
    for (int u = 0; u < n; ++u) {
      const double waves = std::hypot(std::min(u, n - u), std::min(v, n - v));
      if (waves == 0.0) continue;
      const int octave = std::max(0, static_cast<int>(std::floor(std::log2(0.5 * n / waves))));
      if (octave >= kOctaves) continue;
      const size_t i = plane.at(u, v);
      power[octave] += static_cast<double>(plane.re[i]) * plane.re[i] + static_cast<double>(plane.im[i]) * plane.im[i];
    }
  }
  return power;
}

std::vector<float> sorted_slopes(const HeightField& terrain) {
  std::vector<float> slopes;
  const auto over = static_cast<float>(2.0 * terrain.cell_m());
  for (int y = 1; y + 1 < terrain.height(); ++y) {
    for (int x = 1; x + 1 < terrain.width(); ++x) {
      const float east = (terrain(x + 1, y) - terrain(x - 1, y)) / over;
      const float south = (terrain(x, y + 1) - terrain(x, y - 1)) / over;
      slopes.push_back(std::atan(std::hypot(east, south)) * 180.0F / std::numbers::pi_v<float>);
    }
  }
  std::sort(slopes.begin(), slopes.end());
  return slopes;
}

/// Mean jump of slope between columns where x is a multiple of `factor`, over that elsewhere.
double seams_of(const HeightField& terrain, int factor) {
  double at[2] = {0.0, 0.0};
  int64_t count[2] = {0, 0};
  for (int y = 0; y < terrain.height(); ++y) {
    for (int x = 2; x + 1 < terrain.width(); ++x) {
      const float before = terrain(x - 1, y) - terrain(x - 2, y), after = terrain(x + 1, y) - terrain(x, y);
      const int seam = x % factor == 0 ? 1 : 0;
      at[seam] += std::abs(after - before);
      ++count[seam];
    }
  }
  return at[0] > 0.0 ? (at[1] / static_cast<double>(count[1])) / (at[0] / static_cast<double>(count[0])) : 1.0;
}

}  // namespace

geom::ComplexPlane spectrum_of(const HeightField& terrain, const RunContext& run) {
  const int n = static_cast<int>(std::bit_floor(static_cast<unsigned>(std::min(terrain.width(), terrain.height()))));
  const int x0 = (terrain.width() - n) / 2, y0 = (terrain.height() - n) / 2;
  double mean = 0.0;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) mean += terrain(x0 + x, y0 + y) / (static_cast<double>(n) * n);
  const auto hann = [n](int i) { return std::pow(std::sin(std::numbers::pi * (i + 0.5) / n), 2); };
  geom::ComplexPlane plane(n), scratch(n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      plane.re[plane.at(x, y)] = static_cast<float>((terrain(x0 + x, y0 + y) - mean) * hann(x) * hann(y));
  geom::transform(plane, scratch, run);
  return plane;
}

double pits_per_km2(const HeightField& terrain) {
  int64_t pits = 0;
  for (int y = 1; y + 1 < terrain.height(); ++y) {
    for (int x = 1; x + 1 < terrain.width(); ++x) {
      bool lowest = true;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          lowest = lowest && ((dx == 0 && dy == 0) || terrain(x, y) < terrain(x + dx, y + dy));
      pits += lowest ? 1 : 0;
    }
  }
  return 1e6 * static_cast<double>(pits) / (terrain.frame().width_m() * terrain.frame().height_m());
}

DetailMeasures measure_detail(const HeightField& made, const HeightField& real, int factor, const RunContext& run) {
  DetailMeasures measures;
  measures.octaves = octaves_of(made, run);
  const std::vector<float> slopes = sorted_slopes(made), real_slopes = sorted_slopes(real);
  for (const float slope : slopes) measures.slope_deg += slope / static_cast<double>(slopes.size());
  for (int q = 0; q <= kQuantiles; ++q) {
    const size_t i = (slopes.size() - 1) * static_cast<size_t>(q) / kQuantiles;
    measures.slope_off_deg += std::abs(slopes[i] - real_slopes[i]) / (kQuantiles + 1.0);
  }
  for (size_t i = 0; i < made.size(); ++i) measures.rms_m += std::pow(made.data()[i] - real.data()[i], 2);
  measures.rms_m = std::sqrt(measures.rms_m / static_cast<double>(made.size()));
  measures.pits_km2 = pits_per_km2(made);
  measures.seams = seams_of(made, factor);
  return measures;
}

}  // namespace seamount::train
