#include "seamount/geom/solve/drain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"

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
struct Queue : std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> {
  void clear() { c.clear(); }  // and keep its memory
};

class Drainage {
 public:
  Drainage(HeightField& heights, std::span<const int64_t> allowed, float most_m, const RunContext& run)
      : heights_(heights), allowed_(allowed.begin(), allowed.end()), most_m_(most_m), run_(run) {
    std::sort(allowed_.begin(), allowed_.end());
  }

  std::vector<int64_t> sinks() const {
    std::vector<int64_t> found = find_sinks(heights_, run_);
    std::erase_if(found, [&](int64_t c) { return is_allowed(c); });
    return found;
  }

  /// Cuts a channel from each sink, the lowest first.
  void cut(const std::vector<int64_t>& sinks) {
    std::vector<Waiting> in_order;
    for (const int64_t sink : sinks) {
      // Channels of lower sinks that come near open this one, others do not: what is too deep now stays so.
      if (lowest_neighbour(sink) <= height(sink) + most_m_) in_order.push_back({height(sink), sink});
    }
    std::sort(in_order.begin(), in_order.end(), [](const Waiting& a, const Waiting& b) { return b > a; });
    if (!in_order.empty()) came_from_.assign(heights_.size(), kUnseen);
    for (const Waiting& sink : in_order) {
      run_.check_cancelled();
      if (lowest_neighbour(sink.cell) >= height(sink.cell)) cut_from(sink.cell);
    }
  }

  /// From the border and the allowed sinks inwards, lowest first; what lies no higher than the cell that it is reached
  /// from is raised to the next float above it.
  void tilt() {
    std::vector<char> seen(heights_.size(), 0);
    Queue queue;
    const auto enter = [&](int64_t cell) {
      if (seen[static_cast<size_t>(cell)] != 0) return;
      seen[static_cast<size_t>(cell)] = 1;
      queue.push({height(cell), cell});
    };
    run_.check_cancelled();
    for (int64_t cell = 0; cell < static_cast<int64_t>(heights_.size()); ++cell)
      if (on_border(cell)) enter(cell);
    for (const int64_t cell : allowed_) enter(cell);
    for (int64_t popped = 0; !queue.empty(); ++popped) {
      if (popped % 16384 == 0) run_.check_cancelled();
      const Waiting here = queue.top();
      queue.pop();
      for_each_neighbour(here.cell, [&](int64_t next) {
        if (seen[static_cast<size_t>(next)] != 0) return;
        float& z = heights_.cells()[static_cast<size_t>(next)];
        if (z <= here.height) z = std::nextafter(here.height, std::numeric_limits<float>::infinity());
        enter(next);
      });
    }
  }

 private:
  static constexpr int8_t kUnseen = -2;
  static constexpr int8_t kStart = -1;
  static constexpr size_t kMostSeen = 1 << 17;

