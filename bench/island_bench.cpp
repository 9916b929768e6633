// Islands: a random polar plan, a drawn coast that is not star-shaped, and a training pair.
#include <benchmark/benchmark.h>

#include "seamount/ops/island/build.h"
#include "seamount/ops/island/coral.h"
#include "seamount/ops/island/wind.h"
#include "seamount/train/island_samples.h"

namespace {

using namespace seamount;

constexpr double kWidth_m = 20480;

void build_polar(benchmark::State& state, int size) {
  const GridFrame frame = GridFrame::centred(size, size, kWidth_m / size);
  uint64_t seed = 0;
  for (auto _ : state) {
    const island::Plan plan = island::random_plan(frame, {}, 0.35, Seed{seed}, {});
    benchmark::DoNotOptimize(island::build(plan, {}, frame, Seed{seed++}, {}));
  }
  state.SetItemsProcessed(state.iterations() * frame.cells());
}

/// A drawn coast with headlands and bays: not star-shaped.
std::vector<Polygon> crescent() {
  Ring ring;
  for (int i = 0; i < 120; ++i) {
    const double a = 5.0 * i / 119.0 - 2.5;
    ring.push_back({5200 * std::cos(a) - 500, 5200 * std::sin(a) + 150 * std::sin(7 * a)});
  }
  for (int i = 119; i >= 0; --i) {
    const double a = 5.0 * i / 119.0 - 2.5;
    ring.push_back({2100 * std::cos(a) - 500, 2300 * std::sin(a)});
  }
  return {{ring, {}}};
}

void build_areas(benchmark::State& state, int size) {
  const GridFrame frame = GridFrame::centred(size, size, kWidth_m / size);
  const island::Plan plan = island::plan_from_areas({{{"", crescent()}}, {}, {}}, {}, "areas");
  for (auto _ : state) benchmark::DoNotOptimize(island::build(plan, {}, frame, Seed{1}, {}));
  state.SetItemsProcessed(state.iterations() * frame.cells());
}

void dataset_pair(benchmark::State& state) {
  const train::IslandSetParams params;
  uint64_t index = 0;
  for (auto _ : state) {
    train::IslandSample sample = train::draw_island_sample(params, index++, Seed{1});
    benchmark::DoNotOptimize(train::make_island_pair(params, sample, Seed{1}, {}));
  }
}

BENCHMARK_CAPTURE(build_polar, polar, 256)->Name("island/build/256")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(build_polar, polar, 4096)->Name("island/build/4096")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(build_areas, areas, 256)
    ->Name("island/build_areas/256")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(build_areas, areas, 4096)
    ->Name("island/build_areas/4096")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(dataset_pair)->Name("island/dataset_pair/256")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
