#include "seamount/ops/render/materials.h"

#include "seamount/ops/render/detail_noise.h"
#include "seamount/ops/render/land_cover.h"
#include "seamount/ops/render/style.h"
#include "seamount/ops/render/unknown.h"

namespace seamount::render {
namespace {

constexpr Rgb kSand{0.560F, 0.475F, 0.345F};
constexpr Rgb kLagoonSand{0.600F, 0.560F, 0.450F};
constexpr Rgb kReefFlat{0.430F, 0.370F, 0.255F};
constexpr Rgb kCoral{0.165F, 0.120F, 0.070F};
constexpr Rgb kForeReef{0.105F, 0.098F, 0.070F};
constexpr Rgb kDeepFloor{0.170F, 0.165F, 0.150F};
constexpr Rgb kColdSand{0.270F, 0.245F, 0.190F};
constexpr Rgb kSeagrass{0.075F, 0.088F, 0.042F};
constexpr Rgb kWeed{0.052F, 0.054F, 0.026F};

}  // namespace

Material land_material(const SurfacePoint& p, const MaterialRules& rules) {
  if (rules.style != Style::natural && rules.style != Style::great_barrier_reef) return style_land(p, rules.style);
  return natural_land(p, rules.climate);
}

Material floor_material(const SurfacePoint& p, const MaterialRules& rules) {
  if (rules.style != Style::natural) return style_floor(p, rules.style);
  const float depth = -p.z;
  const float medium = detail_noise(51, p.x, p.y, 260.0F, 4, 0.6F, p.footprint).value;
  const float fine = detail_noise(67, p.x, p.y, 26.0F, 3, 0.6F, p.footprint).value;
  const float grain = detail_noise(69, p.x, p.y, 2.2F, 4, 0.65F, p.footprint).value;
  const float broad = detail_noise(71, p.x, p.y, 1900.0F, 2, 0.5F, p.footprint).value;
  const float warm = ramp(15.5F, 19.5F, rules.climate.sea_level_c);  // where reefs grow
  // Without labels a floor that is gentle and not deep counts as lagoon, one that bulges in the shallows as reef.
  const float sheltered = clamp01(4.0F * p.concavity);
  const float gentle = ramp(0.32F, 0.10F, p.slope * (1.0F - 0.75F * sheltered) + 0.06F * medium);
  const float guessed_reef = warm * ramp(7.0F, 3.0F, depth) * clamp01(0.35F - 2.5F * p.concavity);
  const float reef = mix(guessed_reef, p.reef, p.labelled);
  const float lagoon = mix(gentle * ramp(90.0F, 40.0F, depth), p.lagoon, p.labelled);

  const Rgb sand = mix(kColdSand, kLagoonSand, warm), grown = mix(kWeed, kCoral, warm);
  Rgb floor = mix(kForeReef, kDeepFloor, ramp(60.0F, 300.0F, depth));
  // Coral heads and weed darken the sand in patches, more on rock off open coasts than in shelter and far out.
  const float open = 0.45F * (1.0F - mix(sheltered, p.lagoon, p.labelled)) * ramp(60.0F, 350.0F, p.shore_m) *
                     ramp(2500.0F, 1200.0F, p.shore_m);
  const float patches =
      ramp(0.20F, 0.48F, medium + 0.5F * fine + 0.45F * broad + 0.3F * grain + open + 0.1F * (1.0F - warm)) *
      ramp(0.8F, 3.5F, depth + 1.5F * medium);
  floor = mix(floor, mix(sand, grown, 0.70F * patches),
              std::max(lagoon, gentle * ramp(34.0F, 12.0F, depth + 8.0F * medium)));
  // The shallows along a coast are rubble, turf and seagrass in fields, with sand between.
  const float fields = ramp(-0.25F, 0.15F, medium + 0.5F * broad + 0.35F * fine) * ramp(4.5F, 2.0F, depth) *
                       ramp(25.0F, 90.0F, p.shore_m) * ramp(1600.0F, 700.0F, p.shore_m) * warm;
  const Rgb rubble = mix(kReefFlat, mix(kCoral, kSeagrass, 0.5F), clamp01(0.45F + 0.8F * fine + 0.6F * medium));
  floor = mix(floor, rubble, 0.75F * fields * (1.0F - reef));
  // The reef is pale on its flat and darkens down its outer face.
  const float flat = ramp(7.0F, 2.0F, depth + 1.5F * medium);
  const float growth = ramp(0.05F, 0.50F, medium + 0.6F * fine + 0.3F * grain + 0.12F);
  floor = mix(floor, mix(kForeReef, mix(kReefFlat, kCoral, 0.7F * growth), flat), reef);
  const float wash = ramp(2.5F, 0.5F, depth + 0.8F * medium) * gentle * ramp(160.0F, 70.0F, p.shore_m);
  floor = mix(floor, mix(kColdSand, kSand, warm), wash * (1.0F - 0.7F * reef));
  return {(1.0F + 0.20F * fine + 0.18F * grain) * floor, 0.4F, {}};
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
