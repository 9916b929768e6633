// What the ground is made of, by slope, height, position and label: the one material model of perspective pictures and
// of mesh textures. Colours are diffuse albedos from field spectra of such surfaces in round figures (basalt 0.08-0.12,
// forest 0.03-0.07, dry grass 0.2, coral sand 0.5-0.6), kept muted.
//
// Land: land_cover.h. Sea floor: sand on gentle floors, pale reef flat in the shallows, dark fore reef and rock where
// it falls away; where no reef grows, grey sand, weed and rock. Boundaries are broken up by noise in metres at several
// scales.
#pragma once

#include <array>
#include <string_view>

#include "seamount/base/fields.h"
#include "seamount/ops/render/climate.h"
#include "seamount/ops/render/colour.h"

namespace seamount::render {

/// What the ground is made of: the materials below, or three layers by height (style.h).
enum class Style { natural, great_barrier_reef, stone, desert, volcano };

/// Everything the material of a place depends on. Lengths in metres.
struct SurfacePoint {
  float x = 0.0F, y = 0.0F;  ///< place, from the middle of the terrain
  float z = 0.0F;            ///< height above the water
  float slope = 0.0F;        ///< tangent
  float concavity = 0.0F;    ///< of light.h
  float northness = 0.0F;    ///< slope times cosine of the aspect: positive on north faces
  float rib = 0.0F;  ///< height over the near surroundings over their size: positive on ribs, negative in gullies
  float wet = 0.0F, rain = 1.0F, shore_m = 1e3F;  ///< of ground_cover.h
  float footprint = 1.0F;                         ///< width of what is averaged
  float labelled = 0.0F;                          ///< 1: the weights below hold; 0: no label map
  float beach = 0.0F, lagoon = 0.0F, reef = 0.0F;
  float low = 0.0F, high = 0.0F;  ///< shares of a style's layers; the middle has the rest
  float lava = 0.0F;              ///< how much lava runs here, 0 to 1
  float lake = 0.0F;              ///< depth of a lake's water, whose surface is the ground's here; not above 0: no lake
  float river = 0.0F;             ///< share of the place that running water covers
  bool unknown = false;           ///< nothing is known here: blank ground
};

struct MaterialRules {
  Climate climate;
  Style style = Style::natural;
};

struct Material {
  Rgb albedo;
  float bump = 0.0F;  ///< height in metres of its small roughness (crowns, blocks)
  Rgb glow;           ///< light of its own
};

Material land_material(const SurfacePoint& point, const MaterialRules& rules);
Material floor_material(const SurfacePoint& point, const MaterialRules& rules);

/// Either, by z, mixed over the wash of the waves.
Material ground_material(const SurfacePoint& point, const MaterialRules& rules);

}  // namespace seamount::render

template <>
struct seamount::Choices<seamount::render::Style> {
  static constexpr std::array<std::string_view, 5> names = {"natural", "great_barrier_reef", "stone", "desert",
                                                            "volcano"};
};
