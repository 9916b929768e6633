// Parameters of learned.sketch, and the sketch that stands in them.
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/drawn.h"
#include "seamount/model/model_file.h"
#include "seamount/ops/learned/precision.h"

namespace seamount::learned {

struct SketchedLine {
  Polyline points;
  static constexpr auto fields() { return std::tuple(field(&SketchedLine::points, "points", "the line's points")); }
};

struct SketchedHeight {
  double x_m = 0.0, y_m = 0.0, height_m = 0.0;
  static constexpr auto fields() {
    using P = SketchedHeight;
    return std::tuple(field(&P::x_m, "x_m", "m", between(-1e8, 1e8), "east of the domain's middle, or in its system"),
                      field(&P::y_m, "y_m", "m", between(-1e8, 1e8), "north of it"),
                      field(&P::height_m, "height_m", "m", between(-12000, 9000), "height of the ground there"));
  }
};

struct SketchParams {
  std::vector<SketchedLine> ridges, rivers;
  std::vector<SketchedHeight> heights;
  std::optional<double> low_m;
  std::optional<double> relief_m;
  double adherence = 1.0;
  ModelFile model = {"sketch"};
  Precision precision = Precision::automatic;

  static constexpr auto fields() {
    using P = SketchParams;
    return std::tuple(
        field(&P::ridges, "ridges", "crest lines"), field(&P::rivers, "rivers", "rivers, in any direction"),
        field(&P::heights, "heights", "places whose height is given: summits, basins, passes"),
        field(&P::low_m, "low_m", "m", between(-12000, 9000),
              "height of the low ground; if absent, the lowest that is drawn or known, or, where that is near the "
              "highest, two fifths of a usual relief below it (of the highest itself if less); 0 where nothing has a "
              "height"),
        field(&P::relief_m, "relief_m", "m", between(1, 12000),
              "how far high ground rises above it; if absent, as heights and known ground say, else what is usual for "
              "mountains of the domain's width"),
        field(&P::adherence, "adherence", "", between(0, 1),
              "how closely what is drawn is met: 1 heights exactly, and lines carved and sharpened a little; 0 as the "
              "network sees fit"),
        field(&P::model, "model", "network: a shipped one by its word, or a file of weights (safetensors)"),
        field(&P::precision, "precision", "of the network's sums"));
  }
};

}  // namespace seamount::learned
