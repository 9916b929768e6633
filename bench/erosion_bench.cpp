// Erosion: rough noise worn down to valleys, fans and talus; a range raised from a plain.
#include <benchmark/benchmark.h>

#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/erosion/run.h"

namespace {

using namespace seamount;

constexpr double kWidth_m = 10240;

HeightField rough(int size, float height_m, float base_m) {
  const GridFrame frame = GridFrame::centred(size, size, kWidth_m / size);
  HeightField z = geom::fbm_grid(frame, Seed{3}, {.wavelength_m = 5000, .octaves = 8, .cell_m = frame.cell_m}, {});
  for (float& value : z.cells()) value = base_m + height_m * value;
  return z;
}

void erode(benchmark::State& state, const erosion::RunParams& params, float height_m) {
  const HeightField start = rough(static_cast<int>(state.range(0)), height_m, 600);
  for (auto _ : state) benchmark::DoNotOptimize(erosion::run({start, {}, {}}, {}, params, Seed{1}, {}));
  state.SetItemsProcessed(state.iterations() * start.frame().cells());
  state.SetComplexityN(start.frame().cells());
}

void hydraulic(benchmark::State& state) { erode(state, {}, 900); }

void stream_power(benchmark::State& state) {
  erode(state, {.method = erosion::Method::stream_power, .years = 2e6, .uplift_mm_yr = 0.5}, 30);
}

BENCHMARK(hydraulic)
    ->Name("erosion/run")
    ->RangeMultiplier(2)
    ->Range(256, 2048)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity();
BENCHMARK(stream_power)
    ->Name("erosion/streampower")
    ->Arg(1024)
    ->Arg(2048)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
