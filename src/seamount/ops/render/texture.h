// render.texture: the colours of the ground from straight above, to lie over a mesh: the materials of
// render.perspective.
#pragma once

#include <optional>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"
#include "seamount/model/label_map.h"
#include "seamount/model/layer_borders.h"
#include "seamount/ops/render/climate.h"
#include "seamount/ops/render/materials.h"
#include "seamount/ops/render/shown.h"

namespace seamount::render {

struct TextureParams {
  int size_px = 2048;
  double baked_light = 0.5;
  bool water = true;
  double water_level_m = 0.0;
  double water_clarity = 1.0;
  ClimateParams climate;
  std::optional<double> tree_line_m;
  std::optional<double> snow_line_m;
  Rock rock = Rock::automatic;
  Style style = Style::natural;
  LayerBorders layers;
  std::optional<double> min_sea_m2;

  static constexpr auto fields() {
    using P = TextureParams;
    return std::tuple(
        field(&P::size_px, "size_px", "", between(1, 16384), "pixels along the terrain's longer side"),
        field(&P::baked_light, "baked_light", "", between(0, 1),
              "soft light from the north-west and shade in valleys; 0 gives pure albedo for a lit renderer"),
        field(&P::water, "water", "show the sea floor as seen through the water"),
        field(&P::water_level_m, "water_level_m", "m", between(-12000, 9000), "height of the water's surface"),
        field(&P::water_clarity, "water_clarity", "", between(0.05, 5),
              "how far one sees in water, 1 in clear tropical water"),
        field(&P::climate, "climate", "what grows on the land, in the natural style"),
        field(&P::tree_line_m, "tree_line_m", "m", between(1, 9000),
              "height over the water where forest ends; by default as usual for the latitude"),
        field(&P::snow_line_m, "snow_line_m", "m", between(-1000, 20000),
              "height over the water where snow stays; by default as usual for the latitude"),
        field(&P::rock, "rock", "bare rock in the natural style; automatic is basalt in a warm sea, else granite"),
        field(&P::style, "style", "what the ground is made of: natural, or three layers by height in a style"),
        field(&P::layers, "layers", "borders of the style's layers, as heights over the water"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning));
  }
};

/// A picture of the terrain's shape whose longer side has size_px pixels, row 0 at its northern edge. Things are not
/// drawn. Throws as perspective() does. About 300 ns a pixel plus 40 ns a cell, parallel.
Image texture(const HeightField& terrain, const Shown& shown, const TextureParams& params, const RunContext& run);
/// With labels alone.
inline Image texture(const HeightField& terrain, const LabelMap* labels, const TextureParams& params,
                     const RunContext& run) {
  return texture(terrain, Shown{.labels = labels}, params, run);
}

}  // namespace seamount::render
