// Gradient noise (Perlin 1985, 2002) on a hashed lattice, and its fractal sums. Everything is a function of the place
// in metres, so a finer grid shows the same terrain. The lattice has no permutation table and repeats only after 2^32
// wavelengths; the octaves are rotated against each other, so that no direction of the lattice shows.
//
// Scalar functions in double are the plain form; rows and grids are vectorised float with the same bits on every vector
// width and agree with the plain form to 1e-5.
#pragma once

#include <span>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// A sum of octaves of noise.
struct Fbm {
  double wavelength_m = 1000.0;  ///< distance between lattice points of the first octave, > 0
  int octaves = 8;               ///< in [1, 24]
  double gain = 0.5;             ///< amplitude of an octave over that of the one before
  double lacunarity = 2.0;       ///< frequency of an octave over that of the one before, > 0
  /// Cell size of the grid that the noise is for; octaves that such cells cannot carry are faded out (to nothing where
  /// the wavelength is one cell), so a coarse grid is the average of a fine one. 0: keep all.
  double cell_m = 0.0;
};

/// Noise of unit wavelength: mean 0, deviation about 0.35, in [-1, 1], 0 at lattice points, twice differentiable.
double perlin(Seed seed, double x, double y);

/// Sum of octaves divided by the root of the sum of squared amplitudes: deviation about 0.35, seldom beyond [-1, 1].
/// x, y in metres.
double fbm(Seed seed, const Fbm& shape, double x, double y);

/// Ridged multifractal (Musgrave 1994): sharp crests where noise is 0, each octave weighted by the crest before it so
/// that valleys stay smooth. In [0, 1], crests near 1.
double ridged(Seed seed, const Fbm& shape, double x, double y);

/// out[i] = fbm(seed, shape, x0 + i dx, y). Metres. Cells that stand at the same place differ in the last bits where
/// rows begin elsewhere; of a frame's row they do not, be it a window or the whole.
void fbm_row(Seed seed, const Fbm& shape, double x0, double dx, double y, std::span<float> out);

/// Of row y of a frame.
void fbm_row(Seed seed, const Fbm& shape, const GridFrame& frame, int y, std::span<float> out);
void ridged_row(Seed seed, const Fbm& shape, const GridFrame& frame, int y, std::span<float> out);

/// out[i] += amplitude fbm(seed, shape, x0 + i dx, y).
void fbm_add_row(Seed seed, const Fbm& shape, double x0, double dx, double y, std::span<float> out, float amplitude);

/// out[i] = ridged(seed, shape, x0 + i dx, y).
void ridged_row(Seed seed, const Fbm& shape, double x0, double dx, double y, std::span<float> out);

/// fbm at every cell centre. shape.cell_m as given: set it to the frame's to fade octaves out. Parallel.
ScalarField fbm_grid(const GridFrame& frame, Seed seed, const Fbm& shape, const RunContext& run);

/// ridged at every cell centre. Parallel.
ScalarField ridged_grid(const GridFrame& frame, Seed seed, const Fbm& shape, const RunContext& run);

/// One-dimensional fbm of unit first wavelength, gain 1/2: deviation about 0.35, seldom beyond [-1, 1].
double fbm1(Seed seed, double x, int octaves);

/// Noise around a circle for outlines: fbm on a circle in the plane on which one turn passes about `frequency`
/// wavelengths; periodic in the angle (radians) without a seam. REQUIRES: frequency > 0.
double fbm_circle(Seed seed, double angle, double frequency, int octaves);

/// Weight of an octave on cells of cell_m: what averaging over a cell leaves of it, and 0 from one cell down.
double octave_weight(double wavelength_m, double cell_m);

}  // namespace seamount::geom
