#include <benchmark/benchmark.h>

#include <cmath>

#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/classify/terrain.h"
#include "seamount/ops/terrain/blend.h"
#include "seamount/ops/terrain/layers.h"
#include "seamount/ops/terrain/mask.h"
#include "seamount/ops/terrain/sculpt.h"

namespace seamount {
namespace {

HeightField hills(int size) {
  HeightField terrain =
      geom::fbm_grid(GridFrame::centred(size, size, 10.0), Seed{3}, {.wavelength_m = 0.1 * 10.0 * size}, {});
  for (float& z : terrain.cells()) z = 500.0F * z - 50.0F;
  return terrain;
}

void mask_by(benchmark::State& state, const terrain::Criterion& criterion) {
  const HeightField terrain = hills(2048);
  for (auto _ : state) benchmark::DoNotOptimize(terrain::mask({terrain}, {.criteria = {criterion}}, Seed{1}, {}));
}
BENCHMARK_CAPTURE(mask_by, slope, terrain::BySlope{.low_deg = 20})
    ->Name("terrain/mask_slope/2048")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mask_by, curvature, terrain::ByCurvature{})
    ->Name("terrain/mask_curvature/2048")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mask_by, height, terrain::ByHeight{.low_m = 20})
    ->Name("terrain/mask_height/2048")
    ->Unit(benchmark::kMillisecond);

/// A thousand strokes of thirty points that wander over 256 x 256 cells of 40 m, six cells to either side.
terrain::SculptParams thousand_strokes(bool pressed, bool smooth) {
  Rng rng(Seed{8});
  terrain::SculptParams params;
  for (int i = 0; i < 1000; ++i) {
    Brush brush;
    brush.radius_m = 250.0;
    Vec2 at{rng.uniform(-4500, 4500), rng.uniform(-4500, 4500)};
    double way = rng.uniform(0.0, 6.28);
    for (int k = 0; k < 30; ++k) {
      brush.points.push_back(at);
      if (pressed) brush.pressure.push_back(0.5 + 0.5 * std::sin(0.3 * k));
      way += rng.uniform(-0.3, 0.3);
      at = at + 80.0 * Vec2{std::cos(way), std::sin(way)};
    }
    if (smooth)
      params.strokes.emplace_back(terrain::SmoothTool{brush, 0.5});
    else
      params.strokes.emplace_back(terrain::RaiseTool{brush, 30.0});
  }
  return params;
}

void sculpt(benchmark::State& state, bool pressed, bool smooth) {
  HeightField terrain = hills(256);
  terrain.set_frame(GridFrame::centred(256, 256, 40.0));
  const terrain::SculptParams params = thousand_strokes(pressed, smooth);
  for (auto _ : state) benchmark::DoNotOptimize(terrain::sculpt(terrain, nullptr, params, Seed{1}, {}));
}
BENCHMARK_CAPTURE(sculpt, raise, false, false)
    ->Name("terrain/sculpt_raise/1000")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(sculpt, pressure, true, false)
    ->Name("terrain/sculpt_pressure/1000")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(sculpt, smooth, false, true)
    ->Name("terrain/sculpt_smooth/1000")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void blend(benchmark::State& state) {
  const HeightField a = hills(2048), b = hills(2048);
  for (auto _ : state) benchmark::DoNotOptimize(terrain::blend(a, b, nullptr, {.mode = terrain::BlendMode::max}, {}));
}
BENCHMARK(blend)->Name("terrain/blend_max/2048")->Unit(benchmark::kMillisecond);

void layers(benchmark::State& state) {
  const HeightField terrain = hills(2048);
  for (auto _ : state) benchmark::DoNotOptimize(terrain::layers(terrain, {}, {}));
}
BENCHMARK(layers)->Name("terrain/layers/2048")->Unit(benchmark::kMillisecond);

void classify_terrain(benchmark::State& state) {
  const HeightField terrain = hills(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(classify::terrain(terrain, {}, {}));
}
BENCHMARK(classify_terrain)->Name("classify/terrain")->Arg(1024)->Arg(2048)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace seamount
