// Parameters of learned.erode (erode.h).
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/model/model_file.h"
#include "seamount/ops/learned/precision.h"

namespace seamount::learned {

struct ErodeParams {
  double years = 30000;
  double strength = 1.0;
  double sea_m = 0.0;
  ModelFile model = {"erode"};
  Precision precision = Precision::automatic;

  static constexpr auto fields() {
    using P = ErodeParams;
    return std::tuple(
        field(&P::years, "years", "yr", between(0, 300000), "how long erosion acts"),
        field(&P::strength, "strength", "", between(0, 1), "share of the change that is kept, times the mask"),
        field(&P::sea_m, "sea_m", "m", between(-12000, 9000), "level of the sea; far below the terrain for none"),
        field(&P::model, "model", "network: a shipped one by its word, or a file of weights (safetensors)"),
        field(&P::precision, "precision", "of the network's sums"));
  }
};

}  // namespace seamount::learned
