// terrain.paint: a field painted with a pen: masks, densities, hardness, where ground is to be made anew.
//
// Strokes are replayed in their order, each laid over what is there: v + w (value - v), with w the weight of the stroke
// (geom/brush/brush_rows.h) or of the area, times its opacity (Porter and Duff 1984, "over"). A stroke that crosses
// itself does not count twice. Where nothing is known (NaN) there is nothing to mix with: it takes the value where the
// stroke or area has at least half its weight.
#pragma once

#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/brush.h"
#include "seamount/model/grid.h"

namespace seamount::terrain {

inline constexpr const char* kOpacityHelp = "how much of what is there is covered in the middle: 0 nothing, 1 all";

struct PaintBrush : Brush {
  static constexpr std::string_view kTool = "brush", kAbout = "paints a value along a stroke";
  double value = 1.0;
  double opacity = 1.0;

  static constexpr auto fields() {
    using P = PaintBrush;
    return std::tuple_cat(Brush::fields(),
                          std::tuple(field(&P::value, "value", "", between(-1e6, 1e6), "what is painted"),
                                     field(&P::opacity, "opacity", "", between(0, 1), kOpacityHelp)));
  }
};

struct PaintArea {
  static constexpr std::string_view kTool = "area", kAbout = "fills areas with a value";
  std::vector<Polygon> polygons;
  double value = 1.0;
  double opacity = 1.0;
  double feather_m = 0.0;

  static constexpr auto fields() {
    using P = PaintArea;
    return std::tuple(field(&P::polygons, "polygons", "what is filled, at least one; an outline may cross itself"),
                      field(&P::value, "value", "", between(-1e6, 1e6), "what is painted"),
                      field(&P::opacity, "opacity", "", between(0, 1), kOpacityHelp),
                      field(&P::feather_m, "feather_m", "m", between(0, 1e6), "over which it fades beyond its edge"));
  }
};

struct PaintErase : Brush {
  static constexpr std::string_view kTool = "erase", kAbout = "brings back what was there before the step";
  double opacity = 1.0;

  static constexpr auto fields() {
    return std::tuple_cat(Brush::fields(), std::tuple(field(&PaintErase::opacity, "opacity", "", between(0, 1),
                                                            "share of the earlier strokes that goes")));
  }
};

/// In a recipe a stroke is written {"tool": "brush", "points": [[0, 0], [900, 400]], "value": 0.5}.
using PaintStroke = std::variant<PaintBrush, PaintArea, PaintErase>;

struct PaintParams {
  double base = 0.0;
  bool unknown = false;
  std::vector<PaintStroke> strokes;

  static constexpr auto fields() {
    using P = PaintParams;
    return std::tuple(
        field(&P::base, "base", "", between(-1e6, 1e6), "value where nothing is painted and no values come in"),
        field(&P::unknown, "unknown",
              "where nothing is painted nothing is known, in place of `base`: for the levelset of learned.sketch"),
        field(&P::strokes, "strokes", "what is painted, one stroke after another"));
  }
};

/// The field after all strokes, in `frame`; `values` may be null. What strokes do not touch stays to the bit. Throws
/// InvalidArgument{"strokes[i]..."} for params out of range, a stroke without points or with other than one pressure
/// each, an area without three points; IncompatibleInputs for values of another size. Parallel; 1000 strokes of 30
/// points over 256 x 256 in 30 ms. `whole`: of which the frame is a window; null: none. A cell looks at its own place.
ScalarField paint(const GridFrame& frame, const ScalarField* values, const PaintParams& params, const RunContext& run,
                  const GridFrame* whole = nullptr);

}  // namespace seamount::terrain
