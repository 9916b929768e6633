#include <benchmark/benchmark.h>

#include "seamount/ops/render/map.h"
#include "seamount/ops/render/perspective.h"
#include "seamount/ops/render/test_terrain.h"

namespace seamount {
namespace {

void draw_perspective(benchmark::State& state, int cells) {
  const HeightField terrain = render::test_island(cells, cells, 24000.0, 1500.0);
  for (auto _ : state) benchmark::DoNotOptimize(render::perspective(terrain, nullptr, {}, {}));
}
BENCHMARK_CAPTURE(draw_perspective, 2048, 2048)->Name("render/perspective/1280x720")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(draw_perspective, 4096, 4096)
    ->Name("render/perspective_of_4096/1280x720")
    ->Unit(benchmark::kMillisecond);

void draw_map(benchmark::State& state) {
  const HeightField terrain = render::test_island(1024, 1024, 24000.0, 1500.0);
  for (auto _ : state) benchmark::DoNotOptimize(render::map(terrain, nullptr, {}, {}));
}
BENCHMARK(draw_map)->Name("render/map/1600")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace seamount
