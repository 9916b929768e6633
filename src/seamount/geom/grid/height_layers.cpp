#include "seamount/geom/grid/height_layers.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/surface.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

// Empirical shares of the relief, P4 sec. 3.4.
constexpr double kLow = 0.3, kLowError = 0.1, kHigh = 0.5, kHighError = 0.05;

/// Borders in float, with what varies them: metres a unit of noise and a unit of steepness move each of them.
struct Variation {
  float low, low_scale, low_noise, low_steep;
  float high, high_scale, high_noise, high_steep;
};

/// 1 / error, or a step where there is no error.
float scale_of(double error) { return error > 0.0 ? static_cast<float>(1.0 / error) : 1e30F; }

Variation make_variation(const Borders& b, double variation) {
  // Noise moves a border by about a third of what lies between the layers, or of its errors where that is less, so that
  // the middle layer is wide in places and missing in others; ground of 45 degrees by one and a half errors.
  constexpr double kNoise = 1.1, kSteep = 1.5;
  const auto noise = [&](double error) {
    return static_cast<float>(kNoise * variation * (std::min(b.high_m - b.low_m, 4.0 * error) + error));
  };
  const auto steep = [&](double error) { return static_cast<float>(kSteep * variation * error); };
  return {static_cast<float>(b.low_m),  scale_of(b.low_error_m),  noise(b.low_error_m),  steep(b.low_error_m),
          static_cast<float>(b.high_m), scale_of(b.high_error_m), noise(b.high_error_m), steep(b.high_error_m)};
}

/// 1 - distance / error, in [0, 1]; softened if asked for.
SEAMOUNT_INLINE float faded(float distance, float scale, float smooth) {
  const float linear = 1.0F - (distance > 0.0F ? distance : 0.0F) * scale;
  const float pass = linear > 0.0F ? linear : 0.0F;
  return pass + smooth * (smoothstep(pass) - pass);
}

/// Turns rows of two noises (in `low` and `middle`) and slope in degrees (in `high`) into shares.
SEAMOUNT_VECTORISED void share_row(const Variation v, float smooth, int count, const float* __restrict height,
                                   float* __restrict low, float* __restrict middle, float* __restrict high) {
  for (int i = 0; i < count; ++i) {
    const float degrees = high[i];
    const float steep = degrees < 60.0F ? degrees * (1.0F / 45.0F) : 60.0F / 45.0F;
    const float low_border = v.low + low[i] * v.low_noise - steep * v.low_steep;
    const float high_border = v.high + middle[i] * v.high_noise + steep * v.high_steep;
    const float is_low = faded(height[i] - low_border, v.low_scale, smooth);
    const float is_high = faded(high_border - height[i], v.high_scale, smooth);
    low[i] = is_low;
    middle[i] = (1.0F - is_low) * (1.0F - is_high);
    high[i] = (1.0F - is_low) * is_high;
  }
}

}  // namespace

Borders resolve_borders(const LayerBorders& borders, double bottom_m, double top_m) {
  const double relief = top_m - bottom_m;
  const Borders out{borders.low_m.value_or(bottom_m + kLow * relief), borders.low_error_m.value_or(kLowError * relief),
                    borders.high_m.value_or(bottom_m + kHigh * relief),
                    borders.high_error_m.value_or(kHighError * relief)};
  if (out.high_m < out.low_m) {
    throw InvalidArgument("high_m", format_number(out.high_m) + " m lies below the low border at " +
                                        format_number(out.low_m) + " m; give both");
  }
  return out;
}

Borders relief_borders(const LayerBorders& borders, float lowest_m, float highest_m) {
  const bool shore = lowest_m < 0.0F && highest_m > 0.0F;
  return resolve_borders(borders, shore ? 0.0 : static_cast<double>(lowest_m), static_cast<double>(highest_m));
}

Borders relief_borders(const LayerBorders& borders, const HeightField& terrain) {
  const auto [bottom, top] = std::minmax_element(terrain.cells().begin(), terrain.cells().end());
  return relief_borders(borders, *bottom, *top);
}

double error_pass(double distance, double error) { return distance < error ? 1.0 - distance / error : 0.0; }

double low_pass(double height, double border, double error) {
  return height <= border ? 1.0 : error_pass(std::abs(height - border), error);
}

double high_pass(double height, double border, double error) {
  return height >= border ? 1.0 : error_pass(std::abs(height - border), error);
}

LayerShares layer_shares(double height, const Borders& b) {
  const double low = low_pass(height, b.low_m, b.low_error_m), high = high_pass(height, b.high_m, b.high_error_m);
  return {low, (1.0 - low) * (1.0 - high), (1.0 - low) * high};
}

Reach layers_reach(const LayerBorders& borders) {
  const bool stated = borders.low_m && borders.low_error_m && borders.high_m && borders.high_error_m;
  if (!stated)
    return Reach::everything("borders are shares of the relief; low_m, low_error_m, high_m, high_error_m state them");
  return borders.variation > 0.0 ? Reach::neighbourhood(1) : Reach::place();  // of its slope
}

Layers height_layers(const HeightField& terrain, const Borders& borders, bool smooth, double variation,
                     const RunContext& run, const GridFrame* whole) {
  const GridFrame& frame = terrain.frame();
  const GridFrame& all = whole != nullptr ? *whole : frame;
  const double extent = std::max(all.width_m(), all.height_m());
  const Fbm shape{.wavelength_m = extent / 8.0, .octaves = 8, .gain = 0.62, .cell_m = frame.cell_m};
  const Seed own = Seed{}.derive("geom.height_layers");
  const bool varied = variation > 0.0;
  Layers out;
  // Two noises and the slope wait in the places of the layers.
  out.low = varied ? fbm_grid(frame, own.derive("low"), shape, run.part(0.0, 0.3)) : Mask(frame, 0.0F);
  out.middle = varied ? fbm_grid(frame, own.derive("high"), shape, run.part(0.3, 0.6)) : Mask(frame, 0.0F);
  out.high = varied ? slope_deg(terrain, run.part(0.6, 0.7)) : Mask(frame, 0.0F);
  const Variation v = make_variation(borders, variation);
  parallel_rows(run.part(0.7, 1.0), frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      share_row(v, smooth ? 1.0F : 0.0F, frame.width, terrain.row(y).data(), out.low.row(y).data(),
                out.middle.row(y).data(), out.high.row(y).data());
    }
  });
  return out;
}

}  // namespace seamount::geom
