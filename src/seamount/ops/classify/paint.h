// classify.paint: the regions of a coral island painted with a pen, and how far its ground has sunk.
//
// Strokes are replayed in their order, later ones over earlier ones. Regions are crisp, with round ends: a cell is the
// region's where its centre lies within the radius of the stroke (geom/brush/brush_rows.h) or within an area (by the
// even-odd rule). The second output, subsidence, is painted softly: s + w (subsidence - s).
#pragma once

#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/brush.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"

namespace seamount::classify {

inline constexpr const char* kPointsHelp = "places of the pen, at least one; a spline runs through them";

struct RegionTool {
  static constexpr std::string_view kTool = "region", kAbout = "paints a region along a stroke";
  Region region = Region::mountain;
  Polyline points;
  double radius_m = 500.0;

  static constexpr auto fields() {
    using P = RegionTool;
    return std::tuple(field(&P::region, "region", "what is painted"), field(&P::points, "points", kPointsHelp),
                      field(&P::radius_m, "radius_m", "m", between(0.01, 1e6), "half the width of the stroke"));
  }
};

struct AreaTool {
  static constexpr std::string_view kTool = "area", kAbout = "fills areas with a region";
  Region region = Region::mountain;
  std::vector<Polygon> polygons;

  static constexpr auto fields() {
    using P = AreaTool;
    return std::tuple(field(&P::region, "region", "what is painted"),
                      field(&P::polygons, "polygons", "what is filled, at least one; an outline may cross itself"));
  }
};

struct SinkTool : Brush {
  static constexpr std::string_view kTool = "sink", kAbout = "paints how far the ground has sunk";
  double subsidence = 1.0;

  static constexpr auto fields() {
    return std::tuple_cat(Brush::fields(), std::tuple(field(&SinkTool::subsidence, "subsidence", "", between(0, 1),
                                                            "in the middle of the stroke: 0 not at all, 1 wholly")));
  }
};

struct EraseTool {
  static constexpr std::string_view kTool = "erase", kAbout = "brings back what was there before the step";
  Polyline points;
  double radius_m = 500.0;

  static constexpr auto fields() {
    using P = EraseTool;
    return std::tuple(field(&P::points, "points", kPointsHelp),
                      field(&P::radius_m, "radius_m", "m", between(0.01, 1e6), "half the width of the stroke"));
  }
};

/// In a recipe a stroke is written {"tool": "region", "region": "beach", "points": [[0, 0], [900, 400]]}.
using PaintStroke = std::variant<RegionTool, AreaTool, SinkTool, EraseTool>;

struct PaintParams {
  Region base = Region::abyss;
  std::vector<PaintStroke> strokes;

  static constexpr auto fields() {
    using P = PaintParams;
    return std::tuple(field(&P::base, "base", "region where nothing is painted and no labels come in"),
                      field(&P::strokes, "strokes", "what is painted, one stroke after another"));
  }
};

struct Painted {
  LabelMap labels;
  ScalarField subsidence;  ///< in [0, 1]
};

/// Labels and subsidence after all strokes, in `frame`. `labels` and `subsidence` may be null: `base`, and 0. Throws
/// InvalidArgument{"strokes[i]..."} for params out of range, a stroke without points, an area without three points;
/// IncompatibleInputs for inputs of another size. Parallel; cost follows the cells under strokes. `whole`: of which the
/// frame is a window; null: none. A cell looks at its own place.
Painted paint(const GridFrame& frame, const LabelMap* labels, const ScalarField* subsidence, const PaintParams& params,
              const RunContext& run, const GridFrame* whole = nullptr);

}  // namespace seamount::classify
