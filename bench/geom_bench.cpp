// Speed of geom: noise, distances, gullies and the solvers, at the sizes that docs/ promises.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "seamount/geom/contour/contour.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/mesh/terrain_mesh.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/solve/poisson.h"
#include "seamount/geom/water/gullies.h"

namespace {

using namespace seamount;

void noise(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const GridFrame frame = GridFrame::centred(size, size, 10.0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(geom::fbm_grid(frame, Seed{7}, {.wavelength_m = 8000.0, .octaves = 8}, {}));
  }
}
BENCHMARK(noise)->Name("terrain/noise")->Arg(512)->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime();

Grid<uint8_t> blobs(int size) {
  const GridFrame frame = GridFrame::centred(size, size, 10.0);
  const ScalarField noise = geom::fbm_grid(frame, Seed{3}, {.wavelength_m = 2000.0, .octaves = 6}, {});
  Grid<uint8_t> inside(frame);
  for (size_t i = 0; i < inside.size(); ++i) inside.cells()[i] = noise.cells()[i] > 0.3F ? 1 : 0;
  return inside;
}

void distance(benchmark::State& state) {
  const Grid<uint8_t> inside = blobs(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(geom::distance_to(inside, {}));
}
BENCHMARK(distance)->Name("geom/distance")->Arg(512)->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime();

Polygon wavy_disc(double radius_m, int points) {
  Polygon disc;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / points;
    const double r = radius_m * (1.0 + 0.3 * geom::fbm_circle(Seed{5}, angle, 6.0, 5));
    disc.outer.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return disc;
}

void mesh(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  HeightField heights(GridFrame::centred(size, size, 10.0));
  const ScalarField noise = geom::fbm_grid(heights.frame(), Seed{7}, {.wavelength_m = 8000.0, .octaves = 8}, {});
  for (size_t i = 0; i < heights.size(); ++i) heights.cells()[i] = 1000.0F * noise.cells()[i];
  for (auto _ : state) benchmark::DoNotOptimize(geom::make_mesh(heights, {.max_triangles = 400000}, {}));
}
BENCHMARK(mesh)->Name("geom/mesh")->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime();

void signed_distance(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const std::vector<Polygon> island = {wavy_disc(3.0 * size, 400)};
  const GridFrame frame = GridFrame::centred(size, size, 10.0);
  for (auto _ : state) benchmark::DoNotOptimize(geom::signed_distance(island, frame, {}));
}
BENCHMARK(signed_distance)
    ->Name("geom/signed_distance")
    ->Arg(256)
    ->Arg(1024)
    ->Arg(4096)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void gullies(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const GridFrame frame = GridFrame::centred(size, size, 40960.0 / size);
  HeightField cone(frame);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      cone(x, y) = static_cast<float>(2000.0 - 0.12 * std::hypot(frame.x(x), frame.y(y)));
    }
  }
  const ScalarField strength(frame, 1.0F);
  for (auto _ : state) {
    HeightField height = cone;
    geom::add_gullies(height, Seed{7}, {.wavelength_m = 2400.0, .octaves = 8}, strength, {});
    benchmark::DoNotOptimize(height);
  }
}
BENCHMARK(gullies)->Name("geom/gullies")->Arg(512)->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime();

void laplace(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const Grid<uint8_t> fixed = blobs(size);
  ScalarField start(fixed.frame());
  for (size_t i = 0; i < start.size(); ++i) start.cells()[i] = static_cast<float>(i % 977);
  for (auto _ : state) {
    ScalarField u = start;
    geom::solve_laplace(u, fixed, {});
    benchmark::DoNotOptimize(u);
  }
}
BENCHMARK(laplace)->Name("geom/laplace")->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

void blur(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  ScalarField field(GridFrame::centred(size, size, 1.0), 1.0F);
  for (auto _ : state) geom::gaussian_blur(field, 20.0, {});
}
BENCHMARK(blur)->Name("geom/gaussian_blur")->Arg(4096)->Unit(benchmark::kMillisecond)->UseRealTime();

void contours(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const GridFrame frame = GridFrame::centred(size, size, 10.0);
  const ScalarField noise = geom::fbm_grid(frame, Seed{3}, {.wavelength_m = 2000.0, .octaves = 4}, {});
  for (auto _ : state) benchmark::DoNotOptimize(geom::trace_areas(noise, 0.1));
}
BENCHMARK(contours)->Name("geom/trace_areas")->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
