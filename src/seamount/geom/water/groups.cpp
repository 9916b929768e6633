#include "seamount/geom/water/groups.h"

#include <algorithm>
#include <numeric>

namespace seamount::geom {

Groups::Groups(int32_t count) : leader_(static_cast<size_t>(count)), next_(leader_.size(), -1), last_(leader_.size()) {
  std::iota(leader_.begin(), leader_.end(), 0);
  last_ = leader_;
}

int32_t Groups::find(int32_t thing) {
  auto i = static_cast<size_t>(thing);
  while (static_cast<size_t>(leader_[i]) != i) {
    leader_[i] = leader_[static_cast<size_t>(leader_[i])];
    i = static_cast<size_t>(leader_[i]);
  }
  return static_cast<int32_t>(i);
}

void Groups::join(int32_t a, int32_t b) {
  const auto low = static_cast<size_t>(std::min(a, b)), high = static_cast<size_t>(std::max(a, b));
  leader_[high] = static_cast<int32_t>(low);
  next_[static_cast<size_t>(last_[low])] = static_cast<int32_t>(high);
  last_[low] = last_[high];
}

}  // namespace seamount::geom
