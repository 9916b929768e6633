// Registration of what places things.
#include "seamount/io/thing_file.h"
#include "seamount/ops/ecosystem/scatter.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

Things scatter(const ecosystem::ScatterParams& params, const Call& call, const HeightField& terrain,
               const ScalarField* density, const Drawing* places, const Things* others) {
  ecosystem::ScatterInputs inputs{terrain, density, places, others, nullptr};
  if (params.thing.shape == ThingForm::file) {
    if (params.thing.file.path.empty()) throw InvalidArgument("thing.file", "shape file needs the name of a file");
    inputs.mesh = std::make_shared<const ThingMesh>(io::read_thing(call.resolve(params.thing.file), call.run));
  }
  return ecosystem::scatter(inputs, params, call.seed, call.run);
}

}  // namespace

void add_thing_operators(Registry& registry) {
  registry.add(make_operator<ecosystem::ScatterParams>(
      {.name = "ecosystem.scatter",
       .summary = "Spreads trees, corals, rocks or models of your own over a terrain, at drawn places or by a density",
       .stochastic = true},
      inputs(with_voids(in<kinds::Terrain>("terrain", "heights in metres")),
             optional_in<kinds::Field>("density", "share of the places that are taken, 0 to 1"),
             optional_in<kinds::Drawing>("places", "points: one stands on each; or areas that they stand in"),
             optional_in<kinds::Things>("others", "things that come along")),
      outputs(out<kinds::Things>("things", "models and where they stand")), scatter));
}

}  // namespace seamount::recipe
