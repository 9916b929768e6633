#include "seamount/ops/render/style.h"

#include <algorithm>
#include <cmath>

#include "seamount/ops/render/detail_noise.h"

namespace seamount::render {
namespace {

/// Noise at the scales of the materials, and the layers with their borders broken up below the grid's cells.
struct Place {
  float broad, medium, fine;
  float low, high;
};

Place look_at(const SurfacePoint& p) {
  Place n{detail_noise(211, p.x, p.y, 2600.0F, 4, 0.55F, p.footprint).value,
          detail_noise(223, p.x, p.y, 150.0F, 3, 0.60F, p.footprint).value,
          detail_noise(237, p.x, p.y, 16.0F, 3, 0.60F, p.footprint).value, 0.0F, 0.0F};
  const auto ragged = [&](float share, float sign) {
    return clamp01(share + sign * 4.0F * share * (1.0F - share) * (0.45F * n.medium + 0.40F * n.fine));
  };
  n.low = ragged(p.low, 1.0F);
  n.high = std::min(1.0F - n.low, ragged(p.high, -1.0F));
  return n;
}

Rgb layered(const Place& n, Rgb low, Rgb middle, Rgb high) {
  return n.low * low + n.high * high + (1.0F - n.low - n.high) * middle;
}

float layered(const Place& n, float low, float middle, float high) {
  return n.low * low + n.high * high + (1.0F - n.low - n.high) * middle;
}

/// Steepness as the eye takes it: broken up, and more on noses than in hollows.
float unevenness(const SurfacePoint& p, const Place& n) {
  return p.slope + 0.24F * n.medium + 0.14F * n.fine - 0.5F * std::clamp(p.concavity, -0.25F, 0.25F);
}

/// Beds that wander with the broad noise: 0 to 1, one half from afar.
float beds(const SurfacePoint& p, const Place& n, float thickness) {
  const float near = ramp(0.45F, 0.15F, p.footprint / thickness);
  return 0.5F + 0.5F * near *
                    std::sin(6.2832F * (p.z + 1.5F * thickness * n.broad + 0.25F * thickness * n.medium) / thickness);
}

/// Share of the ground under scattered things of the size of the fine noise; from afar their mean.
float scattered(const SurfacePoint& p, float noise, float cover) {
  const float threshold = 0.42F - 0.75F * cover;
  const float near = ramp(threshold, threshold + 0.14F, noise);
  return mix(near, cover, ramp(3.0F, 9.0F, p.footprint));
}

Material stone_land(const SurfacePoint& p) {
  constexpr Rgb kGrass{0.066F, 0.080F, 0.031F}, kDryGrass{0.168F, 0.146F, 0.076F};
  constexpr Rgb kStone{0.215F, 0.200F, 0.180F}, kDarkStone{0.088F, 0.080F, 0.072F}, kScree{0.190F, 0.174F, 0.152F};
  constexpr Rgb kGreen{0.046F, 0.064F, 0.024F}, kHeath{0.076F, 0.080F, 0.034F};
  const Place n = look_at(p);
  const float hollow = std::clamp(p.concavity, -0.25F, 0.25F);
  const Rgb rock = mix(kDarkStone, kStone,
                       clamp01(0.45F + 0.30F * (beds(p, n, 70.0F) - 0.5F) + 0.55F * n.medium + 0.45F * n.fine +
                               0.25F * n.broad - 1.0F * hollow));
  const Rgb meadow = mix(kDryGrass, kGrass, clamp01(0.52F + 0.95F * n.broad + 0.50F * n.medium + 3.0F * hollow));
  const float stones =
      scattered(p, n.fine + 0.4F * n.medium,
                clamp01(0.08F + 0.30F * p.slope + 0.40F * ramp(0.10F, 0.45F, n.medium - 0.5F * n.broad)));
  const Rgb low = mix(meadow, rock, 0.85F * stones);
  const float tufts = ramp(0.05F, 0.50F, 2.0F * hollow + 0.6F * n.medium + 0.3F * n.fine - 0.35F * p.slope + 0.12F);
  const Rgb middle = mix(mix(kScree, rock, ramp(0.25F, 0.75F, unevenness(p, n))), meadow, 0.55F * tufts);
  const Rgb high = mix(kHeath, kGreen, clamp01(0.45F + 0.6F * n.broad + 0.6F * n.medium + 2.0F * hollow));
  const float bare = ramp(0.65F, 1.30F, unevenness(p, n));
  const Rgb ground = mix(layered(n, low, middle, high), rock, bare);
  return {(1.0F + 0.20F * n.fine) * ground, mix(layered(n, 0.4F, 1.6F, 0.9F), 1.7F, bare), {}};
}

Material desert_land(const SurfacePoint& p) {
  constexpr Rgb kSand{0.385F, 0.258F, 0.124F}, kPaleSand{0.450F, 0.325F, 0.178F}, kGravel{0.215F, 0.158F, 0.100F};
  constexpr Rgb kShrub{0.052F, 0.058F, 0.026F}, kDryGrass{0.172F, 0.148F, 0.068F};
  constexpr Rgb kHill{0.300F, 0.178F, 0.090F}, kRedRock{0.170F, 0.084F, 0.045F}, kPaleRock{0.300F, 0.186F, 0.105F};
  const Place n = look_at(p);
  const float hollow = std::clamp(p.concavity, -0.25F, 0.25F);
  // Ripples of wind lie across the broad noise's own direction, one wavelength a dozen metres.
  const float wind = std::sin(0.42F * (0.94F * p.x + 0.34F * p.y + 55.0F * n.medium + 500.0F * n.broad));
  const float rippled = wind * (1.0F - ramp(2.0F, 6.0F, p.footprint)) * (1.0F - ramp(0.15F, 0.45F, p.slope));
  const Rgb low = mix(kSand, kPaleSand, clamp01(0.42F + 0.20F * rippled + 0.55F * n.broad + 0.35F * n.medium));
  // Shrubs gather where water would: in hollows and along the feet of slopes.
  const float cover = clamp01(0.20F + 0.30F * n.broad + 1.8F * hollow - 0.15F * p.slope);
  const float shrubs = scattered(p, n.fine + 0.35F * n.medium, cover);
  const Rgb stony = mix(kGravel, kSand, clamp01(0.40F + 0.7F * n.medium + 0.5F * n.broad));
  const Rgb middle = mix(mix(stony, kDryGrass, 0.45F * clamp01(1.8F * cover)), kShrub, 0.85F * shrubs);
  const float band = beds(p, n, 85.0F);
  const Rgb rock = mix(kRedRock, kPaleRock,
                       clamp01(0.48F + 0.50F * (band - 0.5F) + 0.45F * n.medium + 0.3F * n.fine + 0.3F * n.broad));
  const float ledges = ramp(0.12F, 0.85F, unevenness(p, n));
  const Rgb high = mix(mix(kHill, kSand, clamp01(0.35F + 0.8F * n.medium + 1.5F * hollow)), rock, 0.85F * ledges);
  const float bare = ramp(0.45F, 1.25F, unevenness(p, n));
  const Rgb ground = mix(layered(n, low, middle, high), rock, bare);
  return {(1.0F + 0.13F * n.fine) * ground, mix(layered(n, 0.15F, 0.7F, 0.9F), 1.6F, bare), {}};
}

/// Light of lava at a heat in [0, 1]: none, dull red, orange, yellow.
Rgb lava_light(float heat) {
  const float red = heat * heat * (0.35F + 1.25F * heat), yellow = ramp(0.45F, 1.05F, heat);
  return {red * (1.0F + 0.9F * yellow), red * (0.045F + 0.62F * yellow), red * (0.006F + 0.07F * yellow * yellow)};
}

Material volcano_land(const SurfacePoint& p) {
  constexpr Rgb kBurned{0.032F, 0.029F, 0.028F}, kClinker{0.072F, 0.064F, 0.060F}, kRust{0.098F, 0.058F, 0.040F};
  constexpr Rgb kCrust{0.026F, 0.024F, 0.024F}, kOldCrust{0.058F, 0.052F, 0.050F};
  constexpr Rgb kAsh{0.132F, 0.122F, 0.115F}, kScoria{0.125F, 0.056F, 0.036F}, kSulphur{0.330F, 0.275F, 0.095F};
  const Place n = look_at(p);
  const float hollow = std::clamp(p.concavity, -0.25F, 0.25F);
  const Rgb burned =
      mix(kBurned, kClinker, clamp01(0.38F + 0.8F * n.medium + 0.35F * n.fine + 0.4F * n.broad - 1.2F * hollow));
  const Rgb low = mix(burned, kRust, 0.55F * ramp(0.10F, 0.50F, n.broad + 0.4F * n.medium));
  const Rgb middle = mix(kCrust, kOldCrust, clamp01(0.40F + 0.9F * n.medium + 0.5F * n.fine - 1.2F * hollow));
  const Rgb ash = mix(kAsh, kScoria, ramp(0.0F, 0.45F, n.broad + 0.5F * n.medium + 0.3F * (p.slope - 0.4F)));
  const float vent = n.high * ramp(0.06F, 0.22F, hollow + 0.05F * n.medium);
  const Rgb high = mix(ash, kSulphur, 0.5F * vent * ramp(0.0F, 0.35F, n.medium + 0.5F * n.fine));
  const float bare = ramp(0.80F, 1.25F, unevenness(p, n));
  Rgb ground = mix(layered(n, low, middle, high), mix(kBurned, kRust, clamp01(0.25F + 0.6F * n.medium)), 0.8F * bare);
  // Lava is hottest in the middle of its stream and darkens under plates of crust; old flows glow through cracks.
  const float plates = clamp01(0.5F + 1.2F * n.medium + 1.3F * n.fine);
  const float stream = p.lava * (1.0F - 0.55F * plates * (1.0F - 0.7F * p.lava));
  const float crack = ramp(0.06F, 0.0F, std::abs(n.medium + 0.35F * n.fine)) * ramp(5.0F, 1.5F, p.footprint);
  const float warm = (1.0F - n.low - n.high) * ramp(0.05F, 0.45F, n.broad + 2.0F * hollow);
  const float heat = std::max(stream, crack * std::max(0.6F * warm, 0.7F * vent));
  ground = mix(ground, kCrust, ramp(0.02F, 0.25F, p.lava));
  return {(1.0F + 0.15F * n.fine) * ground, layered(n, 1.2F, 1.4F, 0.5F), lava_light(heat)};
}

Material reef_floor(const SurfacePoint& p) {
  constexpr Rgb kDeep{0.105F, 0.108F, 0.104F}, kSilt{0.185F, 0.180F, 0.155F};
  constexpr Rgb kSand{0.590F, 0.555F, 0.450F}, kAlgae{0.260F, 0.250F, 0.165F};
  constexpr Rgb kCoral{0.118F, 0.110F, 0.058F}, kGreenCoral{0.150F, 0.172F, 0.088F}, kFlat{0.400F, 0.362F, 0.252F};
  const Place n = look_at(p);
  const float hollow = std::clamp(p.concavity, -0.25F, 0.25F);
  const Rgb low = mix(kDeep, kSilt, clamp01(0.30F + 0.5F * n.broad + 0.4F * n.medium - 0.5F * p.slope));
  const float weed = ramp(0.22F, 0.55F, n.medium + 0.5F * n.fine + 0.45F * n.broad);
  const Rgb middle = mix(kSand, kAlgae, 0.65F * weed);
  const Rgb grown = mix(kCoral, kGreenCoral, clamp01(0.5F + 0.8F * n.medium + 0.5F * n.broad));
  const float sanded = ramp(0.05F, 0.45F, 0.8F * n.medium - 0.5F * n.fine + 2.0F * hollow);
  const Rgb high = mix(grown, mix(kFlat, kSand, 0.5F * sanded), clamp01(0.15F + 0.75F * sanded));
  Rgb ground = layered(n, low, middle, high);
  const float depth = -p.z;
  ground = mix(ground, kSand, ramp(1.3F, 0.2F, depth + 0.6F * n.medium) * ramp(0.30F, 0.10F, p.slope));
  return {(1.0F + 0.20F * n.fine) * ground, 0.5F, {}};
}

}  // namespace

geom::Borders style_borders(Style style, const LayerBorders& borders, const HeightField& terrain) {
  const auto [lowest, highest] = std::minmax_element(terrain.cells().begin(), terrain.cells().end());
  return style_borders(style, borders, *lowest, *highest);
}

geom::Borders style_borders(Style style, const LayerBorders& borders, float lowest_m, float highest_m) {
  if (style == Style::great_barrier_reef && lowest_m < 0.0F) {
    // Depths of the reefs around 18 degrees south: flats awash, lagoons and shoals to some 20 m, then the shelf's
    // slope.
    LayerBorders depths = borders;
    if (!depths.low_m) depths.low_m = std::min(-42.0, borders.high_m.value_or(-42.0));
    if (!depths.low_error_m) depths.low_error_m = 24.0;
    if (!depths.high_m) depths.high_m = std::max(-3.5, *depths.low_m);
    if (!depths.high_error_m) depths.high_error_m = 4.5;
    return geom::resolve_borders(depths, -500.0, 0.0);
  }
  const double top = highest_m, bottom = top > 0.0 ? std::max(0.0, static_cast<double>(lowest_m)) : lowest_m;
  return geom::resolve_borders(borders, bottom, top);
}

Material style_land(const SurfacePoint& point, Style style) {
  constexpr Rgb kSand{0.520F, 0.450F, 0.335F}, kBlackSand{0.060F, 0.056F, 0.056F};
  Material land = style == Style::stone    ? stone_land(point)
                  : style == Style::desert ? desert_land(point)
                                           : volcano_land(point);
  const float uneven = detail_noise(23, point.x, point.y, 170.0F, 2, 0.6F, point.footprint).value;
  const float beach = ramp(3.0F, 1.2F, point.z + 1.3F * uneven) * ramp(0.22F, 0.08F, point.slope) *
                      ramp(110.0F, 60.0F, point.shore_m + 40.0F * uneven - 0.5F * point.footprint);
  const Rgb sand = style == Style::volcano ? kBlackSand : kSand;
  land.albedo = mix(land.albedo, mix(sand, 0.6F * sand, ramp(0.7F, 0.1F, point.z)), beach);
  land.bump = mix(land.bump, 0.1F, beach);
  return land;
}

Material style_floor(const SurfacePoint& point, Style style) {
  if (style == Style::great_barrier_reef) return reef_floor(point);
  Material floor = floor_material(point, {});
  if (style == Style::volcano) floor.albedo = Rgb{0.24F, 0.23F, 0.24F} * floor.albedo;  // black sand
  if (style == Style::stone) floor.albedo = Rgb{0.62F, 0.64F, 0.62F} * floor.albedo;
  return floor;
}

const std::array<StyleLayer, 3>& style_layers(Style style) {
  static constexpr std::array<StyleLayer, 3> kReef = {{{"deep sea", {28, 62, 112}, {62, 118, 166}},
                                                       {"shallows", {104, 184, 204}, {172, 222, 216}},
                                                       {"reef", {92, 148, 124}, {132, 168, 130}}}};
  static constexpr std::array<StyleLayer, 3> kStone = {{{"grass and stones", {172, 178, 134}, {184, 184, 146}},
                                                        {"stony hills", {176, 170, 160}, {202, 198, 190}},
                                                        {"vegetation", {118, 140, 92}, {150, 164, 118}}}};
  static constexpr std::array<StyleLayer, 3> kDesert = {{{"sand", {230, 204, 156}, {238, 216, 172}},
                                                         {"sparse vegetation", {184, 176, 128}, {196, 182, 136}},
                                                         {"sandy hills", {204, 158, 112}, {226, 184, 140}}}};
  static constexpr std::array<StyleLayer, 3> kVolcano = {{{"burned stone", {92, 86, 84}, {112, 104, 100}},
                                                          {"lava", {156, 74, 50}, {190, 96, 58}},
                                                          {"outbreaks", {164, 154, 148}, {208, 200, 194}}}};
  switch (style) {
    case Style::stone:
      return kStone;
    case Style::desert:
      return kDesert;
    case Style::volcano:
      return kVolcano;
    default:
      return kReef;
  }
}

}  // namespace seamount::render
