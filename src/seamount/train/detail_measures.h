// How near made detail comes to that of real ground: what a dictionary's model card says.
#pragma once

#include <array>

#include "seamount/base/run_context.h"
#include "seamount/geom/grid/fourier.h"
#include "seamount/model/grid.h"

namespace seamount::train {

inline constexpr int kOctaves = 4;

/// Fourier transform of the largest square of a power of two in the middle, less its mean, faded by a Hann window.
geom::ComplexPlane spectrum_of(const HeightField& terrain, const RunContext& run);

/// Cells lower than all eight around, for each square kilometre.
double pits_per_km2(const HeightField& terrain);

struct DetailMeasures {
  std::array<double, kOctaves> octaves{};  ///< power for each octave of wavelengths, the shortest (2 to 4 cells) first
  double slope_deg = 0.0;                  ///< mean slope
  double slope_off_deg = 0.0;  ///< mean distance between the quantiles of its slopes and those of the real ground
  double rms_m = 0.0;          ///< root of the mean square of its distance to the real ground
  double pits_km2 = 0.0;       ///< cells lower than all around, for each square kilometre
  double seams = 0.0;          ///< jumps of slope where coarse cells meet, for one elsewhere
};

/// Of `made` ground beside the real one on the same cells, made from cells `factor` times as wide. Octaves are those of
/// the largest square of a power of two in the middle, less its mean, faded by a Hann window. REQUIRES: the same size,
/// at least 64 cells a side, no NaN.
DetailMeasures measure_detail(const HeightField& made, const HeightField& real, int factor, const RunContext& run);

}  // namespace seamount::train
