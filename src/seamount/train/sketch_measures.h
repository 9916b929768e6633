// How good a sketch network is on ground that it never saw: what its model card says.
//
// Each piece of held-out ground is sketched (sketch.extract), made again from the sketch, and compared with itself; so
// is what the same heights give without a network, spread by diffusion (geom/grid/pyramid_fill.h; after Hnaidi et al.
// 2010).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/ops/learned/network.h"
#include "seamount/ops/learned/sketch_guide.h"
#include "seamount/train/ground_tiles.h"

namespace seamount::train {

struct SketchMeasures {
  int pieces = 0;
  double rivers = 0;  ///< share of drawn river cells within three cells of the result's drainage network
  double ridges = 0;  ///< of ridge cells, of the network of the ground turned upside down
  double cues = 0;    ///< mean distance from a drawn height, as a share of the relief
  std::map<std::string, double> distances;  ///< of the descriptors of hydrology.describe to the real ground, means
  double pits_km2 = 0;                      ///< cells lower than all around, for each square kilometre
  double grid = 0;  ///< energy at the strides' frequencies over that beside them, for one in real ground; the worst
};

struct ComparedMeasures {
  SketchMeasures made, diffused, real;
};

/// Of `count` pieces of `size` cells of ground (read_ground() of what is held out). Throws InvalidArgument for a size
/// that is no power of two or below 128, and where no tile has such a piece. About a sixth of a second a piece of 256.
ComparedMeasures measure_sketches(const learned::Network& network, const std::vector<GroundTile>& ground,
                                  const learned::Redraw& redraw, int count, int size, Seed seed, const RunContext& run);

}  // namespace seamount::train
