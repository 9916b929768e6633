// Parameters of erosion.run (run.h). Rates are per year.
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/presets.h"
#include "seamount/ops/erosion/lithology_params.h"

namespace seamount::erosion {

enum class Method { hydraulic, stream_power };

/// What rivers carry and where they drop it (rivers.h).
struct RiverParams {
  double deposition = 1.0;
  double fan_m = 400;
  double debris_ease = 2.0;
  double sediment_ease = 5.0;
  double evaporation_per_km = 0.0;
  double channel_m2 = 1000;

  static constexpr auto fields() {
    using P = RiverParams;
    return std::tuple(
        field(&P::deposition, "deposition", "", between(0, 10),
              "how readily rivers drop their load (G): 0 never, 1 as in most rivers, more fills valleys"),
        field(&P::fan_m, "fan_m", "m", between(0, 100000),
              "width over which rivers lay down their load where they leave their valleys: 0 narrow beds, more makes "
              "fans and aprons"),
        field(&P::debris_ease, "debris_ease", "", between(0.01, 1000),
              "how much more easily rivers cut debris than bedrock"),
        field(&P::sediment_ease, "sediment_ease", "", between(0.01, 1000),
              "how much more easily rivers cut fine sediment than bedrock"),
        field(&P::evaporation_per_km, "evaporation_per_km", "1/km", between(0, 1),
              "share of a river's water that is lost on a kilometre"),
        field(&P::channel_m2, "channel_m2", "m2", between(0, 1e8), "area that is drained without a channel"));
  }
};

/// What slopes can stand, and how they wear (slopes.h, repose.h).
struct SlopeParams {
  double bedrock_angle_deg = 40;
  double debris_angle_deg = 33;
  double sediment_angle_deg = 22;
  double creep_m2_yr = 0.005;
  double weathering_mm_yr = 0.1;

  static constexpr auto fields() {
    using P = SlopeParams;
    return std::tuple(
        field(&P::bedrock_angle_deg, "bedrock_angle_deg", "deg", between(1, 89),
              "steepest slope of bedrock, which joints vary with hardness_variation; rock four times as hard stands "
              "twice as "
              "steep"),
        field(&P::debris_angle_deg, "debris_angle_deg", "deg", between(1, 89), "steepest slope of debris"),
        field(&P::sediment_angle_deg, "sediment_angle_deg", "deg", between(1, 89), "steepest slope of fine sediment"),
        field(&P::creep_m2_yr, "creep_m2_yr", "m2/yr", between(0, 10),
              "diffusivity of soil: rounds crests and spaces valleys; 0.001 dry to 0.05 wet"),
        field(&P::weathering_mm_yr, "weathering_mm_yr", "mm/yr", between(0, 100),
              "bedrock that crumbles where it is bare and steep"));
  }
};

/// What waves do (coast.h).
struct CoastParams {
  double retreat_mm_yr = 2.0;
  double wave_base_m = 8.0;
  double settling_m = 4000;

  static constexpr auto fields() {
    using P = CoastParams;
    return std::tuple(
        field(&P::retreat_mm_yr, "retreat_mm_yr", "mm/yr", between(0, 10000), "retreat of exposed cliffs"),
        field(&P::wave_base_m, "wave_base_m", "m", between(0.1, 200), "depth down to which waves move sediment"),
        field(&P::settling_m, "settling_m", "m", between(1, 1e6),
              "distance over which most of a river's load settles in the sea"));
  }
};

struct RunParams {
  Method method = Method::hydraulic;
  double years = 300000;
  double uplift_mm_yr = 0.0;
  double runoff_mm_yr = 1000.0;
  double erodibility = 1e-5;
  double hardness_variation = 0.6;
  double sea_m = 0.0;
  RiverParams rivers;
  SlopeParams slopes;
  CoastParams coast;
  LithologyParams lithology;

