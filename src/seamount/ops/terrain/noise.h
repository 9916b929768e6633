// terrain.noise: fractal noise as a terrain of its own, or to mix with others.
//
// Source: Perlin 1985, 2002; ridged multifractal after Musgrave 1994 (geom/scalar/noise.h). Mountains are broad noise,
// whose low ground is made level and whose heights steepen towards the crests as real hypsometries do, with valleys
// that run down its slopes (geom/water/gullies.h).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/reach.h"

namespace seamount::terrain {

enum class NoiseKind { smooth, ridged, mountains };

struct NoiseParams {
  NoiseKind kind = NoiseKind::mountains;
  std::optional<double> height_m;
  double wavelength_m = 4000.0;
  int octaves = 8;
  double gain = 0.5;
  double base_m = 0.0;

  static constexpr auto fields() {
    using P = NoiseParams;
    return std::tuple(
        field(&P::kind, "kind",
              "smooth: rolling hills, half of them below base_m; ridged: sharp crests; mountains: land with valleys "
              "that run "
              "down its slopes"),
        field(
            &P::height_m, "height_m", "m", between(0, 10000),
            "height of the noise: about half the relief of smooth noise, all of it for the others; 400 by default, of "
            "mountains a quarter of the wavelength"),
        field(&P::wavelength_m, "wavelength_m", "m", between(0.01, 1e7), "size of the largest forms"),
        field(&P::octaves, "octaves", "", between(1, 16), "layers of detail, each of half the size"),
        field(&P::gain, "gain", "", between(0.1, 0.95), "height of each layer over that of the one before"),
        field(&P::base_m, "base_m", "m", between(-12000, 9000), "height to which the noise is added"));
  }
};

/// Noise on a frame, in metres; the same terrain at any cell size but for what the cells cannot carry. Parallel, about
/// 6 ns per cell for 8 octaves on one thread; mountains about thirty times as long and five more grids of memory.
HeightField noise(const NoiseParams& params, const GridFrame& frame, Seed seed, const RunContext& run);

/// Smooth and ridged noise look at their own place, mountains as far as their valleys are long.
Reach noise_reach(const NoiseParams& params, double cell_m);

}  // namespace seamount::terrain

template <>
struct seamount::Choices<seamount::terrain::NoiseKind> {
  static constexpr std::array<std::string_view, 3> names = {"smooth", "ridged", "mountains"};
};
