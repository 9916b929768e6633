#include "seamount/ops/render/lava.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/render/colour.h"
#include "seamount/ops/render/light.h"

namespace seamount::render {
namespace {

constexpr int kMostCells = 1024;

/// The terrain with a little roughness of its own, so that streams do not run along the eight directions of the grid.
HeightField roughened(HeightField terrain, const RunContext& run) {
  const auto [low, high] = std::minmax_element(terrain.cells().begin(), terrain.cells().end());
  const float amplitude = 0.012F * (*high - *low);
  const double cell = terrain.cell_m();
  const ScalarField noise = geom::fbm_grid(terrain.frame(), Seed{}.derive("render.lava"),
                                           {.wavelength_m = 24.0 * cell, .octaves = 4, .gain = 0.6}, run);
  run.check_cancelled();
  for (size_t i = 0; i < terrain.size(); ++i) terrain.cells()[i] += amplitude * noise.cells()[i];
  return terrain;
}

}  // namespace

Mask lava_streams(const HeightField& terrain, const Mask& vents, const geom::Borders& borders, const RunContext& run) {
  const HeightField ground = roughened(reduce(terrain, kMostCells, run), run);
  ScalarField source = reduce(vents, kMostCells, run);
  double total = 0.0;
  // A volcano does not break out on all sides at once.
  const GridFrame& frame = ground.frame();
  const ScalarField side =
      geom::fbm_grid(frame, Seed{}.derive("render.lava.side"),
                     {.wavelength_m = 0.22 * std::max(frame.width_m(), frame.height_m()), .octaves = 2}, run);
  for (size_t i = 0; i < source.size(); ++i) {
    if (i % 65536 == 0) run.check_cancelled();
    float& s = source.cells()[i];
    s = ground.cells()[i] > 0.0F ? s * s * ramp(-0.15F, 0.15F, side.cells()[i]) : 0.0F;
    total += s;
  }
  if (total < 1.0) return Mask(terrain.frame(), 0.0F);
  const bool sea = std::any_of(ground.cells().begin(), ground.cells().end(), [](float z) { return z < 0.0F; });
  const float level = sea ? 0.0F : geom::kNoSea;
  const HeightField filled = geom::fill_depressions(ground, level, run);
  const ScalarField flow = geom::flow_accumulation(geom::flow_directions(filled, level, run), source, run);
  const auto warm_m = static_cast<float>(borders.low_m);
  const auto cold_m = static_cast<float>(2.0 * borders.low_m - borders.high_m) - 1e-3F;
  // Where many valleys share the lava, the largest streams are lava still: measured by the largest of them.
  const auto most = std::log(static_cast<float>(*std::max_element(flow.cells().begin(), flow.cells().end()) / total));
  Mask thin(flow.frame()), wide(flow.frame());
  for (size_t i = 0; i < flow.size(); ++i) {
    if (i % 65536 == 0) run.check_cancelled();
    const float share = std::log(static_cast<float>(flow.cells()[i] / total) + 1e-9F);
    // From 0.5 % of all lava to 5 %, or from a tenth to a half of the largest stream.
    const float stream = ramp(std::min(-5.2F, most - 2.3F), std::min(-2.9F, most - 0.7F), share);
    const float hot = ramp(cold_m, warm_m, ground.cells()[i]);
    thin.cells()[i] = stream * hot;
    wide.cells()[i] = stream * hot * ramp(std::min(-3.4F, most - 1.3F), std::min(-1.6F, most), share);
  }
  geom::gaussian_blur(thin, 0.8 * flow.cell_m(), run);
  geom::gaussian_blur(wide, 1.7 * flow.cell_m(), run);
  run.check_cancelled();
  for (size_t i = 0; i < thin.size(); ++i) thin.cells()[i] = 1.5F * thin.cells()[i] + 3.0F * wide.cells()[i];
  Mask out = thin.frame() == terrain.frame() ? std::move(thin) : geom::resample(thin, terrain.frame(), run);
  for (float& w : out.cells()) w = clamp01(w);
  return out;
}

}  // namespace seamount::render
