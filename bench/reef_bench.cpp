// Reefs: P4's settings (fig. 4: grid 150, 3000 particles, kernels of 40 px on 4096) at three sizes, and the defaults.
#include <benchmark/benchmark.h>

#include "seamount/ops/reef/grow.h"

namespace {

using namespace seamount;

constexpr double kWidth_m = 10000;

reef::GrowParams paper_settings() {
  reef::GrowParams params;
  params.lattice_m = kWidth_m / 150;
  params.particles = 3000;
  params.walk.max_steps = 30000;
  params.bounds.margin_m = 0;
  params.starts.points = {{3000, -3000}};
  params.kernel.combine = reef::Combine::sum;
  params.heights.mode = reef::Lift::proportional;
  params.irregularity = 0;
  params.heights.w0 = 0.5;
  params.heights.w1 = 0.2;
  params.heights.w2 = 0.1;
  params.kernel.k2 = 10;
  return params;
}

void grow(benchmark::State& state, const reef::GrowParams& params, int size) {
  const GridFrame frame = GridFrame::centred(size, size, kWidth_m / size);
  HeightField base(frame);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) base(x, y) = static_cast<float>(-40.0 + 1e-3 * frame.x(x));
  }
  uint64_t seed = 0;
  for (auto _ : state) benchmark::DoNotOptimize(reef::grow({base}, params, Seed{seed++}, {}));
  state.SetItemsProcessed(state.iterations() * frame.cells());
}

BENCHMARK_CAPTURE(grow, paper, paper_settings(), 4096)
    ->Name("reef/grow/4096")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(grow, paper, paper_settings(), 8192)
    ->Name("reef/grow/8192")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(grow, paper, paper_settings(), 16384)
    ->Name("reef/grow/16384")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(grow, natural, reef::GrowParams{}, 4096)
    ->Name("reef/grow_natural/4096")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
