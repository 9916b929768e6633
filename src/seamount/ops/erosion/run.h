// erosion.run: years of rain, rivers, slides and waves on a terrain of bedrock, rock and sediment.
//
// Rivers cut into the ground by their discharge and slope, carry what they cut and drop it where they slow down, so
// that drained valleys, filled valley floors and fans appear; soil creeps, and rock that stands too steep over its
// valley fails (rivers.h); bare rock weathers, and debris slides to its angle (slopes.h); waves cut the coast and
// sediment settles under water (coast.h). Water always finds a way out (drainage.h). Cf. P1 sec. 5.4, which simulates
// interleaved hydraulic and thermal erosion of the same three layers by stochastic events after Cordonnier et al. 2017;
// we solve for the same processes with implicit steps of many years.
//
// The run goes from coarse to fine (levels.h): it begins on a grid of about 64 cells a side and each finer grid takes a
// share of the remaining years, so that valleys of all sizes have had their time, and a small grid previews a large
// one; a run of fewer years shows the same valleys younger, so that frames of an animation are runs whose years rise.
// method stream_power leaves out what rivers carry, weathering and waves: the detachment-limited law with uplift,
// whose steady state is a mountain range (Braun and Willett 2013, Cordonnier et al. 2016).
#pragma once

#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/ops/erosion/ground.h"

namespace seamount::erosion {

enum class Method { hydraulic, stream_power };

struct RunParams {
  Method method = Method::hydraulic;
  double years = 100000;
  double rain_m = 1.0;
  double evaporation_per_km = 0.0;
  double erodibility = 5e-5;
  double rock_variation = 0.6;
  double rock_ease = 2.0;
  double sediment_ease = 5.0;
  double deposition = 1.0;
  double fan_m = 400;
  double channel_m2 = 1000;
  double uplift_mm = 0.0;
  double weathering_mm = 0.2;
  double bedrock_angle_deg = 40;
  double rock_angle_deg = 33;
  double sediment_angle_deg = 22;
  double creep_m2 = 0.005;
  double sea_m = 0.0;
  double retreat_mm = 2.0;
  double wave_base_m = 8.0;
  double settling_m = 4000;

  static constexpr auto fields() {
    using P = RunParams;
    return std::tuple(
        field(&P::method, "method",
              "hydraulic: rivers that also deposit, weathering, waves; stream_power: rivers that only cut, creep, "
              "failing slopes"),
        field(&P::years, "years", "yr", between(0, 1e9), "how long erosion acts"),
        field(&P::rain_m, "rain_m", "m", between(0.001, 20), "runoff per year"),
        field(&P::evaporation_per_km, "evaporation_per_km", "1/km", between(0, 1),
              "share of a river's water that is lost on a kilometre"),
        field(&P::erodibility, "erodibility", "", between(0, 0.1),
              "K in K sqrt(discharge) slope, the metres per year that rivers cut into bedrock; hard rock 1e-6, soft "
              "1e-4"),
        field(
            &P::rock_variation, "rock_variation", "", between(0, 0.95),
            "how much bedrock's hardness varies from place to place: v makes it up to (1 + v) / (1 - v) times as hard"),
        field(&P::rock_ease, "rock_ease", "", between(0.01, 1000),
              "how much more easily rivers cut debris than bedrock"),
        field(&P::sediment_ease, "sediment_ease", "", between(0.01, 1000),
              "how much more easily rivers cut fine sediment than bedrock"),
        field(&P::deposition, "deposition", "", between(0, 10),
              "how readily rivers drop their load (G): 0 never, 1 as in most rivers, more fills valleys"),
        field(&P::fan_m, "fan_m", "m", between(0, 100000),
              "width over which rivers lay down their load where they leave their valleys: 0 narrow beds, more makes "
              "fans "
              "and aprons"),
        field(&P::channel_m2, "channel_m2", "m2", between(0, 1e8), "area that is drained without a channel"),
        field(&P::uplift_mm, "uplift_mm", "mm", between(0, 100), "rise of the land per year, times the input `uplift`"),
        field(&P::weathering_mm, "weathering_mm", "mm", between(0, 100),
              "bedrock that crumbles per year where it is bare and steep"),
        field(&P::bedrock_angle_deg, "bedrock_angle_deg", "deg", between(1, 89),
              "steepest slope of bedrock; rock four times as hard stands twice as steep"),
        field(&P::rock_angle_deg, "rock_angle_deg", "deg", between(1, 89), "steepest slope of rock debris"),
        field(&P::sediment_angle_deg, "sediment_angle_deg", "deg", between(1, 89), "steepest slope of fine sediment"),
        field(&P::creep_m2, "creep_m2", "m2", between(0, 10),
              "diffusivity of soil per year: rounds crests and spaces valleys; 0.001 dry to 0.05 wet"),
        field(&P::sea_m, "sea_m", "m", between(-12000, 9000), "level of the sea; far below the terrain for none"),
        field(&P::retreat_mm, "retreat_mm", "mm", between(0, 10000), "retreat of exposed cliffs per year"),
        field(&P::wave_base_m, "wave_base_m", "m", between(0.1, 200), "depth down to which waves move sediment"),
        field(&P::settling_m, "settling_m", "m", between(1, 1e6),
              "distance over which most of a river's load settles in the sea"));
  }
};

struct Eroded {
  HeightField terrain;
  ScalarField rock;      ///< thickness of debris, m
  ScalarField sediment;  ///< thickness of fine sediment, m
  ScalarField flow;      ///< discharge, m3 per year, at the end
  ScalarField lake;      ///< depth of standing water on land, m
  Ledger ledger;
};

/// Erodes a terrain. Maps are optional (empty) and cover the same frame: hardness > 0, mask in [0, 1], uplift and rain
/// >= 0; `rock` and `sediment` are what already lies on the bedrock. Zero years change nothing. The terrain loses to
/// the border what ledger.exported says, and nothing else (to 1e-4). Throws InvalidArgument for params out of range,
/// IncompatibleInputs for maps of another size. Parallel but for the order of the rivers; about 3 us and 46 bytes per
/// cell.
Eroded run(Ground ground, Site site, const RunParams& params, Seed seed, const RunContext& run);

}  // namespace seamount::erosion

template <>
struct seamount::Choices<seamount::erosion::Method> {
  static constexpr std::array<std::string_view, 2> names = {"hydraulic", "stream_power"};
};
