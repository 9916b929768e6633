// classify.follow: the labels of a terrain after any change to it, by what its regions were before: the way for steps
// that do not hand labels on themselves (terrain.smooth, terrain.blend, glacier.run ...).
//
// Land is beach or mountain, sea is lagoon, reef or abyss; beaches follow the coast (geom/water/follow_labels.h).
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount::classify {

struct FollowParams {
  double sea_m = 0.0;

  static constexpr auto fields() {
    return std::tuple(field(&FollowParams::sea_m, "sea_m", "m", between(-12000, 9000), "level of the sea"));
  }
};

/// The labels of `terrain`, of which `before` and `labels` are what it was. Throws InvalidArgument for params out of
/// range, IncompatibleInputs for rasters of another size. Cost as geom::follow_labels.
LabelMap follow(const HeightField& terrain, const HeightField& before, const LabelMap& labels,
                const FollowParams& params, const RunContext& run);

}  // namespace seamount::classify
