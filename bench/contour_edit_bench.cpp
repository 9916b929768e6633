// Editing contours: a stroke over a tenth of half a million vertices, and the tools that work on everything.
#include <benchmark/benchmark.h>

#include "seamount/ops/contour/edit/edit.h"
#include "seamount/ops/contour/move/test_contours.h"

namespace {

using namespace seamount;

/// About 500 000 vertices in 80 levels, made once and before anything is timed.
const ContourSet& half_a_million() {
  static const ContourSet set = contour::noise_contours(1, 1700, 16.0);
  return set;
}

size_t vertices(const ContourSet& set) {
  size_t count = 0;
  for (const Contour& contour : set.contours) count += contour.ring.size();
  return count;
}

void edits(benchmark::State& state, const std::vector<contour::Edit>& list) {
  const ContourSet& set = half_a_million();
  const contour::EditParams params{list, contour::OnCrossing::limit};
  for (auto _ : state) benchmark::DoNotOptimize(contour::edit(set, params, {}, Seed{1}, {}));
  state.counters["vertices"] = static_cast<double>(vertices(set));
}

const contour::WarpTool kWarp{.stroke = {{-4000, -1500}, {-500, 700}, {3500, -600}}, .radius_m = 1400};
const contour::SlopeTool kSlope{.stroke = {{-4000, -1500}, {-500, 700}, {3500, -600}}, .radius_m = 1400};

BENCHMARK_CAPTURE(edits, warp, {kWarp})->Name("contour/warp/500k")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(edits, slope, {kSlope})->Name("contour/slope/500k")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(edits, smooth, {contour::SmoothTool{.radius_m = 30}})
    ->Name("contour/smooth/500k")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(edits, fractalize, {contour::FractalizeTool{.amplitude_m = 30, .octaves = 4}})
    ->Name("contour/fractalize/500k")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
