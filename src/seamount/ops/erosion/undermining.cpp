#include "seamount/ops/erosion/undermining.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seamount::erosion {
namespace {

constexpr float kMinRise_m = 1e-3F;  // of a cell over its receiver; rubble would divide by less

}  // namespace

Undermining::Undermining(const Layers& ground, const Maps& site, const Drainage& drainage, double steepest,
                         double debris_ease)
    : ground_(ground),
      site_(site),
      drainage_(drainage),
      steepest_(static_cast<float>(steepest)),
      blocks_(static_cast<float>(1.0 / debris_ease)),
      ready_(site.beds == nullptr ? 0 : ground.surface.size(), 1.0F) {}

float Undermining::standing(int32_t cell, float base, float top) const {
  if (site_.beds == nullptr) return top;
  const auto index = static_cast<size_t>(cell);
  const float rise = steepest_ * drainage_.distance(cell) * std::sqrt(value_or_one(site_.hardness, index));
  return site_.beds->stand(index, base, std::numeric_limits<float>::infinity(), top, rise);
}

Undermining::Work Undermining::work(int32_t cell, float base, float stands, float top, float rate) {
  if (site_.beds == nullptr) return {};
  const auto index = static_cast<size_t>(cell);
  Work work;
  if (stands < top) {
    work.share = ready_[static_cast<size_t>(drainage_.receiver(cell))];
    const float bedrock = ground_.bedrock(index);
    if (bedrock > stands) work.rubble = site_.beds->rubble(index, stands, bedrock, blocks_);
  }
  const float hardness = value_or_one(site_.hardness, index) * site_.beds->hardness(index, stands);
  const float all = hardness + work.rubble / std::max(kMinRise_m, stands - base);
  ready_[index] = work.share * rate / (all + rate);
  return work;
}

}  // namespace seamount::erosion
