#include "seamount/geom/solve/raise_sinks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "seamount/geom/solve/drain.h"

namespace seamount::geom {
namespace {

constexpr std::array<int, 8> kDx = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<int, 8> kDy = {0, -1, -1, -1, 0, 1, 1, 1};

/// Lowest first, then in the order of their numbers.
struct Waiting {
  float height;
  int64_t cell;
  bool operator>(const Waiting& other) const {
    return height != other.height ? height > other.height : cell > other.cell;
  }
};
using Queue = std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>>;

class Raise {
 public:
  Raise(HeightField& heights, std::span<const int64_t> allowed, const Rising& rising, const RunContext& run)
      : heights_(heights), rising_(rising), run_(run), marks_(heights.size(), 0) {
    for (const int64_t cell : allowed) marks_[static_cast<size_t>(cell)] |= kAllowed;
  }

  void from(int64_t sink) {
    if ((mark(sink) & kAllowed) != 0 || has_lower_neighbour(sink)) return;
    const auto [outlet, sill] = find_outlet(sink);
    if (outlet >= 0) raise_from(outlet, sill, sill + rising_.most_tilted * (sill - height(sink)));
    for (const int64_t cell : touched_) mark(cell) &= kAllowed;
    touched_.clear();
  }

 private:
  static constexpr uint8_t kAllowed = 1;
  static constexpr uint8_t kSeen = 2;
  static constexpr uint8_t kFlooded = 4;  ///< lies no higher than the sill
  static constexpr uint8_t kDone = 8;

  uint8_t& mark(int64_t cell) { return marks_[static_cast<size_t>(cell)]; }
  float& height(int64_t cell) { return heights_.cells()[static_cast<size_t>(cell)]; }
  bool on_border(int64_t cell) const {
    const int64_t x = cell % heights_.width();
    const int64_t y = cell / heights_.width();
    return x == 0 || y == 0 || x == heights_.width() - 1 || y == heights_.height() - 1;
  }

  template <class Visit>
  void for_each_neighbour(int64_t cell, Visit&& visit) const {
    const auto x = static_cast<int>(cell % heights_.width());
    const auto y = static_cast<int>(cell / heights_.width());
    for (size_t k = 0; k < 8; ++k) {
      if (heights_.contains(x + kDx[k], y + kDy[k]))
        visit(static_cast<int64_t>(y + kDy[k]) * heights_.width() + x + kDx[k], k % 2 == 0 ? 1.0F : 1.41421356F);
    }
  }

  bool has_lower_neighbour(int64_t cell) {
    bool lower = false;
    for_each_neighbour(cell, [&](int64_t next, float) { lower = lower || height(next) < height(cell); });
    return lower;
  }

  struct Outlet {
    int64_t cell;
    float sill;
  };
  /// Floods from the sink, the lowest cell first, until water leaves.
  Outlet find_outlet(int64_t sink) {
    Queue queue;
    mark(sink) |= kSeen;
    touched_.push_back(sink);
    queue.push({height(sink), sink});
    float water = height(sink);
    while (!queue.empty()) {
      if (touched_.size() % 4096 == 0) run_.check_cancelled();
      const Waiting here = queue.top();
      queue.pop();
      if (here.height < water || on_border(here.cell) || (mark(here.cell) & kAllowed) != 0)
        return {here.cell, std::max(water, here.height)};
      water = here.height;
      mark(here.cell) |= kFlooded;
      for_each_neighbour(here.cell, [&](int64_t next, float) {
        if ((mark(next) & kSeen) != 0) return;
        mark(next) |= kSeen;
        touched_.push_back(next);
        queue.push({height(next), next});
      });
    }
    return {-1, water};
  }

  /// From the outlet into the flooded ground, and on wherever the ground above the sill does not rise as the tilt does.
  void raise_from(int64_t outlet, float sill, float top) {
    Queue queue;
    queue.push({height(outlet), outlet});
    mark(outlet) |= kDone;
    for (int64_t taken = 1; !queue.empty(); ++taken) {
      if (taken % 4096 == 0) run_.check_cancelled();
      const Waiting here = queue.top();
      queue.pop();
      for_each_neighbour(here.cell, [&](int64_t next, float far) {
        uint8_t& known = mark(next);
        if ((known & (kDone | kAllowed)) != 0 || on_border(next)) return;
        const float least = std::max(std::min(here.height + rising_.tilt * far, top),
                                     std::nextafter(here.height, std::numeric_limits<float>::infinity()));
        float& z = height(next);
        const bool flooded = (known & kFlooded) != 0;
        if (!flooded && (here.cell == outlet || z < sill || z >= least)) return;
        if ((known & kSeen) == 0) {
          known |= kSeen;
          touched_.push_back(next);
        }
        known |= kDone;
        z = std::max(z, std::min(least, rising_.ceiling(next)));
        queue.push({z, next});
      });
    }
  }

  HeightField& heights_;
  const Rising& rising_;
  const RunContext& run_;
  std::vector<uint8_t> marks_;
  std::vector<int64_t> touched_;
};

}  // namespace

void raise_sinks(HeightField& heights, std::span<const int64_t> allowed, const Rising& rising, const RunContext& run) {
  std::vector<int64_t> sinks = find_sinks(heights, run);
  if (sinks.empty()) return;
  std::sort(sinks.begin(), sinks.end(), [&](int64_t a, int64_t b) {
    const float za = heights.cells()[static_cast<size_t>(a)];
    const float zb = heights.cells()[static_cast<size_t>(b)];
    return za != zb ? za > zb : a < b;
  });
  Raise raise(heights, allowed, rising, run);
  for (const int64_t sink : sinks) {
    run.check_cancelled();
    raise.from(sink);
  }
}

}  // namespace seamount::geom
