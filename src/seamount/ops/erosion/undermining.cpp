#include "seamount/ops/erosion/undermining.h"

#include <cmath>
#include <limits>

namespace seamount::erosion {

Undermining::Undermining(const Maps& site, const Drainage& drainage, double steepest)
    : site_(site),
      drainage_(drainage),
      steepest_(static_cast<float>(steepest)),
      ready_(site.beds == nullptr ? 0 : drainage.order().size(), 1.0F) {}

float Undermining::standing(int32_t cell, float base, float top) const {
  if (site_.beds == nullptr) return top;
  const auto index = static_cast<size_t>(cell);
  const float rise = steepest_ * drainage_.distance(cell) * std::sqrt(value_or_one(site_.hardness, index));
  return site_.beds->stand(index, base, std::numeric_limits<float>::infinity(), top, rise);
}

float Undermining::time_left(int32_t cell, float stands, float top, float rate) {
  if (site_.beds == nullptr) return 1.0F;
  const auto index = static_cast<size_t>(cell);
  const float share = stands < top ? ready_[static_cast<size_t>(drainage_.receiver(cell))] : 1.0F;
  const float hardness = value_or_one(site_.hardness, index) * site_.beds->hardness(index, stands);
  ready_[index] = share * rate / (hardness + rate);
  return share;
}

}  // namespace seamount::erosion
