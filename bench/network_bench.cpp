#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/ops/learned/convolver.h"
#include "seamount/ops/learned/network.h"

namespace seamount {
namespace {

/// The default architecture with weights by chance: as fast as any.
learned::Network some_network(learned::Precision precision) {
  Weights weights;
  const learned::Architecture architecture;
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

}  // namespace
}  // namespace seamount
