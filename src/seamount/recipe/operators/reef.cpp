// Registration of the reef family.
#include "seamount/ops/reef/grow.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

std::tuple<HeightField, ScalarField, LabelMap, Drawing> grow(const reef::GrowParams& params, const Call& call,
                                                             const HeightField& terrain, const LabelMap* labels,
                                                             const ScalarField* habitat, const ScalarField* start,
                                                             const Drawing* drawing) {
  reef::Grown grown = reef::grow({terrain, labels, habitat, start, drawing}, params, call.seed, call.run);
  Drawing outlines = reef::reef_outlines(grown.aggregate, call.run);
  return {std::move(grown.terrain), std::move(grown.aggregate), std::move(grown.labels), std::move(outlines)};
}

}  // namespace

void add_reef_operators(Registry& registry) {
  registry.add(make_operator<reef::GrowParams>(
      {.name = "reef.grow",
       .revision = 5,
       .summary = "Grows barrier reefs, ribbon reefs and patch reefs by diffusion-limited aggregation",
       .source = "P4 sec. 3.2-3.3, eq. 1 and 2",
       .stochastic = true},
      inputs(with_voids(in<kinds::Terrain>("terrain", "heights in metres: the ground on which the reef grows")),
             optional_in<kinds::Labels>("labels", "its regions; places without reef keep them"),
             optional_in<kinds::Field>("habitat", "particles settle only where it is at least 0.5"),
             optional_in<kinds::Field>("start", "random kernels lie where it is at least 0.5"),
             optional_in<kinds::Drawing>("drawing", "lines along which, and areas in which growth starts")),
      outputs(out<kinds::Terrain>("terrain", "heights in metres"),
              out<kinds::Field>("aggregate", "1 on the reef, 0 outside, soft at its edge"),
              out<kinds::Labels>("labels", "reef, the lagoon behind it, land by height, abyss: the open sea"),
              out<kinds::Drawing>("outlines", "the reef's outlines, as one area named reef")),
      grow));
}

}  // namespace seamount::recipe