  static constexpr auto fields() {
    using P = RunParams;
    return std::tuple(
        field(&P::method, "method",
              "hydraulic: rivers that also deposit, weathering, waves; stream_power: rivers that only cut, creep, "
              "failing slopes"),
        field(&P::years, "years", "yr", between(0, 1e9), "how long erosion acts"),
        field(&P::uplift_mm_yr, "uplift_mm_yr", "mm/yr", between(0, 100), "rise of the land, times the input `uplift`"),
        field(&P::runoff_mm_yr, "runoff_mm_yr", "mm/yr", between(1, 20000),
              "rain that runs off, times the input `rain`"),
        field(&P::erodibility, "erodibility", "1/sqrt(m yr)", between(0, 0.1),
              "K in K sqrt(discharge) slope, the metres per year that rivers cut into bedrock by their discharge in "
              "m3/yr; hard rock 1e-6, soft 1e-4, loose ground 1e-3"),
        field(&P::hardness_variation, "hardness_variation", "", between(0, 0.95),
              "how much bedrock's hardness varies from place to place: v makes it up to (1 + v) / (1 - v) times as "
              "hard"),
        field(&P::sea_m, "sea_m", "m", between(-12000, 9000), "level of the sea; far below the terrain for none"),
        field(&P::rivers, "rivers", "what rivers carry and where they drop it"),
        field(&P::slopes, "slopes", "what slopes can stand and how they wear"),
        field(&P::coast, "coast", "what waves do to the coast"),
        field(&P::lithology, "lithology", "beds of harder and softer rock in three dimensions"));
  }

  static constexpr auto presets() {
    using P = RunParams;
    return std::array{
        preset<P>("young", "steep land that the first gullies and gorges cut",
                  [](P& p) {
                    p.years = 30000;
                    p.slopes.creep_m2_yr = 0.002;
                  }),
        preset<P>("mature", "sharp ridges between branching valleys, with floors where rivers are large",
                  [](P& p) { p.years = 250000; }),
        preset<P>("old", "the low rest of hills, rounded, over wide plains of their debris",
                  [](P& p) {
                    p.years = 700000;
                    p.slopes.creep_m2_yr = 0.04;
                    p.slopes.bedrock_angle_deg = 28;
                  }),
        preset<P>("desert", "bare steep ranges cut by many gullies, over aprons of debris and dry basins", [](P& p) {
          p.years = 120000;
          p.runoff_mm_yr = 100;
          p.erodibility = 3e-5;
          p.slopes.bedrock_angle_deg = 60;
          p.slopes.creep_m2_yr = 0.001;
          p.slopes.weathering_mm_yr = 0.3;
          p.rivers.evaporation_per_km = 0.08;
          p.rivers.fan_m = 1000;
          p.rivers.deposition = 2;
        })};
  }

  static constexpr std::array kFormerNames = {FormerName{"uplift_mm", "uplift_mm_yr"},
                                              FormerName{"rain_m", "runoff_mm_yr", 1000.0},
                                              FormerName{"rock_variation", "hardness_variation"},
                                              FormerName{"deposition", "rivers.deposition"},
                                              FormerName{"fan_m", "rivers.fan_m"},
                                              FormerName{"rock_ease", "rivers.debris_ease"},
                                              FormerName{"sediment_ease", "rivers.sediment_ease"},
                                              FormerName{"evaporation_per_km", "rivers.evaporation_per_km"},
                                              FormerName{"channel_m2", "rivers.channel_m2"},
                                              FormerName{"bedrock_angle_deg", "slopes.bedrock_angle_deg"},
                                              FormerName{"rock_angle_deg", "slopes.debris_angle_deg"},
                                              FormerName{"sediment_angle_deg", "slopes.sediment_angle_deg"},
                                              FormerName{"creep_m2", "slopes.creep_m2_yr"},
                                              FormerName{"weathering_mm", "slopes.weathering_mm_yr"},
                                              FormerName{"retreat_mm", "coast.retreat_mm_yr"},
                                              FormerName{"wave_base_m", "coast.wave_base_m"},
                                              FormerName{"settling_m", "coast.settling_m"}};
};

}  // namespace seamount::erosion

template <>
struct seamount::Choices<seamount::erosion::Method> {
  static constexpr std::array<std::string_view, 2> names = {"hydraulic", "stream_power"};
};
