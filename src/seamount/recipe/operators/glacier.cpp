// Registration of the glacier family.
#include "seamount/ops/glacier/run.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Field;

std::tuple<HeightField, HeightField, ScalarField, ScalarField> run(const glacier::RunParams& params, const Call& call,
                                                                   const HeightField& terrain,
                                                                   const ScalarField* hardness) {
  glacier::Carved made = glacier::run(terrain, hardness == nullptr ? ScalarField() : *hardness, params, call.run);
  return {std::move(made.terrain), std::move(made.surface), std::move(made.ice), std::move(made.worn)};
}

}  // namespace

void add_glacier_operators(Registry& registry) {
  registry.add(make_operator<glacier::RunParams>(
      {.name = "glacier.run",
       .revision = 2,
       .summary = "Ice that gathers over the equilibrium line, flows, and carves valleys and cirques",
       .source = "Mahaffy 1976; Oerlemans 1984; Braun, Zwartz and Tomkin 1999"},
      inputs(in<kinds::Terrain>("terrain", "heights in metres"),
             optional_in<Field>("hardness", "how many times as hard as `abrasion` says; 1 if absent")),
      outputs(out<kinds::Terrain>("terrain", "heights in metres when the ice has gone"),
              out<kinds::Terrain>("surface", "heights of ground and ice in metres at the end of the years"),
              out<Field>("ice", "thickness of the ice in metres at the end of the years"),
              out<Field>("worn", "metres by which the ground was carved")),
      run));
}

}  // namespace seamount::recipe
