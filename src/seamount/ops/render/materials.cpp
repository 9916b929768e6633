#include "seamount/ops/render/materials.h"

#include "seamount/ops/render/detail_noise.h"
#include "seamount/ops/render/style.h"
#include "seamount/ops/render/unknown.h"

namespace seamount::render {
namespace {

constexpr Rgb kForest{0.029F, 0.040F, 0.017F};
constexpr Rgb kForestLight{0.058F, 0.067F, 0.027F};
constexpr Rgb kGrass{0.112F, 0.108F, 0.054F};
constexpr Rgb kDryGrass{0.215F, 0.180F, 0.105F};
constexpr Rgb kSoil{0.165F, 0.118F, 0.075F};
constexpr Rgb kScree{0.215F, 0.192F, 0.165F};
constexpr Rgb kDarkRock{0.078F, 0.069F, 0.060F};
constexpr Rgb kPaleRock{0.200F, 0.178F, 0.150F};
constexpr Rgb kSand{0.560F, 0.475F, 0.345F};
constexpr Rgb kWetSand{0.330F, 0.270F, 0.185F};
constexpr Rgb kSnow{0.820F, 0.850F, 0.900F};
constexpr Rgb kLagoonSand{0.600F, 0.560F, 0.450F};
constexpr Rgb kReefFlat{0.430F, 0.370F, 0.255F};
constexpr Rgb kCoral{0.165F, 0.120F, 0.070F};
constexpr Rgb kForeReef{0.105F, 0.098F, 0.070F};
constexpr Rgb kDeepFloor{0.170F, 0.165F, 0.150F};

/// Noise at the three scales that every material uses.
struct Breakup {
  float broad, medium, fine;
};

Breakup breakup(const SurfacePoint& p) {
  return {detail_noise(11, p.x, p.y, 5200.0F, 4, 0.50F, p.footprint).value,
          detail_noise(23, p.x, p.y, 170.0F, 3, 0.60F, p.footprint).value,
          detail_noise(37, p.x, p.y, 18.0F, 3, 0.60F, p.footprint).value};
}

Rgb rock_colour(const SurfacePoint& p, const Breakup& n) {
  // Beds that wander with the broad noise show as faint bands on cliffs.
  const float bed = 90.0F, phase = (p.z + 160.0F * n.broad + 22.0F * n.medium) / bed;
  const float near = ramp(0.20F, 0.06F, p.footprint / bed);  // further off they would cross the noise as a plaid
  const float band = 0.5F + 0.5F * near * std::sin(6.2832F * phase);
  const float pale = clamp01(0.42F + 0.26F * (band - 0.5F) + 0.55F * n.medium + 0.45F * n.fine + 0.30F * n.broad -
                             0.9F * std::clamp(p.concavity, -0.3F, 0.3F) - 0.22F * (p.slope - 1.0F));
  return mix(kDarkRock, kPaleRock, pale);
}

}  // namespace

Material land_material(const SurfacePoint& p, const MaterialRules& rules) {
  if (rules.style != Style::natural && rules.style != Style::great_barrier_reef) return style_land(p, rules.style);
  const Breakup n = breakup(p);
  const float height = p.z / rules.tree_line;
  // Water in the soil: hollows and shaded faces are moist, ridges and heights dry.
  const float moisture = 0.60F + 0.42F * n.broad + 0.16F * n.medium + 1.5F * std::clamp(p.concavity, -0.22F, 0.22F) +
                         0.22F * std::clamp(p.northness, -0.8F, 0.8F) - 0.20F * height;
  const float uneven = p.slope + 0.28F * n.medium + 0.16F * n.fine - 0.5F * std::clamp(p.concavity, -0.25F, 0.25F);

  Rgb ground = mix(mix(kDryGrass, kSoil, clamp01(0.35F + 0.9F * n.medium)), kGrass, ramp(0.15F, 0.60F, moisture));
  float bump = 0.15F;
  const float cold = ramp(0.72F, 1.12F, height + 0.22F * n.broad + 0.16F * n.medium - 0.35F * p.concavity);
  const float forest = ramp(0.36F, 0.66F, moisture + 0.18F * n.fine) * (1.0F - ramp(0.85F, 1.30F, uneven)) *
                       (1.0F - cold) * ramp(1.0F, 7.0F, p.z + 3.0F * n.medium);
  const Rgb crowns = mix(kForest, kForestLight, clamp01(0.42F + 0.9F * n.medium + 0.7F * n.fine - 1.2F * p.concavity));
  ground = mix(ground, crowns, forest);
  bump = mix(bump, 2.2F, forest);

  const float stony =
      ramp(1.05F, 1.70F, height + 0.34F * n.medium + 0.28F * n.broad + 0.30F * p.slope - 0.4F * p.concavity);
  ground = mix(ground, mix(kScree, rock_colour(p, n), clamp01(0.40F + 1.1F * n.medium + n.fine - 1.5F * p.concavity)),
               stony);
  const float rock = ramp(0.78F, 1.22F, uneven + 0.22F * cold);
  ground = mix(ground, rock_colour(p, n), rock);
  bump = mix(bump, 1.6F, std::max(rock, 0.5F * stony));

  const float snow =
      ramp(-120.0F, 260.0F,
           p.z + 260.0F * n.medium + 350.0F * n.broad + 500.0F * p.concavity + 220.0F * p.northness - rules.snow_line) *
      (1.0F - ramp(0.95F, 1.45F, p.slope + 0.35F * n.medium + 0.2F * n.fine));
  ground = mix(ground, kSnow, snow);
  bump = mix(bump, 0.1F, snow);

  // Beach: low and gentle, or so labelled; the label reaches up to the first dunes only.
  const float low = ramp(3.0F, 1.2F, p.z + 1.3F * n.medium) * ramp(0.22F, 0.08F, p.slope);
  const float labelled = p.beach * ramp(9.0F, 4.0F, p.z + 3.0F * n.medium) * ramp(0.35F, 0.15F, p.slope);
  const float sand = clamp01(std::max(low * mix(1.0F, p.beach + 0.35F, p.labelled), labelled));
  ground = mix(ground, mix(kSand, kWetSand, ramp(0.7F, 0.1F, p.z)), sand);
  bump = mix(bump, 0.1F, sand);
  // Rock that the spray keeps bare and dark at steep coasts.
  const float spray = ramp(9.0F, 2.0F, p.z + 4.0F * n.medium) * ramp(0.25F, 0.6F, p.slope) * (1.0F - sand);
  return {(1.0F + 0.18F * (1.0F - 0.7F * snow) * n.fine) * mix(ground, kDarkRock, 0.8F * spray), bump, {}};
}

Material floor_material(const SurfacePoint& p, const MaterialRules& rules) {
  if (rules.style != Style::natural) return style_floor(p, rules.style);
  const float depth = -p.z;
  const float medium = detail_noise(51, p.x, p.y, 260.0F, 4, 0.6F, p.footprint).value;
  const float fine = detail_noise(67, p.x, p.y, 26.0F, 3, 0.6F, p.footprint).value;
  const float broad = detail_noise(71, p.x, p.y, 1900.0F, 2, 0.5F, p.footprint).value;
  // Without labels a floor that is gentle and not deep counts as lagoon, one that bulges in the shallows as reef.
  const float sheltered = clamp01(4.0F * p.concavity);
  const float gentle = ramp(0.32F, 0.10F, p.slope * (1.0F - 0.75F * sheltered) + 0.06F * medium);
  const float guessed_reef = ramp(7.0F, 3.0F, depth) * clamp01(0.35F - 2.5F * p.concavity);
  const float reef = mix(guessed_reef, p.reef, p.labelled);
  const float lagoon = mix(gentle * ramp(90.0F, 40.0F, depth), p.lagoon, p.labelled);

  Rgb floor = mix(kForeReef, kDeepFloor, ramp(60.0F, 300.0F, depth));
  // Coral heads and weed darken lagoon sand in patches.
  const float patches = ramp(0.20F, 0.48F, medium + 0.5F * fine + 0.45F * broad) * ramp(1.0F, 4.0F, depth);
  floor = mix(floor, mix(kLagoonSand, kCoral, 0.62F * patches), std::max(lagoon, gentle * ramp(30.0F, 12.0F, depth)));
  // The reef is pale on its flat and darkens down its outer face.
  const float flat = ramp(7.0F, 2.0F, depth + 1.5F * medium);
  const float growth = ramp(0.05F, 0.50F, medium + 0.6F * fine + 0.12F);
  floor = mix(floor, mix(kForeReef, mix(kReefFlat, kCoral, 0.7F * growth), flat), reef);
  floor = mix(floor, kSand, ramp(2.5F, 0.5F, depth + 0.8F * medium) * gentle * (1.0F - 0.7F * reef));
  return {(1.0F + 0.22F * fine) * floor, 0.4F, {}};
}

Material ground_material(const SurfacePoint& p, const MaterialRules& rules) {
  if (p.unknown) return {kUnknownAlbedo, 0.0F, {}};
  if (p.z >= 0.3F) return land_material(p, rules);
  if (p.z <= -0.3F) return floor_material(p, rules);
  const Material land = land_material(p, rules), floor = floor_material(p, rules);
  const float t = (p.z + 0.3F) / 0.6F;
  return {mix(floor.albedo, land.albedo, t), mix(floor.bump, land.bump, t), t * land.glow};
}

}  // namespace seamount::render
