#include "seamount/ops/erosion/hardness.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::erosion {
namespace {

constexpr double kRockBodies_m = 2500.0;  // size of the largest bodies of harder and softer rock
constexpr float kBlack = 0.01F;           // of a picture; no rock is so soft

}  // namespace

void settle_hardness(ScalarField& hardness, const RunContext& run) {
  if (hardness.empty()) return;
  const auto [low, high] = std::minmax_element(hardness.cells().begin(), hardness.cells().end());
  if (*low < kBlack && *high <= 1.0F) {
    const float octaves = std::log(kHardestOfPicture);
    for (float& value : hardness.cells()) value = std::exp(octaves * std::max(value, 0.0F));
    run.say(
        "hardness: lies between 0 and 1 like a mask: 0 is taken for rock as `erodibility` says, 1 for rock 10 times as "
        "hard; values above 1 or no lower than 0.1 are taken as they are");
    return;
  }
  const auto soft =
      std::count_if(hardness.cells().begin(), hardness.cells().end(), [](float v) { return v < kSoftest; });
  if (soft == 0) return;
  for (float& value : hardness.cells()) value = std::max(value, kSoftest);
  run.say("hardness: " + std::to_string(soft) + " of " + std::to_string(hardness.size()) +
          " cells are below 0.1 times as hard as `erodibility` says and are taken for 0.1");
}

void vary_hardness(ScalarField& hardness, const GridFrame& frame, double variation, Seed seed, const RunContext& run) {
  if (variation <= 0) return;
  if (hardness.empty()) hardness = ScalarField(frame, 1.0F);
  const geom::Fbm shape{.wavelength_m = kRockBodies_m, .octaves = 8, .gain = 0.75, .cell_m = frame.cell_m};
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    std::vector<float> noise(static_cast<size_t>(frame.width));
    for (int y = begin; y < end; ++y) {
      geom::fbm_row(seed, shape, frame.x(0), frame.cell_m, frame.y(y), noise);
      const auto row = hardness.row(y);
      for (size_t i = 0; i < noise.size(); ++i) {
        const float by = static_cast<float>(variation) * std::clamp(1.5F * noise[i], -1.0F, 1.0F);
        row[i] *= (1.0F + by) / (1.0F - by);
      }
    }
  });
}

}  // namespace seamount::erosion
