// learned.erode: years of erosion in a moment, as erosion.run would make them in rock of even hardness.
//
// Source: ours. An estimate of what rivers do (erode_planes.h) and a network that adds what
// it misses: valleys of all sizes, slopes that fail, creep, fans. Deterministic: a run of erosion.run is one of many
// that its seeds would make, and this is near all of them.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/ops/learned/erode_params.h"
#include "seamount/ops/learned/network.h"

namespace seamount::learned {

/// How far around a cell lies the ground that bounds it, in cells: about this, at most twice.
inline constexpr int kErodeReach = 16;

/// The eroded terrain. No cell comes to lie below the lowest or above the highest ground within 2 kErodeReach cells, so
/// level ground stays and relief never grows, however often it is repeated; nothing changes where the mask is 0, or in
/// 0 years. The network moves ground about and makes none: the mean falls by what the estimate's rivers carry off, but
/// for what those bounds hold back. `mask` may be null; values beyond [0, 1] count as the nearer end. Throws
/// InvalidArgument for params out of range, heights that are not finite, and a network of other planes;
/// IncompatibleInputs for a mask of another size. In parallel but for the ways of water; the same bytes on any number
/// of threads; 1024 x 1024 in 0.5 s of one processor; 100 bytes per cell.
HeightField erode(const HeightField& terrain, const Mask* mask, const ErodeParams& params, const Network& network,
                  const RunContext& run);

}  // namespace seamount::learned
