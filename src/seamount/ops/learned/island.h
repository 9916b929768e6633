// learned.island: terrain from a map of the regions of a coral island, painted, scanned or made.
//
// Source: P0 sec. 1.5 to 1.7, eq. 1.16 ff.: pix2pix of hue (region) and value (subsidence). Ours: shares of regions
// instead of hues, so that blurred borders and mixed colours mean what they show; any size, since the network is
// evaluated over the whole map (network.h); noise of a seed; painted coasts are met. P0's future work, the wind field
// and the reef's depth, are inputs that may be left out; the wind bends the map, and the network does not see its
// field, from which it learned nothing that the bent map does not show (models/island.md).
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/model/model_file.h"
#include "seamount/ops/learned/island_planes.h"
#include "seamount/ops/learned/network.h"
#include "seamount/ops/learned/precision.h"

namespace seamount::learned {

struct IslandParams {
  FilePath painting;
  double subsidence = 0.0;
  std::optional<double> scale;
  std::optional<double> peak_m;
  std::optional<double> floor_m;
  std::optional<double> reef_depth_m;
  std::vector<Stroke> strokes;
  ModelFile model = {"island"};
  Precision precision = Precision::automatic;

  static constexpr auto fields() {
    using P = IslandParams;
    return std::tuple(
        field(&P::painting, "painting",
              "picture over the domain in the colours of regions: mountain yellow, beach green, lagoon "
              "cyan, reef blue, abyss red; the "
              "darker, the more it has sunk"),
        field(&P::subsidence, "subsidence", "", between(0, 1),
              "how far the island has sunk, where no painting and no field says"),
        field(&P::scale, "scale", "", between(0.02, 4),
              "size of everything, heights too, against islands shown on 20 km; if absent, the domain's "
              "longer side over 20 km, at most 1"),
        field(&P::peak_m, "peak_m", "m", between(1, 9000),
              "height of the highest summit, met exactly; if absent, as the network sees fit"),
        field(&P::floor_m, "floor_m", "m", between(-12000, -1),
              "height of the deepest sea floor, a two hundredth of it aside; if absent, as the network sees fit"),
        field(&P::reef_depth_m, "reef_depth_m", "m", between(0, 100),
              "depth of the reef's crest where nothing has sunk; if absent, as the network sees fit"),
        field(&P::strokes, "strokes",
              "strokes of wind and waves along which the map is bent first, as island.wind does: points, width_m "
              "(deviation of the falloff), strength_m (displacement on the stroke)"),
        field(&P::model, "model", "network: a shipped one by its word, or a file of weights (safetensors)"),
        field(&P::precision, "precision", "of the network's sums"));
  }
};

/// Shares of hard labels: those of the cell and its eight neighbours, so that a border is as soft as a painted one.
std::array<Mask, kRegionCount> shares_of(const LabelMap& labels, const RunContext& run);

/// Shares in which a cell whose main region at most one of its neighbours has is the mean of its neighbours: what a
/// scanner or a slip of the hand leaves. Parallel, linear.
std::array<Mask, kRegionCount> without_specks(const std::array<Mask, kRegionCount>& shares, const RunContext& run);

/// Heights in the map's frame. Throws InvalidArgument{"model"} where the network has other planes than an island has.
/// Parallel; the same seed gives the same terrain; 1024 x 1024 in 0.2 s; 80 bytes per cell.
HeightField island(const IslandMap& map, const Network& network, Seed seed, const RunContext& run);

}  // namespace seamount::learned
