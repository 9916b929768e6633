// Registration of the sketch family.
#include "seamount/ops/sketch/extract.h"
#include "seamount/ops/sketch/levelset.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {
namespace {

Values extract(const sketch::ExtractParams& params, const Call& call) {
  sketch::Sketch made = sketch::extract(call.in.at("terrain").heights(), params, call.seed, call.run);
  return {{"image", Value::image(std::move(made.image))},         {"lines", Value::drawing(std::move(made.lines))},
          {"river", Value::field(std::move(made.river))},         {"ridge", Value::field(std::move(made.ridge))},
          {"altitude", Value::field(std::move(made.altitude_m))}, {"cue", Value::field(std::move(made.cue))}};
}

Values levelset(const sketch::LevelsetParams& params, const Call& call) {
  sketch::Levelset made = sketch::levelset(call.in.at("terrain").heights(), params, call.run);
  return {{"image", Value::image(std::move(made.image))},
          {"areas", Value::drawing(std::move(made.areas))},
          {"levelset", Value::field(std::move(made.mask))}};
}

}  // namespace

void add_sketch_operators(Registry& registry) {
  const Port terrain_in = {"terrain", ValueKind::terrain, "heights in metres"};
  registry.add<sketch::ExtractParams>(
      {.name = "sketch.extract",
       .revision = 2,
       .summary = "The sketch of a terrain: coarse rivers and ridges, one pixel wide, and heights of peaks and basins",
       .source = "P1 sec. 5.1, fig. 6-8",
       .stochastic = true,
       .in = {terrain_in},
       .out = {{"image", ValueKind::image, "ridges red, rivers blue, cues green by height, nothing black"},
               {"lines", ValueKind::drawing, "lines of value 0 (river) or 1 (ridge), and cues as points"},
               {"river", ValueKind::field, "1 on rivers, else 0"},
               {"ridge", ValueKind::field, "1 on ridges, else 0"},
               {"altitude", ValueKind::field, "height in metres at the cues, 0 elsewhere"},
               {"cue", ValueKind::field, "1 where altitude counts, else 0"}}},
      extract);
  registry.add<sketch::LevelsetParams>({.name = "sketch.levelset",
                                        .revision = 2,
                                        .summary = "The high part of a terrain as an area",
                                        .source = "P1 sec. 5.2, fig. 9",
                                        .in = {terrain_in},
                                        .out = {{"image", ValueKind::image, "white inside, black outside"},
                                                {"areas", ValueKind::drawing, "the area, with level_m"},
                                                {"levelset", ValueKind::field, "1 inside, 0 outside"}}},
                                       levelset);
}

}  // namespace seamount::recipe
