#include <benchmark/benchmark.h>

#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/classify/terrain.h"
#include "seamount/ops/terrain/blend.h"
#include "seamount/ops/terrain/layers.h"
#include "seamount/ops/terrain/mask.h"

namespace seamount {
namespace {

HeightField hills(int size) {
  HeightField terrain =
      geom::fbm_grid(GridFrame::centred(size, size, 10.0), Seed{3}, {.wavelength_m = 0.1 * 10.0 * size}, {});
  for (float& z : terrain.cells()) z = 500.0F * z - 50.0F;
  return terrain;
}

void mask_by(benchmark::State& state, const terrain::Criterion& criterion) {
  const HeightField terrain = hills(2048);
  for (auto _ : state) benchmark::DoNotOptimize(terrain::mask({terrain}, {.criteria = {criterion}}, Seed{1}, {}));
}
BENCHMARK_CAPTURE(mask_by, slope, terrain::BySlope{.low_deg = 20})
    ->Name("terrain/mask_slope/2048")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mask_by, curvature, terrain::ByCurvature{})
    ->Name("terrain/mask_curvature/2048")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mask_by, height, terrain::ByHeight{.low_m = 20})
    ->Name("terrain/mask_height/2048")
    ->Unit(benchmark::kMillisecond);

void blend(benchmark::State& state) {
  const HeightField a = hills(2048), b = hills(2048);
  for (auto _ : state) benchmark::DoNotOptimize(terrain::blend(a, b, nullptr, {.mode = terrain::BlendMode::max}, {}));
}
BENCHMARK(blend)->Name("terrain/blend_max/2048")->Unit(benchmark::kMillisecond);

void layers(benchmark::State& state) {
  const HeightField terrain = hills(2048);
  for (auto _ : state) benchmark::DoNotOptimize(terrain::layers(terrain, {}, {}));
}
BENCHMARK(layers)->Name("terrain/layers/2048")->Unit(benchmark::kMillisecond);

void classify_terrain(benchmark::State& state) {
  const HeightField terrain = hills(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(classify::terrain(terrain, {}, {}));
}
BENCHMARK(classify_terrain)->Name("classify/terrain")->Arg(1024)->Arg(2048)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace seamount
