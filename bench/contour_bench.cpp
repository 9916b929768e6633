// Iso-contours: growth on networks of several sizes, one and six regions, sampling and triangulation, and all from
// outline to contours.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <numbers>

#include "seamount/geom/polygon/poisson_disc.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/tin/delaunay.h"
#include "seamount/ops/contour/convert/extract.h"
#include "seamount/ops/contour/growth/grow.h"
#include "seamount/ops/contour/growth/growth.h"
#include "seamount/ops/contour/growth/probability.h"
#include "seamount/ops/contour/heights/heights.h"

namespace {

using namespace seamount;

const GridFrame kFrame = GridFrame::centred(1024, 1024, 10);

Ring blob(Vec2 centre, double radius, double wobble) {
  Ring ring;
  for (int i = 0; i < 200; ++i) {
    const double a = 2 * std::numbers::pi * i / 200;
    const double r = radius * (1 + wobble * (std::sin(5 * a) + 0.6 * std::sin(11 * a + 1)));
    ring.push_back(centre + r * Vec2{std::cos(a), std::sin(a)});
  }
  return ring;
}

contour::RegionTree one_region() { return {{{"land", blob({0, 0}, 4600, 0.05), -1, {}, false}}}; }

/// A land, a high ground on it, two mountains with a peak each: each region but the peaks grows from two fronts.
contour::RegionTree six_regions() {
  return {{{"land", blob({0, 0}, 4900, 0.01), -1, {}, false},
           {"high ground", blob({0, 0}, 4100, 0.06), 0, {}, false},
           {"western mountain", blob({-1600, 0}, 1500, 0.1), 1, {}, false},
           {"eastern mountain", blob({1800, 600}, 1400, 0.1), 1, {}, false},
           {"western peak", blob({-1600, 0}, 700, 0.1), 2, {}, false},
           {"eastern peak", blob({1800, 600}, 500, 0.1), 3, {}, false}}};
}

contour::GrowParams particles(int count) {
  contour::GrowParams params;
  params.particles = count;
  return params;
}

/// A network and what its growth starts from, made once.
struct Network {
  Tin tin;
  std::vector<float> probability;
};

const Network& network(bool six, int count) {
  static std::map<std::pair<bool, int>, Network> made;
  Network& net = made[{six, count}];
  if (net.tin.nodes.empty()) {
    net.tin = contour::grow(six ? six_regions() : one_region(), kFrame, nullptr, {}, particles(count), Seed{1}, {});
    geom::Fbm shape;
    shape.wavelength_m = 2700;
    shape.octaves = 5;
    net.probability = contour::noise_probability(net.tin.nodes, shape, 2.0, Seed{2}, {});
  }
  return net;
}

void growth(benchmark::State& state, bool six, int count) {
  const Network& net = network(six, count);
  uint64_t seed = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        contour::grow_ranks(net.tin.triangles, net.tin.region, net.tin.regions, net.probability, {}, Seed{seed++}, {}));
  }
  state.SetItemsProcessed(state.iterations() * count);
}

void growth_scaling(benchmark::State& state) {
  growth(state, false, static_cast<int>(state.range(0)));
  state.SetComplexityN(state.range(0));
}

/// A land of that many particles from its outline to thirty contours.
void pipeline(benchmark::State& state, int count) {
  const contour::RegionTree land = one_region();
  contour::ExtractParams thirty;
  thirty.count = 30;
  uint64_t seed = 0;
  size_t points = 0;
  for (auto _ : state) {
    Tin tin = contour::grow(land, kFrame, nullptr, {}, particles(count), Seed{seed++}, {});
    tin = contour::heights(std::move(tin), nullptr, {}, {});
    const ContourSet set = contour::extract(tin, thirty, {});
    points = 0;
    for (const Contour& contour : set.contours) points += contour.ring.size();
  }
  state.counters["points"] = static_cast<double>(points);
  state.SetItemsProcessed(state.iterations() * count);
}

void poisson_discs(benchmark::State& state) {
  const auto count = static_cast<double>(state.range(0));
  const double spacing = std::sqrt(geom::kDiscDensity / count) * 10000;
  const Ring square = {{-1, -1}, {10001, -1}, {10001, 10001}, {-1, 10001}};
  uint64_t seed = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        geom::poisson_discs({{square, {}}}, 0.0, {{0, 0}, {10000, 10000}}, spacing, Seed{seed++}, {}));
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void delaunay(benchmark::State& state) {
  const std::vector<Vec2>& nodes = network(false, static_cast<int>(state.range(0))).tin.nodes;
  for (auto _ : state) benchmark::DoNotOptimize(geom::delaunay(nodes, {}));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK_CAPTURE(growth, one, false, 10000)->Name("contour/growth/10k")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(growth, one, false, 100000)
    ->Name("contour/growth/100k")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(growth, one, false, 500000)
    ->Name("contour/growth/500k")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(growth, six, true, 50000)
    ->Name("contour/growth_regions/50k")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(pipeline, one, 500000)->Name("contour/pipeline/500k")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(growth_scaling)
    ->Name("contour/growth_scaling")
    ->RangeMultiplier(2)
    ->Range(1 << 14, 1 << 21)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN)
    ->UseRealTime();
BENCHMARK(poisson_discs)->Name("geom/poisson_discs")->Arg(500000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(delaunay)->Name("geom/delaunay")->Arg(500000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
