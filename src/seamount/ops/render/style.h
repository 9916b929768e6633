// Styles of the ground: three layers of material, low, middle and high, blended by height.
//
// Source: P4 sec. 3.4 and 4.4, fig. 2(d) and 7: the Great Barrier Reef (deep floor, pale shallows, coral), stone (grass
// with stones, stony hills, green vegetation), desert (sand, sparse vegetation, sandy hills), volcano (burned stone,
// lava, outbreaks). The paper blends three pictures; here each layer is a material that varies with slope, hollows and
// noise as render.perspective's own does (materials.h), and lava runs where it would flow. `natural` is that material
// model without layers. The reef's style is about the sea floor, the others about the land.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "seamount/base/fields.h"
#include "seamount/geom/grid/height_layers.h"
#include "seamount/model/drawn.h"
#include "seamount/ops/render/materials.h"

namespace seamount::render {

/// Borders of a style on a terrain with heights over the water: those given, and for the others what the style asks
/// for. The reef's are depths; the others' are the paper's shares of the land's relief.
geom::Borders style_borders(Style style, const LayerBorders& borders, const HeightField& terrain);
geom::Borders style_borders(Style style, const LayerBorders& borders, float lowest_m, float highest_m);

/// Land of stone, desert or volcano by its layers at the point.
Material style_land(const SurfacePoint& point, Style style);
/// Sea floor of a style other than natural.
Material style_floor(const SurfacePoint& point, Style style);

/// A layer on a map: its name in the legend and its tint at the bottom and at the top of the relief.
struct StyleLayer {
  std::string_view name;
  Colour bottom, top;
};

/// Low, middle, high of a style other than natural.
const std::array<StyleLayer, 3>& style_layers(Style style);

}  // namespace seamount::render
