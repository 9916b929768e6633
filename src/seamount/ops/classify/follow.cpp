#include "seamount/ops/classify/follow.h"

#include "seamount/geom/water/follow_labels.h"
#include "seamount/model/same_size.h"

namespace seamount::classify {

LabelMap follow(const HeightField& terrain, const HeightField& before, const LabelMap& labels,
                const FollowParams& params, const RunContext& run) {
  check_params(params);
  check_same_size("before", before.frame(), terrain.frame());
  check_same_size("labels", labels.frame(), terrain.frame());
  run.check_cancelled();
  return geom::follow_labels(labels, before, terrain, static_cast<float>(params.sea_m), run);
}

}  // namespace seamount::classify
