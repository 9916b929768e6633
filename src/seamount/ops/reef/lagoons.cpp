#include "seamount/ops/reef/lagoons.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/reef/blob.h"
#include "seamount/ops/reef/regions.h"

namespace seamount::reef {
namespace {

constexpr double kSmallest_m = 15.0, kLargest_m = 160.0;  // radii of knolls
constexpr double kBackReef_m = 80.0;                      // width of the slope to a lagoon's floor
constexpr float kNone = -1e6F;

/// Radius with a density that falls with its third power: four times fewer of twice the size.
double knoll_radius(Rng& rng) {
  const double low = 1.0 / (kSmallest_m * kSmallest_m), high = 1.0 / (kLargest_m * kLargest_m);
  return 1.0 / std::sqrt(low + (high - low) * rng.uniform());
}

}  // namespace

ScalarField lagoon_depths(const ScalarField& distance, const ScalarField& exposure, double flat_width_m,
                          double least_m2, Seed seed, const RunContext& run) {
  const GridFrame& frame = distance.frame();
  const geom::Fbm noise{.wavelength_m = 2.0 * flat_width_m, .octaves = 5, .cell_m = frame.cell_m};
  Grid<uint8_t> in(frame), floor(frame), out(frame);
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> uneven(static_cast<size_t>(frame.width));
    for (int y = begin; y < end; ++y) {
      geom::fbm_row(seed.derive("reef.flat_width"), noise, frame.x(0), frame.cell_m, frame.y(y), uneven);
      for (int x = 0; x < frame.width; ++x) {
        const double windward = geom::smoothstep(0.5 + 0.8 * static_cast<double>(exposure(x, y)));
        const double width =
            flat_width_m * (0.5 + 0.5 * windward) * (1.0 + 1.1 * static_cast<double>(uneven[static_cast<size_t>(x)]));
        const double behind = static_cast<double>(distance(x, y)) - width;
        in(x, y) = behind > 0 ? 1 : 0;
        floor(x, y) = behind > kBackReef_m ? 1 : 0;
      }
    }
  });
  const double cell_m2 = frame.cell_m * frame.cell_m;
  for (const RegionOfMask& region : regions_of(in)) {
    double floor_m2 = 0;
    for (const int64_t i : region.cells) floor_m2 += floor.cells()[static_cast<size_t>(i)] * cell_m2;
    if (floor_m2 >= least_m2) continue;
    for (const int64_t i : region.cells) in.cells()[static_cast<size_t>(i)] = 0;
  }
  int64_t cells = 0;
  for (size_t i = 0; i < in.size(); ++i) cells += in.cells()[i], out.cells()[i] = 1 - in.cells()[i];
  if (cells == 0) return ScalarField(frame, kNone);
  ScalarField depth = geom::distance_to(out, run);
  const ScalarField before = geom::distance_to(in, run);
  for (size_t i = 0; i < depth.size(); ++i)
    depth.cells()[i] = std::clamp(depth.cells()[i] - before.cells()[i], kNone, -kNone);
  geom::gaussian_blur(depth, 1.2 * frame.cell_m, run);
  return depth;
}

ScalarField scatter_knolls(const ScalarField& distance, const ScalarField& lagoon, const ScalarField& crowding,
                           double per_km2, Seed seed) {
  const GridFrame& frame = distance.frame();
  const double area_km2 = frame.width_m() * frame.height_m() * 1e-6, least_m = 1.3 * frame.cell_m;
  if (per_km2 <= 0 || least_m > kLargest_m) return {};
  ScalarField knolls(frame, 0.0F);
  bool any = false;
  const auto count = static_cast<int64_t>(std::min(2e6, per_km2 * area_km2));
  for (int64_t i = 0; i < count; ++i) {
    Rng rng(seed.derive("reef.knoll", static_cast<uint64_t>(i)));
    const double radius = knoll_radius(rng);
    const Vec2 c{frame.west_m + frame.width_m() * rng.uniform(), frame.north_m - frame.height_m() * rng.uniform()};
    if (radius < least_m) continue;
    const int x = std::clamp(static_cast<int>(std::lround(frame.column(c.x))), 0, frame.width - 1);
    const int y = std::clamp(static_cast<int>(std::lround(frame.row(c.y))), 0, frame.height - 1);
    const auto clear = static_cast<float>(radius + 60.0);
    if (lagoon(x, y) < clear && (distance(x, y) > -clear || crowding(x, y) < 0.45F)) continue;
    const Blob blob(c, radius, 1.0, 0.0, rng);
    // The larger, the higher: growth of thousands of years took them to the surface.
    const double top = std::clamp(0.25 + 0.35 * std::log2(radius / kSmallest_m) * rng.uniform(0.4, 1.0), 0.25, 0.95);
    blob.for_each_cell(frame, [&](int bx, int by, double inside_m) {
      float& k = knolls(bx, by);
      k = std::max(k, static_cast<float>(top * geom::smoothstep(inside_m / (0.25 * radius + frame.cell_m))));
      any = true;
    });
  }
  return any ? knolls : ScalarField();
}

}  // namespace seamount::reef