  bool is_allowed(int64_t cell) const { return std::binary_search(allowed_.begin(), allowed_.end(), cell); }
  float height(int64_t cell) const { return heights_.cells()[static_cast<size_t>(cell)]; }
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
        visit(static_cast<int64_t>(y + kDy[k]) * heights_.width() + x + kDx[k]);
    }
  }

  float lowest_neighbour(int64_t cell) const {
    float lowest = std::numeric_limits<float>::infinity();
    for_each_neighbour(cell, [&](int64_t next) { lowest = std::min(lowest, height(next)); });
    return lowest;
  }

  /// Looks for lower ground, always from the lowest cell seen so far.
  void cut_from(int64_t sink) {
    seen_.assign(1, sink);
    came_from_[static_cast<size_t>(sink)] = kStart;
    queue_.clear();
    queue_.push({height(sink), sink});
    while (!queue_.empty() && seen_.size() < kMostSeen) {
      if (seen_.size() % 4096 == 0) run_.check_cancelled();
      const Waiting here = queue_.top();
      queue_.pop();
      if (here.height > height(sink) + most_m_) break;
      const bool lower = here.height < height(sink);
      const bool stays = here.height <= height(sink) && is_allowed(here.cell);
      const bool leaves = on_border(here.cell) || stays;
      if ((leaves || lower) && cut_channel(sink, here.cell, leaves)) break;
      for_each_neighbour(here.cell, [&](int64_t next) {
        int8_t& from = came_from_[static_cast<size_t>(next)];
        if (from != kUnseen) return;
        for (size_t k = 0; k < 8; ++k) {
          const int64_t step = static_cast<int64_t>(kDy[k]) * heights_.width() + kDx[k];
          if (here.cell + step == next) from = static_cast<int8_t>(k);
        }
        seen_.push_back(next);
        queue_.push({height(next), next});
      });
    }
    for (const int64_t cell : seen_) came_from_[static_cast<size_t>(cell)] = kUnseen;
  }

  /// False if the ground falls by too little for as many steps. The border and sinks that are allowed are lowered where
  /// they have to be: to look further would lead out of a basin whose floor is nearly level.
  bool cut_channel(int64_t sink, int64_t outlet, bool leaves) {
    std::vector<int64_t> way;  // from the outlet up to the sink
    for (int64_t cell = outlet; cell != sink;) {
      way.push_back(cell);
      const auto k = static_cast<size_t>(came_from_[static_cast<size_t>(cell)]);
      cell -= static_cast<int64_t>(kDy[k]) * heights_.width() + kDx[k];
    }
    const double top = height(sink);
    double low = height(outlet);
    const double least = std::max({4.0 * 0x1p-23 * std::max(std::abs(low), std::abs(top)), 1e-30});
    if (leaves) low = std::min(low, top - 2.0 * least * static_cast<double>(way.size()));
    const double fall = (top - low) / static_cast<double>(way.size());
    if (fall < least) return false;
    for (size_t i = 0; i < way.size(); ++i) {
      float& z = heights_.cells()[static_cast<size_t>(way[i])];
      z = std::min(z, static_cast<float>(low + fall * static_cast<double>(i)));
    }
    return true;
  }

  HeightField& heights_;
  std::vector<int64_t> allowed_;
  float most_m_;  ///< height over a sink to which a way out of it may climb
  const RunContext& run_;
  std::vector<int8_t> came_from_;  ///< per cell: the direction of the step to it
  std::vector<int64_t> seen_;      ///< by the search at hand
  Queue queue_;
};

SEAMOUNT_VECTORISED void find_sinks_of_row(const float* north, const float* here, const float* south, int width,
                                           uint8_t* is_sink) {
  for (int x = 1; x < width - 1; ++x) {
    const float z = here[x];
    const int higher = (north[x - 1] >= z) & (north[x] >= z) & (north[x + 1] >= z) & (here[x - 1] >= z) &
                       (here[x + 1] >= z) & (south[x - 1] >= z) & (south[x] >= z) & (south[x + 1] >= z);
    is_sink[x] = static_cast<uint8_t>(higher);
  }
}

}  // namespace

std::vector<int64_t> find_sinks(const HeightField& heights, const RunContext& run) {
  const int width = heights.width();
  std::vector<std::vector<int64_t>> rows(static_cast<size_t>(heights.height()));
  parallel_rows(run, width, heights.height(), [&](int begin, int end) {
    std::vector<uint8_t> is_sink(static_cast<size_t>(width), 0);
    for (int y = std::max(begin, 1); y < std::min(end, heights.height() - 1); ++y) {
      const float* const row = heights.row(y).data();
      find_sinks_of_row(row - width, row, row + width, width, is_sink.data());
      for (int x = 1; x + 1 < width; ++x)
        if (is_sink[static_cast<size_t>(x)] != 0)
          rows[static_cast<size_t>(y)].push_back(static_cast<int64_t>(y) * width + x);
    }
  });
  std::vector<int64_t> sinks;
  for (const std::vector<int64_t>& row : rows) sinks.insert(sinks.end(), row.begin(), row.end());
  return sinks;
}

void drain(HeightField& heights, std::span<const int64_t> allowed, const RunContext& run) {
  Drainage drainage(heights, allowed, std::numeric_limits<float>::infinity(), run);
  const std::vector<int64_t> sinks = drainage.sinks();
  // Wide flats are not worth a search from each of their cells.
  const size_t few = 1000 + heights.size() / 200;
  if (!sinks.empty() && sinks.size() < few) drainage.cut(sinks);
  if (!sinks.empty() && !drainage.sinks().empty()) drainage.tilt();
}

void drain_shallow(HeightField& heights, const std::vector<int64_t>& sinks, float most_m, const RunContext& run) {
  if (!sinks.empty()) Drainage(heights, {}, most_m, run).cut(sinks);
}

}  // namespace seamount::geom
