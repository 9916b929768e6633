#include <benchmark/benchmark.h>

#include "seamount/geom/scalar/noise.h"
#include "seamount/io/find_model.h"
#include "seamount/ops/amplify/sparse.h"
#include "seamount/recipe/dictionary_file.h"

namespace seamount {
namespace {

void amplify_by_four(benchmark::State& state) {
  const auto size = static_cast<int>(state.range(0));
  HeightField terrain = geom::fbm_grid(GridFrame::centred(size, size, 40.0), Seed{3}, {.wavelength_m = 4.0 * size}, {});
  for (float& z : terrain.cells()) z = 1500.0F * z + 2000.0F;
  const amplify::Dictionary dictionary = recipe::read_dictionary(io::find_model("mountains"));
  for (auto _ : state) benchmark::DoNotOptimize(amplify::sparse(terrain, dictionary, {}, {}));
}
BENCHMARK(amplify_by_four)->Name("amplify/x4")->Arg(256)->Arg(512)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace seamount
