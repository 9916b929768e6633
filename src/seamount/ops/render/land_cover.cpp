#include "seamount/ops/render/land_cover.h"

#include "seamount/ops/render/detail_noise.h"

namespace seamount::render {
namespace {

// Albedos; the source is that of materials.h.
constexpr Rgb kRainForest{0.023F, 0.035F, 0.015F}, kRainForestLight{0.052F, 0.064F, 0.030F};
constexpr Rgb kBroadleaf{0.034F, 0.046F, 0.018F}, kBroadleafLight{0.066F, 0.076F, 0.031F};
constexpr Rgb kConifer{0.017F, 0.027F, 0.015F}, kConiferLight{0.033F, 0.043F, 0.022F};
constexpr Rgb kMeadow{0.098F, 0.102F, 0.050F}, kDryGrass{0.172F, 0.145F, 0.073F}, kSteppe{0.155F, 0.127F, 0.074F};
constexpr Rgb kTundra{0.115F, 0.102F, 0.050F}, kShrub{0.052F, 0.058F, 0.028F};
constexpr Rgb kSoil{0.115F, 0.076F, 0.046F}, kRedSoil{0.150F, 0.080F, 0.044F}, kDesertSand{0.420F, 0.300F, 0.170F};
constexpr Rgb kSand{0.560F, 0.475F, 0.345F}, kWetSand{0.330F, 0.270F, 0.185F}, kColdSand{0.300F, 0.265F, 0.205F};
constexpr Rgb kBlackSand{0.080F, 0.074F, 0.070F};
constexpr Rgb kSnow{0.830F, 0.855F, 0.890F}, kOldSnow{0.560F, 0.600F, 0.640F};

struct RockColours {
  Rgb dark, pale, scree;
};

constexpr RockColours colours_of(Rock rock) {
  switch (rock) {
    case Rock::basalt:
      return {{0.040F, 0.035F, 0.032F}, {0.098F, 0.084F, 0.074F}, {0.092F, 0.080F, 0.070F}};
    case Rock::limestone:
      return {{0.190F, 0.172F, 0.142F}, {0.400F, 0.372F, 0.318F}, {0.350F, 0.326F, 0.280F}};
    case Rock::sandstone:
      return {{0.150F, 0.076F, 0.042F}, {0.330F, 0.205F, 0.118F}, {0.260F, 0.165F, 0.098F}};
    default:
      return {{0.062F, 0.057F, 0.052F}, {0.215F, 0.200F, 0.178F}, {0.150F, 0.138F, 0.121F}};
  }
}

/// Noise at the scales that all share. The finest are there only for an eye that is near.
struct Breakup {
  float broad, medium, fine, grain;
};

Breakup breakup(const SurfacePoint& p) {
  return {detail_noise(11, p.x, p.y, 2400.0F, 3, 0.50F, p.footprint).value,
          detail_noise(23, p.x, p.y, 170.0F, 3, 0.60F, p.footprint).value,
          detail_noise(37, p.x, p.y, 18.0F, 3, 0.60F, p.footprint).value,
          detail_noise(39, p.x, p.y, 1.9F, 4, 0.65F, p.footprint).value};
}

Rgb rock_of(const SurfacePoint& p, Rock rock, const Breakup& n) {
  const RockColours colours = colours_of(rock);
  // Beds, flows or joints of uneven thickness, warped a little: noise along the height, faded where a pixel covers
  // several. Granite has few.
  const float strength = rock == Rock::granite ? 0.40F : rock == Rock::basalt ? 0.5F : 1.0F;
  const float along = 0.7F * p.x + 0.7F * p.y, rise = p.footprint * std::min(p.slope, 1.5F);
  const float bedding = strength * ramp(0.25F, 0.7F, p.slope) *
                        detail_noise(43, 0.012F * along + 9.0F * n.broad, p.z + 8.0F * n.medium, 46.0F, 3, 0.7F,
                                     std::max(rise, 0.3F * p.footprint))
                            .value;
  const float pale = clamp01(0.45F + 0.9F * bedding + 0.95F * n.medium + 0.70F * n.fine + 0.50F * n.grain +
                             0.25F * n.broad + 1.8F * std::clamp(p.rib, -0.2F, 0.2F) - 0.16F * (p.slope - 1.0F));
  const Rgb stained = mix(colours.pale, colours.pale * Rgb{1.0F, 0.88F, 0.74F}, ramp(0.0F, 0.4F, n.broad + n.medium));
  return mix(colours.dark, stained, ramp(0.02F, 0.98F, pale));
}

/// How the plants of a place do.
struct Growth {
  float warmth;  ///< degrees, mean of the year
  float water;   ///< log2 of rain over what plants could use, with what the ground adds: 0 is just enough for forest
  float cold;    ///< 0 below the tree line, 1 above it
};

Growth growth_of(const SurfacePoint& p, const Climate& climate, const Breakup& n) {
  Growth g{};
  g.warmth = climate.temperature(p.z);
  const float usable = 58.93F * std::clamp(g.warmth, 4.0F, 30.0F);
  const float rain = std::max(5.0F, climate.rain_mm * p.rain);
  const float shade = climate.latitude < 0.0F ? -p.northness : p.northness;
  const float away = std::min(1.0F, std::abs(climate.latitude) / 35.0F);  // the tropics' sun stands high
  g.water = std::log2(rain / usable) + 1.5F * p.wet - 2.5F * std::clamp(p.rib, -0.18F, 0.18F) +
            2.0F * std::clamp(p.concavity, -0.2F, 0.2F) + 0.7F * away * std::clamp(shade, -0.8F, 0.8F) -
            0.35F * std::min(p.slope, 1.5F) + 0.55F * n.medium + 0.45F * n.broad + 0.25F * n.fine;
  const float over = (p.z - climate.tree_line) / 260.0F;
  g.cold = ramp(-1.0F, 1.0F, over + 1.1F * n.medium + 0.7F * n.broad + 4.0F * std::clamp(p.rib, -0.15F, 0.15F));
  return g;
}

Rgb crowns(const SurfacePoint& p, const Growth& g, const Breakup& n) {
  const float light = clamp01(0.40F + 0.45F * n.medium + 0.75F * n.fine + 0.5F * n.grain - 0.9F * p.concavity +
                              0.8F * std::clamp(p.rib, -0.2F, 0.2F));
  const Rgb rain = mix(kRainForest, kRainForestLight, light), leaf = mix(kBroadleaf, kBroadleafLight, light),
            needle = mix(kConifer, kConiferLight, light);
  return mix(mix(needle, leaf, ramp(3.0F, 11.0F, g.warmth + 5.0F * n.medium)), rain,
             ramp(15.0F, 22.0F, g.warmth) * ramp(-0.3F, 0.5F, g.water));
}

Rgb herbs(const Growth& g, const Breakup& n) {
  const Rgb dry = mix(kSteppe, kDryGrass, clamp01(0.5F + 0.8F * n.medium + 0.5F * n.fine));
  const Rgb grass = mix(dry, kMeadow, ramp(-1.4F, 0.35F, g.water));
  const Rgb heath = mix(kTundra, kShrub, ramp(0.0F, 0.7F, n.fine + 0.5F * n.medium + 0.2F));
  return mix(grass, heath, clamp01(0.75F * g.cold + ramp(5.0F, -1.0F, g.warmth)));
}

/// Ground without plants on slopes that hold loose stuff.
Rgb loose(const SurfacePoint& p, const Climate& climate, const Growth& g, const Breakup& n) {
  const RockColours rock = colours_of(climate.rock);
  const Rgb soil = mix(kSoil, kRedSoil, ramp(17.0F, 24.0F, g.warmth) * clamp01(0.6F + n.broad));
  const Rgb gravel = mix(rock.scree, rock.dark, clamp01(0.25F + 0.8F * n.fine + 0.7F * n.grain));
  const Rgb desert =
      mix(mix(kDesertSand, rock.scree, 0.45F), gravel, clamp01(0.30F + 0.7F * n.medium + 1.2F * p.slope));
  const float arid = ramp(-1.3F, -2.6F, g.water);
  const float stony = std::max(g.cold, ramp(0.30F, 0.60F, p.slope + 0.2F * n.medium + 0.1F * n.fine));
  return mix(mix(soil, gravel, stony), desert, arid);
}

float beach_share(const SurfacePoint& p, const Breakup& n) {
  // Waves build it as wide as they reach: some ten metres, wider in bays; where the coast is steep there is none.
  const float width = 38.0F + 22.0F * n.broad + 40.0F * std::clamp(p.concavity, -0.2F, 0.3F) + 0.5F * p.footprint;
  const float near = ramp(1.25F * width, 0.75F * width, p.shore_m + 10.0F * n.medium);
  const float pocket = ramp(-0.15F, 0.15F, n.broad + 0.3F * n.medium + 1.5F * p.concavity);
  const float built = near * pocket * ramp(4.5F, 2.8F, p.z + 1.2F * n.medium) * ramp(0.24F, 0.10F, p.slope);
  const float labelled = p.beach * ramp(7.0F, 4.0F, p.z + 2.0F * n.medium) * ramp(0.35F, 0.15F, p.slope) *
                         ramp(4.0F * width, 2.0F * width, p.shore_m + 25.0F * n.medium);
  return clamp01(std::max(built * mix(1.0F, 0.5F + p.beach, p.labelled), labelled));
}

struct Snow {
  float share;
  float old;  ///< of it
};

Snow snow_on(const SurfacePoint& p, const Climate& climate, const Breakup& n) {
  const float shade = climate.latitude < 0.0F ? -p.northness : p.northness;
  const float over = p.z - climate.snow_line + 130.0F * n.medium + 120.0F * n.broad +
                     1400.0F * std::clamp(-p.rib, -0.15F, 0.15F) + 600.0F * std::clamp(p.concavity, -0.2F, 0.2F) +
                     260.0F * std::clamp(shade, -0.8F, 0.8F);
  const float steep = p.slope + 0.30F * n.medium + 0.22F * n.fine;
  const float holds = 1.0F - ramp(0.95F, 1.40F, steep);
  return {ramp(-160.0F, 240.0F, over) * holds, ramp(300.0F, -100.0F, over)};
}

}  // namespace

Rgb rock_colour(const SurfacePoint& point, Rock rock) { return rock_of(point, rock, breakup(point)); }

Material natural_land(const SurfacePoint& p, const Climate& climate) {
  const Breakup n = breakup(p);
  const Growth g = growth_of(p, climate, n);
  const float uneven = p.slope + 0.28F * n.medium + 0.28F * n.fine + 0.18F * n.grain +
                       1.2F * std::clamp(p.rib, -0.2F, 0.2F) - 0.4F * std::clamp(p.concavity, -0.25F, 0.25F);
  // Roots hold steeper ground where it is warm and wet: cliffs of the wet tropics are green.
  const float grip = 0.55F * ramp(0.0F, 1.2F, g.water) * ramp(14.0F, 22.0F, g.warmth);
  const float forest = ramp(-0.75F, 0.35F, g.water + 0.25F * n.grain) * (1.0F - ramp(0.72F, 1.08F, uneven - grip)) *
                       (1.0F - g.cold) * ramp(1.0F, 6.0F, p.z + 2.5F * n.medium);
  const float herb = ramp(-2.5F, -0.6F, g.water + 0.9F * n.fine + 0.7F * n.grain) *
                     (1.0F - ramp(0.88F, 1.30F, uneven - grip)) * ramp(-9.0F, -1.0F, g.warmth + 6.0F * n.medium) *
                     (1.0F - ramp(0.15F, 0.85F,
                                  (p.z - 0.5F * (climate.tree_line + climate.snow_line)) / 700.0F + 0.8F * n.medium +
                                      0.5F * n.fine + uneven));
  const float rocky = ramp(0.72F, 1.05F, uneven - 0.5F * grip);

  Rgb ground = loose(p, climate, g, n);
  float bump = mix(0.25F, 0.6F, clamp01(p.slope));
  ground = mix(ground, rock_of(p, climate.rock, n), rocky);
  bump = mix(bump, 1.6F, rocky);
  ground = mix(ground, herbs(g, n), herb);
  bump = mix(bump, 0.2F, herb);
  // Shrubs where it is too dry for forest: single dark dots, from afar a tint.
  const float bush = ramp(-2.2F, -0.4F, g.water) * (1.0F - g.cold) * (1.0F - rocky);
  ground = mix(ground, kShrub, bush * mix(ramp(0.20F, 0.34F, n.fine), 0.22F, ramp(2.0F, 7.0F, p.footprint)));
  ground = mix(ground, crowns(p, g, n), forest);
  bump = mix(bump, 2.2F, forest);

  const Snow snow = snow_on(p, climate, n);
  ground = mix(ground, mix(kSnow, kOldSnow, 0.6F * snow.old), snow.share);
  bump = mix(bump, 0.1F, snow.share);

  const float sand = beach_share(p, n);
  const Rgb dry_sand = mix(mix(kColdSand, kSand, ramp(8.0F, 19.0F, climate.sea_level_c)), kBlackSand,
                           climate.rock == Rock::basalt ? 0.12F : 0.0F);
  ground = mix(ground, mix(dry_sand, mix(kWetSand, 0.6F * dry_sand, 0.5F), ramp(0.7F, 0.1F, p.z)), sand);
  bump = mix(bump, 0.1F, sand);
  // Rock that the spray keeps bare and dark at steep coasts.
  const float spray = ramp(9.0F, 2.0F, p.z + 4.0F * n.medium) * ramp(60.0F, 15.0F, p.shore_m) *
                      ramp(0.12F, 0.45F, p.slope) * (1.0F - sand);
  ground = mix(ground, colours_of(climate.rock).dark, 0.85F * spray);
  const float grain = (1.0F - 0.7F * snow.share) * (0.20F * n.fine + 0.24F * n.grain);
  return {(1.0F + grain) * ground, bump, {}};
}

}  // namespace seamount::render
