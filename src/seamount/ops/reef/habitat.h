// Where a reef may grow and where it starts: the lattice of reef.grow, its habitat and its kernels.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/ops/reef/aggregate.h"
#include "seamount/ops/reef/habitat_params.h"

namespace seamount::reef {

struct Habitat {
  GridFrame lattice;
  Grid<uint8_t> suitable;            ///< 1 where particles may settle
  std::vector<LatticeCell> kernels;  ///< where growth starts: suitable cells, each once
};

/// 70 m, or the cells of the frame or 1 / 2048 of its longer side where those are larger.
double default_lattice_m(const GridFrame& frame);

/// The lattice that covers a terrain with cells of lattice_m around its middle. Throws InvalidArgument for more than
/// 4096 cells a side.
GridFrame lattice_frame(const GridFrame& frame, double lattice_m);

/// What a habitat is found from besides a terrain; each may be null.
struct HabitatInputs {
  const ScalarField* habitat = nullptr;  ///< at least one half where particles may settle
  const ScalarField* start = nullptr;    ///< at least one half where random kernels lie, one at least
  const Drawing* drawing = nullptr;      ///< lines and areas where growth starts
  const Grid<uint8_t>* dry = nullptr;    ///< not 0 where there is no sea floor, whatever its height; may be empty
};

/// Depths without a bound of their own end where light does, and at the surface. Throws InvalidArgument where the upper
/// bound is darker than that.
BoundParams bounds_in_light(BoundParams bounds);

/// The lattice of `lattice_m` over a terrain in metres. Suitable is ground between bounds.low_m and bounds.high_m (no
/// bound where absent), as means over lattice cells, margin_m from the terrain's edge; unknown (NaN) and dry ground is
/// not. Kernels are the places, lines, contours and random places of `starts` and the drawing; without any of them each
/// separate piece of habitat in each 150 x 150 lattice cells has one, nearest to the middle. Throws InvalidArgument
/// for a habitat without a cell, kernels outside the terrain or the habitat and lines of which no part lies in it;
/// IncompatibleInputs for rasters that differ from the terrain in size. Linear in cells.
Habitat find_habitat(const HeightField& terrain, const HabitatInputs& in, double lattice_m, double margin_m,
                     const StartParams& starts, const BoundParams& bounds, Seed seed, const RunContext& run);

}  // namespace seamount::reef
