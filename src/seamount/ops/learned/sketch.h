// learned.sketch: terrain from a sketch of ridges, rivers, heights, high ground and known ground in any mix.
//
// Source: P1 sec. 4 and 6.1: its synthesizers S (sketch), L (levelset) and R (eraser) are this one network with other
// kinds left out, which also lifts the limit of its sec. 7.4. Ours: what is drawn with heights is spread smoothly and
// the network adds the ground's form to it (sketch_planes.h); noise of a seed instead of dropout; cell size and relief
// are inputs; the residual at drawn heights and known ground is spread and taken away at the end, so that they are met
// exactly; made ground goes on from known ground with its slopes (geom/solve/continue_surface.h), so that pieces of
// ground in a large domain show no seam (P1 sec. 6.3); and shallow hollows that nobody drew are opened.
#pragma once

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/ops/learned/network.h"
#include "seamount/ops/learned/sketch_guide.h"
#include "seamount/ops/learned/sketch_params.h"

namespace seamount::learned {

/// What may be drawn; null: nothing of that kind. Grids are in one frame, and the result is in it.
struct SketchInputs {
  const Drawing* lines = nullptr;         ///< lines of value 0 (river) or 1 (ridge), points with heights, as of
                                          ///< sketch.extract; areas: high ground
  const Image* image = nullptr;           ///< red ridges, blue rivers, over the whole frame
  const ScalarField* river = nullptr;     ///< above a half on rivers
  const ScalarField* ridge = nullptr;     ///< above a half on ridges
  const ScalarField* levelset = nullptr;  ///< above a half on high ground, NaN where nothing is said
  const HeightField* terrain = nullptr;   ///< known ground, NaN where there is none
  const ScalarField* erase = nullptr;     ///< above a half where known ground is given up
  Redraw redraw;                          ///< for wide empty parts (sketch_guide.h); empty: they get none
};

/// Terrain in `frame`. Another seed changes detail and what was left open, not what was drawn. Throws InvalidArgument
/// for params out of range, and where the network has other planes than a sketch has; IncompatibleInputs for grids of
/// another size. Parallel; 1024 x 1024 in 0.25 s, what redraw takes besides; 80 bytes per cell.
HeightField sketch(const SketchInputs& inputs, const SketchParams& params, const Network& network,
                   const GridFrame& frame, Seed seed, const RunContext& run);

}  // namespace seamount::learned
