// Glaciers on hills of the size of the Alps.
#include <benchmark/benchmark.h>

#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/glacier/run.h"

namespace {

using namespace seamount;

void carve(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const GridFrame frame = GridFrame::centred(size, size, 24000.0 / size);
  HeightField start = geom::fbm_grid(frame, Seed{3}, {.wavelength_m = 8000, .octaves = 8, .cell_m = frame.cell_m}, {});
  for (float& value : start.cells()) value = 1500 + 1500 * value;
  for (auto _ : state) benchmark::DoNotOptimize(glacier::run(start, {}, {}, {}));
  state.SetItemsProcessed(state.iterations() * frame.cells());
}

BENCHMARK(carve)->Name("glacier/run")->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
