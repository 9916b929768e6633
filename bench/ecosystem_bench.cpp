// The continuous environment of P3: materials to their steady state, and currents.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/geom/current/diverted_current.h"
#include "seamount/geom/current/kelvinlet_sum.h"
#include "seamount/geom/solve/transport.h"

namespace {

using namespace seamount;

constexpr double kCell_m = 10.0;

/// An island in a sea of knolls.
HeightField sea(const GridFrame& frame) {
  HeightField height(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const double e = frame.x(x), n = frame.y(y), r = std::hypot(e, n) / (0.12 * frame.width_m());
      height(x, y) = static_cast<float>(-60.0 + 90.0 * std::exp(-0.5 * r * r) +
                                        6.0 * std::sin(e / 170.0) * std::cos(n / 130.0 + e / 400.0));
    }
  }
  return height;
}

std::vector<geom::Kelvinlet> objects(int count, const GridFrame& frame) {
  Rng rng(Seed{3}.derive("bench.objects"));
  std::vector<geom::Kelvinlet> all;
  for (int i = 0; i < count; ++i) {
    geom::Kelvinlet k;
    k.kind = static_cast<geom::KelvinletKind>(i % 3);
    k.centre = {rng.uniform(frame.west_m, frame.east_m()), rng.uniform(frame.south_m(), frame.north_m)};
    k.radius_m = rng.uniform(8.0, 30.0);
    k.speed_m_s = {rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)};
    all.push_back(k);
  }
  return all;
}

VectorField current_of(const HeightField& height, const std::vector<geom::Kelvinlet>& kelvinlets) {
  geom::DiversionOptions options;
  options.base_m_s = {0.4, 0.15};
  options.shallows_m = 3.0;
  VectorField current = geom::diverted_current(height, options, {});
  geom::add_kelvinlets(kelvinlets, current, {});
  return current;
}

/// Deposits of many objects, and absorption by others where `absorbing`.
ScalarField deposits(const GridFrame& frame, bool absorbing) {
  ScalarField source(frame, 0.0F);
  Rng rng(Seed{4}.derive("bench.deposits"));
  for (int i = 0; i < frame.width; ++i) {
    const int x = static_cast<int>(rng.uniform(0.0, frame.width)), y = static_cast<int>(rng.uniform(0.0, frame.height));
    const auto rate = static_cast<float>(rng.uniform(absorbing ? -1.0 : 0.1, 1.0));
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx)
        if (source.contains(x + dx, y + dy))
          source(x + dx, y + dy) += rate * std::exp(-0.25F * static_cast<float>(dx * dx + dy * dy));
  }
  return source;
}

/// One material in the current around an island and 1000 objects, on one thread.
void steady(benchmark::State& state, int cells, bool absorbing) {
  const GridFrame frame = GridFrame::centred(cells, cells, kCell_m);
  const VectorField current = current_of(sea(frame), objects(1000, frame));
  const ScalarField source = deposits(frame, absorbing);
  const geom::Transport transport{&source, &current, nullptr, 1.0, 0.002};
  RunContext run;
  run.threads = 1;
  for (auto _ : state) benchmark::DoNotOptimize(geom::steady_state(transport, run));
  state.SetItemsProcessed(state.iterations() * frame.cells());
}

/// Six materials on all processors, as a step of an ecosystem asks for.
void steady_six(benchmark::State& state) {
  const GridFrame frame = GridFrame::centred(512, 512, kCell_m);
  const VectorField current = current_of(sea(frame), objects(1000, frame));
  const ScalarField source = deposits(frame, false), absorbed = deposits(frame, true);
  const std::vector<geom::Transport> transports = {
      {&source, &current, nullptr, 1.0, 0.002}, {&source, nullptr, nullptr, 5.0, 0.001},
      {&source, &current, nullptr, 0.1, 0.005}, {&source, nullptr, nullptr, 0.5, 0.01},
      {&source, &current, nullptr, 3.0, 0.001}, {&absorbed, &current, nullptr, 1.0, 0.002}};
  for (auto _ : state) benchmark::DoNotOptimize(geom::steady_states(transports, {}));
}

void currents(benchmark::State& state, int count, int cells) {
  const GridFrame frame = GridFrame::centred(cells, cells, kCell_m);
  const HeightField height = sea(frame);
  const std::vector<geom::Kelvinlet> kelvinlets = objects(count, frame);
  for (auto _ : state) benchmark::DoNotOptimize(current_of(height, kelvinlets));
  state.SetItemsProcessed(state.iterations() * count);
}

BENCHMARK_CAPTURE(steady, 256, 256, false)->Name("ecosystem/steady/256")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(steady, 512, 512, false)->Name("ecosystem/steady/512")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(steady, 1024, 1024, false)
    ->Name("ecosystem/steady/1024")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(steady, absorbing, 512, true)
    ->Name("ecosystem/steady_absorbing/512")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(steady_six)->Name("ecosystem/steady_six/512")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(currents, 1k, 1000, 512)
    ->Name("ecosystem/currents/512/1k")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(currents, 10k, 10000, 512)
    ->Name("ecosystem/currents/512")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(currents, 100k, 100000, 512)
    ->Name("ecosystem/currents/512/100k")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
