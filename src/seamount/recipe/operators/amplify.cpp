// Registration of the amplify family.
#include "seamount/ops/amplify/sparse.h"
#include "seamount/recipe/dictionary_file.h"
#include "seamount/recipe/ports.h"

namespace seamount::recipe {
namespace {

using kinds::Terrain;

HeightField sparse(const amplify::SparseParams& params, const Call& call, const HeightField& terrain) {
  if (params.dictionary.name.empty()) throw InvalidArgument("dictionary", "is missing");
  return amplify::sparse(terrain, read_dictionary(call.resolve(params.dictionary)), params, call.run);
}

}  // namespace

void add_amplify_operators(Registry& registry) {
  registry.add(make_operator<amplify::SparseParams>(
      {.name = "amplify.sparse",
       .revision = 1,
       .summary = "A terrain on cells of a half, a quarter or an eighth, with the detail of real ground",
       .source = "P1 sec. 6.2; Guerin et al. 2016"},
      inputs(with_voids(in<Terrain>("terrain", "heights in metres, each the mean of its cell"))),
      outputs(with_voids(out<Terrain>("terrain", "heights in metres on the finer cells"))), sparse));
}

}  // namespace seamount::recipe
