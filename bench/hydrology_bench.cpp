// Water: fill, D8 and accumulation on a mountain island of 40 km, the same at every size.
#include <benchmark/benchmark.h>

#include <cmath>

#include "seamount/geom/water/flow.h"
#include "seamount/ops/hydrology/describe.h"
#include "seamount/ops/hydrology/fill.h"
#include "seamount/ops/hydrology/flow.h"
#include "seamount/ops/hydrology/lakes.h"
#include "seamount/ops/hydrology/rivers.h"
#include "seamount/ops/sketch/extract.h"
#include "seamount/ops/terrain/noise.h"

namespace {

using namespace seamount;

constexpr double kWidth_m = 40960;

HeightField mountains(int size) {
  terrain::NoiseParams params;
  params.kind = terrain::NoiseKind::smooth;
  params.height_m = 1500;
  params.wavelength_m = 12000;
  params.octaves = 10;
  params.base_m = 300;
  return terrain::noise(params, GridFrame::centred(size, size, kWidth_m / size), Seed{7}, {});
}

void flow(benchmark::State& state) {
  const HeightField terrain = mountains(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const HeightField filled = geom::fill_depressions(terrain, 0.0F, {});
    const geom::FlowDirections directions = geom::flow_directions(filled, 0.0F, {});
    benchmark::DoNotOptimize(geom::flow_accumulation(directions, {}));
  }
  state.SetComplexityN(terrain.frame().cells());
  state.SetItemsProcessed(state.iterations() * terrain.frame().cells());
}

BENCHMARK(flow)
    ->Name("hydrology/flow")
    ->RangeMultiplier(2)
    ->Range(1024, 16384)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity(benchmark::oN);

void fill(benchmark::State& state) {
  const HeightField terrain = mountains(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(geom::fill_depressions(terrain, 0.0F, {}));
}
BENCHMARK(fill)->Name("hydrology/fill")->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A plain of flats: whole metres of 10 m of relief.
void breach(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  HeightField plain = terrain::noise(
      {.kind = terrain::NoiseKind::smooth, .height_m = 10, .wavelength_m = 6000, .octaves = 10, .base_m = 200},
      GridFrame::centred(size, size, 30), Seed{7}, {});
  for (float& z : plain.cells()) z = std::round(z);
  for (auto _ : state)
    benchmark::DoNotOptimize(hydrology::fill(plain, {.depressions = hydrology::Depressions::breach}, {}));
}
BENCHMARK(breach)->Name("hydrology/breach_flats")->Arg(2048)->Unit(benchmark::kMillisecond)->UseRealTime();

void lakes(benchmark::State& state) {
  const HeightField terrain = mountains(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(hydrology::lakes(terrain, nullptr, {}, {}));
}
BENCHMARK(lakes)->Name("hydrology/lakes")->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

void flow_dinf(benchmark::State& state) {
  const HeightField terrain = mountains(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(hydrology::flow(terrain, {.method = hydrology::FlowMethod::dinf}, {}));
}
BENCHMARK(flow_dinf)->Name("hydrology/flow_dinf")->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

void rivers(benchmark::State& state) {
  const HeightField terrain = mountains(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(hydrology::rivers(terrain, {.min_area_m2 = 1e6}, {}));
}
BENCHMARK(rivers)->Name("hydrology/rivers")->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

void ridges(benchmark::State& state) {
  const HeightField terrain = mountains(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(hydrology::ridges(terrain, {.min_area_m2 = 1e6}, {}));
}
BENCHMARK(ridges)->Name("hydrology/ridges")->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

void describe(benchmark::State& state) {
  const HeightField terrain = mountains(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(hydrology::describe(terrain, nullptr, {}, {}));
}
BENCHMARK(describe)->Name("hydrology/describe")->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

void extract(benchmark::State& state) {
  const HeightField terrain = mountains(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(sketch::extract(terrain, {}, Seed{1}, {}));
}
BENCHMARK(extract)->Name("sketch/extract")->Arg(256)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
