#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/learned/convolver.h"
#include "seamount/ops/learned/erode.h"
#include "seamount/ops/learned/erode_planes.h"
#include "seamount/ops/learned/island.h"
#include "seamount/ops/learned/network.h"
#include "seamount/ops/learned/sketch.h"
#include "seamount/ops/learned/sketch_planes.h"

namespace seamount {
namespace {

/// Weights by chance: as fast as any.
learned::Network some_network(learned::Precision precision, const learned::Architecture& architecture = {}) {
  Weights weights;
  describe(architecture, weights);
  for (const learned::Convolution& c : convolutions(architecture)) {
    Tensor weight{{c.out, c.in, c.kernel, c.kernel}, {}};
    Rng rng(Seed{weights.tensors.size()});
    const double size = std::sqrt(3.0 / (c.in * c.kernel * c.kernel));
    for (int i = 0; i < c.out * c.in * c.kernel * c.kernel; ++i)
      weight.values.push_back(static_cast<float>(rng.uniform(-size, size)));
    weights.tensors[c.name + ".weight"] = std::move(weight);
    weights.tensors[c.name + ".bias"] = {{c.out}, std::vector<float>(static_cast<size_t>(c.out), 0.01F)};
  }
  return learned::Network(weights, precision);
}

void evaluate(benchmark::State& state, learned::Precision precision) {
  if (precision == learned::Precision::bf16 && !learned::has_bf16())
    return state.SkipWithError("this processor has no bf16");
  const auto size = static_cast<int>(state.range(0));
  const learned::Network network = some_network(precision);
  const learned::Planes planes{size, size, network.architecture().planes, [](int, int, std::span<float> values) {
                                 std::fill(values.begin(), values.end(), 0.5F);
                               }};
  const GridFrame frame = GridFrame::centred(size, size, 10.0);
  benchmark::DoNotOptimize(network.evaluate(planes, frame, {}));  // makes oneDNN's kernels
  for (auto _ : state) benchmark::DoNotOptimize(network.evaluate(planes, frame, {}));
}
BENCHMARK_CAPTURE(evaluate, bf16, learned::Precision::bf16)
    ->Name("learned/network/bf16")
    ->Arg(256)
    ->Arg(512)
    ->Arg(1024)
    ->Arg(4096)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(evaluate, f32, learned::Precision::f32)
    ->Name("learned/network/f32")
    ->Arg(256)
    ->Arg(512)
    ->Arg(1024)
    ->Arg(4096)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// The whole of learned.sketch: lines to planes, network, heights.
void sketch(benchmark::State& state, learned::Precision precision) {
  if (precision == learned::Precision::bf16 && !learned::has_bf16())
    return state.SkipWithError("this processor has no bf16");
  const auto size = static_cast<int>(state.range(0));
  const learned::Network network = some_network(precision);
  const GridFrame frame = GridFrame::centred(size, size, 30.0);
  learned::SketchParams params;
  const double half = 0.5 * frame.width_m();
  params.ridges = {{{{-0.8 * half, -0.5 * half}, {0, 0.2 * half}, {0.7 * half, 0.6 * half}}}};
  params.rivers = {{{{-0.7 * half, 0.8 * half}, {0.1 * half, -0.4 * half}, {0.9 * half, -0.6 * half}}}};
  params.heights = {{0, 0.2 * half, 1500}};
  benchmark::DoNotOptimize(learned::sketch({}, params, network, frame, Seed{1}, {}));
  for (auto _ : state) benchmark::DoNotOptimize(learned::sketch({}, params, network, frame, Seed{1}, {}));
}
BENCHMARK_CAPTURE(sketch, bf16, learned::Precision::bf16)
    ->Name("learned/sketch/bf16")
    ->Arg(256)
    ->Arg(512)
    ->Arg(1024)
    ->Arg(4096)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sketch, f32, learned::Precision::f32)
    ->Name("learned/sketch/f32")
    ->Arg(256)
    ->Arg(512)
    ->Arg(1024)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// The whole of learned.erode.
void erode(benchmark::State& state, learned::Precision precision) {
  if (precision == learned::Precision::bf16 && !learned::has_bf16())
    return state.SkipWithError("this processor has no bf16");
  const auto size = static_cast<int>(state.range(0));
  const learned::Network network =
      some_network(precision, {.planes = learned::kErodePlanes, .widths = {16, 32, 64, 96}});
  HeightField ground = geom::fbm_grid(GridFrame::centred(size, size, 20), Seed{1}, {.wavelength_m = 5000}, {});
  for (float& z : ground.cells()) z = 800 * z + 1000;
  benchmark::DoNotOptimize(learned::erode(ground, nullptr, {}, network, {}));
  for (auto _ : state) benchmark::DoNotOptimize(learned::erode(ground, nullptr, {}, network, {}));
}
BENCHMARK_CAPTURE(erode, bf16, learned::Precision::bf16)
    ->Name("learned/erode/bf16")
    ->Arg(256)
    ->Arg(1024)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// The whole of learned.island, of rings around the middle.
void island(benchmark::State& state) {
  const auto size = static_cast<int>(state.range(0));
  const learned::Network network = some_network(learned::Precision::automatic, {.planes = learned::kIslandPlanes});
  LabelMap labels(GridFrame::centred(size, size, 20480.0 / size), Region::abyss);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double r = 2 * std::hypot(x - 0.5 * size, y - 0.5 * size) / size;
      if (r < 0.8) labels(x, y) = kRegions[static_cast<size_t>(r / 0.2)];
    }
  }
  for (auto _ : state) {
    learned::IslandMap map;
    map.frame = labels.frame();
    map.shares = learned::shares_of(labels, {});
    benchmark::DoNotOptimize(learned::island(map, network, Seed{1}, {}));
  }
}
BENCHMARK(island)->Name("learned/island")->Arg(256)->Arg(1024)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace seamount
