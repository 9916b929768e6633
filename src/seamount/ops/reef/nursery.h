// Where a reef may grow and where it starts: the lattice of reef.grow, its habitat and its kernels.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/ops/reef/aggregate.h"
#include "seamount/ops/reef/grow_params.h"

namespace seamount::reef {

struct Nursery {
  GridFrame lattice;
  Grid<uint8_t> habitat;      ///< 1 where particles may settle
  std::vector<Site> kernels;  ///< within the habitat, each once
};

/// The lattice that covers a terrain with cells of lattice_m around its middle. Throws InvalidArgument for more than
/// 4096 cells a side.
GridFrame lattice_frame(const GridFrame& frame, double lattice_m);

/// Habitat: `habitat` (may be null) at least one half and heights between habitat_low_m and habitat_high_m, as means
/// over lattice cells, margin_m from the terrain's edge. Kernels: the places, lines, contours and random places of the
/// params, the lines and areas of `drawing` (may be null); without any of them the open water nearest to the middle.
/// `start` (may be null): where random kernels lie, one at least. Throws InvalidArgument{habitat or kernels ...} for a
/// habitat without a cell, kernels outside the terrain or the habitat, lines of which no part lies in it;
/// IncompatibleInputs for rasters that differ from the terrain in size.
Nursery prepare_nursery(const HeightField& terrain, const ScalarField* habitat, const ScalarField* start,
                        const Drawing* drawing, double margin_m, const GrowParams& params, Seed seed,
                        const RunContext& run);

}  // namespace seamount::reef
