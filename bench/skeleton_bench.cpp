// Speed of the geometry of environmental objects: asking for the nearest, shapes of the ground, fitting.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/skeleton/height_proxy.h"
#include "seamount/geom/skeleton/region_snake.h"
#include "seamount/geom/skeleton/skeleton_index.h"
#include "seamount/geom/skeleton/snake.h"

namespace {

using namespace seamount;

constexpr double kSide = 5120.0;

std::vector<Skeleton> points(int64_t count) {
  Rng rng(Seed{5});
  std::vector<Skeleton> skeletons;
  for (int64_t i = 0; i < count; ++i) {
    skeletons.push_back({SkeletonKind::point, {{rng.uniform(0.0, kSide), rng.uniform(0.0, kSide)}}});
  }
  return skeletons;
}

std::vector<int32_t> owners(size_t count) {
  std::vector<int32_t> numbers(count);
  for (size_t i = 0; i < count; ++i) numbers[i] = static_cast<int32_t>(i);
  return numbers;
}

void index(benchmark::State& state) {
  const std::vector<Skeleton> skeletons = points(state.range(0));
  const std::vector<int32_t> numbers = owners(skeletons.size());
  for (auto _ : state) benchmark::DoNotOptimize(geom::SkeletonIndex(skeletons, numbers));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(index)
    ->Name("geom/skeleton_index")
    ->RangeMultiplier(10)
    ->Range(1000, 100000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity();

void nearest(benchmark::State& state) {
  const std::vector<Skeleton> skeletons = points(state.range(0));
  const geom::SkeletonIndex index(skeletons, owners(skeletons.size()));
  const GridFrame frame = {512, 512, kSide / 512.0, 0.0, kSide, {}};
  std::vector<Vec2> places;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) places.push_back({frame.x(x), frame.y(y)});
  }
  std::vector<double> distances(places.size());
  for (auto _ : state) {
    index.distances(places, {}, distances, {});
    benchmark::ClobberMemory();
  }
}
BENCHMARK(nearest)->Name("geom/skeleton_distances/512")->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

void proxies(benchmark::State& state) {
  const std::vector<Skeleton> skeletons = points(state.range(0));
  const std::vector<HeightEffect> effects(
      skeletons.size(), {HeightShape::dome, static_cast<HeightGroup>(state.range(1)), 2.0, 60.0, 2.0});
  const HeightField ground({512, 512, kSide / 512.0, 0.0, kSide, {}}, -30.0F);
  for (auto _ : state) {
    const geom::HeightProxies shapes(skeletons, effects, {.deepest_m = -30.0});
    benchmark::DoNotOptimize(shapes.over(ground, {}));
  }
}
BENCHMARK(proxies)
    ->Name("geom/height_proxies/512")
    ->ArgsProduct({{1000, 10000, 100000}, {0, 1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void belts(std::span<const Vec2> places, std::span<double> values) {
  for (size_t i = 0; i < places.size(); ++i) {
    const double x = places[i].x / 300.0, y = places[i].y / 350.0;
    const double off = std::sin(x) + std::cos(y) + 0.5 * std::sin(0.6 * x - 0.8 * y);
    values[i] = 1.0 / (1.0 + 9.0 * off * off);
  }
}

void snakes(benchmark::State& state) {
  std::vector<geom::SnakeSeed> seeds;
  for (const Skeleton& point : points(state.range(0))) seeds.push_back({point.points[0], 1000.0});
  for (auto _ : state) benchmark::DoNotOptimize(geom::grow_snakes(seeds, {}, belts, {}));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(snakes)->Name("geom/snakes")->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond)->UseRealTime();

void regions(benchmark::State& state) {
  std::vector<geom::RegionSeed> seeds;
  for (const Skeleton& point : points(state.range(0))) seeds.push_back({point.points[0], 200000.0});
  for (auto _ : state) benchmark::DoNotOptimize(geom::grow_regions(seeds, {}, belts, {}));
}
BENCHMARK(regions)->Name("geom/regions")->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
