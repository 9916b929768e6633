// Contours out of networks and terrains, and terrains out of contours.
#include <benchmark/benchmark.h>

#include <cmath>

#include "seamount/geom/contour/contour.h"
#include "seamount/geom/contour/marching_triangles.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/tin/test_tin.h"
#include "seamount/ops/contour/convert/extract.h"
#include "seamount/ops/contour/convert/reconstruct.h"
#include "seamount/ops/terrain/noise.h"

namespace {

using namespace seamount;

HeightField mountains(int size) {
  terrain::NoiseParams params;
  params.kind = terrain::NoiseKind::smooth;
  return terrain::noise(params, GridFrame::centred(size, size, 10240.0 / size), Seed{7}, {});
}

std::vector<double> thirty_levels(std::vector<float> heights) {
  std::sort(heights.begin(), heights.end());
  std::vector<double> levels;
  for (size_t i = 0; i < 30; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / 30.0;
    levels.push_back(heights.front() + share * (static_cast<double>(heights.back()) - heights.front()));
  }
  return levels;
}

/// A network of as many nodes over a noise terrain, whose contours are as ragged as grown ones.
Tin mountain_tin(int side) {
  const HeightField field = mountains(1024);
  return geom::lattice_tin(side, side, 10000.0 / side, Seed{1}, [&](Vec2 p) {
    return field.clamped(static_cast<int>(field.frame().column(p.x)), static_cast<int>(field.frame().row(p.y)));
  });
}

void extract_from_tin(benchmark::State& state, int side) {
  const Tin tin = mountain_tin(side);
  const std::vector<double> levels = thirty_levels(tin.height_m);
  size_t points = 0;
  for (auto _ : state) {
    std::vector<Contour> contours = geom::march_triangles(tin, levels, {});
    points = 0;
    for (const Contour& contour : contours) points += contour.ring.size();
    benchmark::DoNotOptimize(contours);
  }
  state.counters["points"] = static_cast<double>(points);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(tin.nodes.size()));
}

void nest(benchmark::State& state, int side) {
  const Tin tin = mountain_tin(side);
  const std::vector<Contour> contours = geom::march_triangles(tin, thirty_levels(tin.height_m), {});
  for (auto _ : state) {
    std::vector<Contour> nested = contours;
    geom::nest_contours(nested);
    benchmark::DoNotOptimize(nested);
  }
  state.counters["rings"] = static_cast<double>(contours.size());
}

void extract_from_raster(benchmark::State& state, int size) {
  const HeightField field = mountains(size);
  const std::vector<double> levels = thirty_levels({field.cells().begin(), field.cells().end()});
  for (auto _ : state) benchmark::DoNotOptimize(geom::trace_contours(field, levels));
  state.SetItemsProcessed(state.iterations() * field.frame().cells());
}

/// The contours of a network of 10 000 nodes: 30 levels, about 26 000 points.
void reconstruct(benchmark::State& state, contour::Method method) {
  ContourSet set = contour::extract(mountain_tin(100), {.count = 30}, {});
  set.frame = GridFrame::centred(1024, 1024, 10000.0 / 1024);
  size_t points = 0;
  for (const Contour& contour : set.contours) points += contour.ring.size();
  for (auto _ : state) benchmark::DoNotOptimize(contour::reconstruct(set, {.method = method}, {}));
  state.counters["points"] = static_cast<double>(points);
  state.SetItemsProcessed(state.iterations() * set.frame.cells());
}

BENCHMARK_CAPTURE(extract_from_tin, tin, 223)
    ->Name("contour/extract30/50k")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(extract_from_tin, tin, 708)
    ->Name("contour/extract30/500k")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(nest, tin, 708)->Name("contour/nest30/500k")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(extract_from_raster, raster, 1024)
    ->Name("contour/extract30_raster/1024")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

BENCHMARK_CAPTURE(reconstruct, interpolated, contour::Method::interpolated)
    ->Name("contour/reconstruct/1024")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(reconstruct, smooth, contour::Method::smooth)
    ->Name("contour/reconstruct_smooth/1024")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
