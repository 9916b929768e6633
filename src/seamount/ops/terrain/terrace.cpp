#include "seamount/ops/terrain/terrace.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/model/same_size.h"

namespace seamount::terrain {
namespace {

/// Steps whose borders lie near multiples of the mean thickness, each moved by its own share of it.
class Steps {
 public:
  Steps(const TerraceParams& params, Seed seed) : params_(params), seed_(seed) {}

  /// A height on the slope as a height on the steps.
  double operator()(double height) const {
    auto step = static_cast<int64_t>(std::floor(height / params_.step_m));
    if (height < border(step)) --step;
    if (height >= border(step + 1)) ++step;
    const double low = border(step), high = border(step + 1);
    const double place = (height - low) / (high - low);
    // The riser stands in the upper part of the step, so that the tread begins at its border.
    const double riser = geom::smoothstep(std::clamp((place - (1.0 - params_.riser)) / params_.riser, 0.0, 1.0));
    return low + (high - low) * (place + params_.flatness * (riser - place));
  }

 private:
  double border(int64_t step) const {
    constexpr double kMost = 0.45;  // of the thickness: borders stay in order
    return params_.step_m *
           (static_cast<double>(step) +
            kMost * params_.variation *
                Rng(seed_.derive("terrain.terrace.step", static_cast<uint64_t>(step))).uniform(-1.0, 1.0));
  }

  const TerraceParams& params_;
  Seed seed_;
};

}  // namespace

HeightField terrace(const HeightField& terrain, const ScalarField* mask, const TerraceParams& params, Seed seed,
                    const RunContext& run) {
  check_params(params);
  if (mask != nullptr) check_same_size("mask", mask->frame(), terrain.frame());
  const Steps steps(params, seed);
  const ScalarField wander =
      geom::fbm_grid(terrain.frame(), seed.derive("terrain.terrace.wander"),
                     {.wavelength_m = params.wander_wavelength_m, .octaves = 4, .gain = 0.5}, run.part(0.0, 0.4));
  HeightField out(terrain.frame());
  parallel_rows(run.part(0.4, 1.0), terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < terrain.width(); ++x) {
        const double off = params.wander_m * static_cast<double>(wander(x, y));
        const double made = steps(static_cast<double>(terrain(x, y)) - off) + off;
        const double share = mask == nullptr ? 1.0 : std::clamp(static_cast<double>((*mask)(x, y)), 0.0, 1.0);
        out(x, y) = static_cast<float>(static_cast<double>(terrain(x, y)) +
                                       share * (made - static_cast<double>(terrain(x, y))));
      }
    }
  });
  return out;
}

}  // namespace seamount::terrain
