// Gullies and ridges that run down the slope of a height field, without a simulation.
//
// Each octave is a field of stripes: around every point of a jittered lattice lies a compact bump that carries a cosine
// whose phase runs across the local slope, so that the stripes follow the fall line and neighbouring bumps join them
// into branching lines. The slope that turns an octave includes what coarser octaves have added: finer gullies run into
// the coarser ones as tributaries. The idea follows direction-aligned noise (Lagae et al. 2009, Tricard et al. 2019,
// John 2018); depths grow with slope and wavelength and vanish on flats, summits and ridge lines.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/reach.h"

namespace seamount::geom {

struct Gullies {
  double wavelength_m = 1200.0;  ///< distance between the largest valleys, > 0
  int octaves = 6;               ///< each has half the wavelength of the one before; in [1, 12]
  double gain = 0.5;             ///< depth of an octave over that of the one before, in (0, 1)
  double strength = 1.0;         ///< depth of valleys: 0 none, 1 as in old volcanic islands
  double branching = 1.0;        ///< how much coarser octaves turn finer ones: 0 parallel rills, 1 dendritic
  double sharpness = 0.5;        ///< 0: rounded crests, 1: knife-edge crests
};

/// Carves gullies into `height`, in metres: a coarse grid is a preview of a fine one (octaves near the cell size fade
/// out). strength_per_cell in [0, 1] scales the depth of each cell; sea floor, say, is 0. Throws IncompatibleInputs
/// unless both grids have one size, InvalidArgument for a wavelength, gain or octave count out of range.
/// Parallel; five more grids of memory; cost grows with cells, hardly with octaves.
void add_gullies(HeightField& height, Seed seed, const Gullies& gullies, const ScalarField& strength_per_cell,
                 const RunContext& run);

/// How far a cell looks where the strength is nowhere 0: a few cells of the coarsest level.
Reach gullies_reach(double wavelength_m, double cell_m);

}  // namespace seamount::geom
