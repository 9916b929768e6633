// Registration of the sketch family.
#include "seamount/ops/sketch/extract.h"
#include "seamount/ops/sketch/levelset.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

std::tuple<Image, Drawing, ScalarField, ScalarField, ScalarField, ScalarField> extract(
    const sketch::ExtractParams& params, const Call& call, const HeightField& terrain) {
  sketch::Sketch made = sketch::extract(terrain, params, call.seed, call.run);
  return {std::move(made.image), std::move(made.lines),      std::move(made.river),
          std::move(made.ridge), std::move(made.altitude_m), std::move(made.cue)};
}

std::tuple<Image, Drawing, ScalarField> levelset(const sketch::LevelsetParams& params, const Call& call,
                                                 const HeightField& terrain) {
  sketch::Levelset made = sketch::levelset(terrain, params, call.run);
  return {std::move(made.image), std::move(made.areas), std::move(made.mask)};
}

}  // namespace

void add_sketch_operators(Registry& registry) {
  registry.add(make_operator<sketch::ExtractParams>(
      {.name = "sketch.extract",
       .revision = 3,
       .summary = "The sketch of a terrain: coarse rivers and ridges, one pixel wide, and heights of peaks and basins",
       .source = "P1 sec. 5.1, fig. 6-8",
       .stochastic = true},
      inputs(with_voids(in<kinds::Terrain>("terrain", "heights in metres"))),
      outputs(out<kinds::Image>(
                  "image",
                  "ridges red 255, rivers blue 255, cues green by height: 32 the lowest, 255 the highest; nothing 0"),
              out<kinds::Drawing>(
                  "lines",
                  "lines of value 0 (river) or 1 (ridge), and cues as points with height, basin (1 or 0) and green"),
              out<kinds::Field>("river", "1 on rivers, else 0"), out<kinds::Field>("ridge", "1 on ridges, else 0"),
              out<kinds::Field>("altitude", "height in metres at the cues, 0 elsewhere"),
              out<kinds::Field>("cue", "1 where altitude counts, else 0")),
      extract));
  registry.add(
      make_operator<sketch::LevelsetParams>({.name = "sketch.levelset",
                                             .revision = 4,
                                             .summary = "The high part of a terrain as an area",
                                             .source = "P1 sec. 5.2, fig. 9"},
                                            inputs(with_voids(in<kinds::Terrain>("terrain", "heights in metres"))),
                                            outputs(out<kinds::Image>("image", "white inside, black outside"),
                                                    out<kinds::Drawing>("areas", "the area, with level_m"),
                                                    out<kinds::Field>("levelset", "1 inside, 0 outside")),
                                            levelset));
}

}  // namespace seamount::recipe
