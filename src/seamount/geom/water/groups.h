// What has been joined so far: union-find over numbered things, each group with the list of its members.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace seamount::geom {

/// The smallest number leads its group. Joining and finding take about constant time; 12 bytes per thing.
class Groups {
 public:
  explicit Groups(int32_t count);
  /// Leader of the group that a thing is in.
  int32_t find(int32_t thing);
  /// REQUIRES: two different leaders.
  void join(int32_t a, int32_t b);

  template <class Visit>
  void for_each_member(int32_t leader, const Visit& visit) const {
    for (int32_t i = leader; i >= 0; i = next_[static_cast<size_t>(i)]) visit(i);
  }

 private:
  std::vector<int32_t> leader_, next_, last_;
};

}  // namespace seamount::geom
