#include "seamount/ops/erosion/fans.h"

#include <algorithm>

#include "seamount/ops/erosion/slides.h"

namespace seamount::erosion {
namespace {

constexpr double kFan_deg = 0.5;  // what stands over the ground beside it by more runs off
constexpr int kRounds = 8;        // and so many cells far
constexpr double kSpeed = 0.5;

}  // namespace

void spread_deposits(Layers& ground, ScalarField& fresh, const Maps& site, ScalarField& share, ScalarField& next,
                     const RunContext& run) {
  for (size_t i = 0; i < fresh.size(); ++i) {
    float& all = ground.sediment.data()[i];
    fresh.data()[i] = std::min(fresh.data()[i], all);
    all -= fresh.data()[i];
  }
  for (int k = 0; k < kRounds; ++k)
    slide(ground.surface, fresh, Sliding::layer, site, kFan_deg, kSpeed, share, next, run);
  for (size_t i = 0; i < fresh.size(); ++i) ground.sediment.data()[i] += fresh.data()[i];
}

}  // namespace seamount::erosion
