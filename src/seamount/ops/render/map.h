// render.map: a topographic map: height and depth tints under a relief shading, contours, coast and reef crest, with
// legend, scale bar, north arrow and title.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/label_map.h"
#include "seamount/model/layer_borders.h"
#include "seamount/ops/render/map_drawings.h"
#include "seamount/ops/render/materials.h"

namespace seamount::render {

/// What a map's colours stand for.
enum class MapTheme { height, regions };

struct MapParams {
  int width_px = 1600;
  std::string title;
  MapTheme theme = MapTheme::height;
  Style style = Style::natural;
  LayerBorders layers;
  double shading = 1.0;
  bool contours = true;
  std::optional<double> contour_interval_m;
  bool coast = true;
  bool reef_crest = true;
  bool legend = true;
  bool scale_bar = true;
  bool north_arrow = true;
  std::optional<double> arrow_spacing_px;
  bool object_legend = true;
  std::optional<double> min_sea_m2;

  static constexpr auto fields() {
    using P = MapParams;
    return std::tuple(
        field(&P::width_px, "width_px", "", between(16, 16384), "width of the picture in pixels"),
        field(&P::title, "title", "text over the map; none if empty"),
        field(&P::theme, "theme", "what the colours show: heights and depths, or the regions of a label map"),
        field(
            &P::style, "style",
            "heights: natural tints by height, or three layers by height in a style (the reef's of the sea floor, the "
            "others of the land)"),
        field(&P::layers, "layers", "borders of the style's layers"),
        field(&P::shading, "shading", "", between(0, 1), "strength of the relief shading"),
        field(&P::contours, "contours", "draw contour lines"),
        field(&P::contour_interval_m, "contour_interval_m", "m", between(0.01, 10000),
              "height between contours; by default a round number for about twenty"),
        field(&P::coast, "coast", "draw the coast line"),
        field(&P::reef_crest, "reef_crest", "draw the outer edge of the reef; needs labels"),
        field(&P::legend, "legend", "explain the colours at the right"),
        field(&P::scale_bar, "scale_bar", "show lengths below the map"),
        field(&P::north_arrow, "north_arrow", "show where north is"),
        field(&P::arrow_spacing_px, "arrow_spacing_px", "px", between(6, 1000),
              "distance between the arrows of a current, and the length of the longest; by default forty across"),
        field(&P::object_legend, "object_legend",
              "explain the objects in a box below the map: each class with objects on it, and how many"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning));
  }
};

/// Draws the map, north up, and `drawings` over it. `labels` may be null unless the theme is regions. Throws
/// InvalidArgument for params out of range and heights that are not finite, IncompatibleInputs for labels that are
/// missing and labels, a current or a lake of another size, and for drawings or objects in another coordinate system,
/// Error where the font is missing. About 300 ns a pixel, parallel but for lines and text.
Image map(const HeightField& terrain, const LabelMap* labels, const MapDrawings& drawings, const MapParams& params,
          const RunContext& run);
/// Without drawings.
inline Image map(const HeightField& terrain, const LabelMap* labels, const MapParams& params, const RunContext& run) {
  return map(terrain, labels, MapDrawings{}, params, run);
}

}  // namespace seamount::render

namespace seamount {
template <>
struct Choices<render::MapTheme> {
  static constexpr std::array<std::string_view, 2> names = {"height", "regions"};
};
}  // namespace seamount
