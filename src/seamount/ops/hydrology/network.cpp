#include "seamount/ops/hydrology/network.h"

#include <algorithm>

namespace seamount::hydrology {
namespace {

class NetworkBuilder {
 public:
  NetworkBuilder(const geom::FlowDirections& directions, const ScalarField& accumulation, double threshold,
                 const Grid<uint8_t>* mask)
      : directions_(directions),
        accumulation_(accumulation),
        threshold_(threshold),
        mask_(mask),
        steps_(geom::flow_steps(directions.width())) {}

  std::vector<Link> build(const RunContext& run) {
    for (int y = 0; y < directions_.height(); ++y) {
      run.check_cancelled();
      for (int x = 0; x < directions_.width(); ++x) {
        const auto cell = static_cast<int32_t>(static_cast<int64_t>(y) * directions_.width() + x);
        if (starts_link(cell, x, y)) trace(cell);
      }
    }
    connect();
    return in_order();
  }

 private:
  bool is_channel(int64_t cell) const {
    return static_cast<double>(accumulation_.data()[cell]) >= threshold_ &&
           (mask_ == nullptr || mask_->data()[cell] != 0);
  }

  bool starts_link(int32_t cell, int x, int y) const {
    if (!is_channel(cell) || directions_.data()[cell] >= 8) return false;
    int donors = 0;
    for (size_t k = 0; k < 8; ++k) {
      if (!directions_.contains(x + geom::kFlowDx[k], y + geom::kFlowDy[k])) continue;
      const int64_t other = cell + steps_[k];
      if (directions_.data()[other] == (k + 4) % 8 && is_channel(other)) ++donors;
    }
    return donors != 1;
  }

  void trace(int32_t cell) {
    Link link{{cell}};
    do {
      cell = static_cast<int32_t>(cell + steps_[directions_.data()[cell]]);
      link.cells.push_back(cell);
    } while (is_channel(cell) && directions_.data()[cell] < 8 &&
             !starts_link(cell, cell % directions_.width(), cell / directions_.width()));
    link.drained = static_cast<double>(accumulation_.data()[link.cells[link.cells.size() - 2]]);
    links_.push_back(std::move(link));
  }

  /// Links were traced in the order of their first cells.
  void connect() {
    for (Link& link : links_) {
      const int32_t end = link.cells.back();
      const auto found = std::lower_bound(links_.begin(), links_.end(), end,
                                          [](const Link& other, int32_t cell) { return other.cells.front() < cell; });
      if (found != links_.end() && found->cells.front() == end) link.next = static_cast<int>(found - links_.begin());
    }
  }

  /// Sorted downstream, with orders.
  std::vector<Link> in_order() {
    std::vector<int> waiting(links_.size(), 0), highest(links_.size(), 0), times(links_.size(), 0),
        place(links_.size());
    for (const Link& link : links_)
      if (link.next >= 0) ++waiting[static_cast<size_t>(link.next)];
    std::vector<size_t> queue;
    for (size_t i = 0; i < links_.size(); ++i)
      if (waiting[i] == 0) queue.push_back(i);
    for (size_t at = 0; at < queue.size(); ++at) {
      const size_t i = queue[at];
      place[i] = static_cast<int>(at);
      Link& link = links_[i];
      if (times[i] > 0) link.order = times[i] > 1 ? highest[i] + 1 : highest[i];
      if (link.next < 0) continue;
      const auto next = static_cast<size_t>(link.next);
      if (link.order > highest[next]) highest[next] = link.order, times[next] = 0;
      if (link.order == highest[next]) ++times[next];
      if (--waiting[next] == 0) queue.push_back(next);
    }
    std::vector<Link> sorted;
    sorted.reserve(queue.size());
    for (const size_t i : queue) {
      sorted.push_back(std::move(links_[i]));
      if (sorted.back().next >= 0) sorted.back().next = place[static_cast<size_t>(sorted.back().next)];
    }
    return sorted;
  }

  const geom::FlowDirections& directions_;
  const ScalarField& accumulation_;
  double threshold_;
  const Grid<uint8_t>* mask_;
  std::array<int64_t, 8> steps_;
  std::vector<Link> links_;
};

}  // namespace

std::vector<Link> find_links(const geom::FlowDirections& directions, const ScalarField& accumulation, double threshold,
                             const Grid<uint8_t>* mask, const RunContext& run) {
  return NetworkBuilder(directions, accumulation, threshold, mask).build(run);
}

std::vector<int> streams_by_order(const std::vector<Link>& links) {
  std::vector<int> counts;
  for (const Link& link : links) {
    counts.resize(std::max(counts.size(), static_cast<size_t>(link.order)), 0);
    const bool goes_on = link.next >= 0 && links[static_cast<size_t>(link.next)].order == link.order;
    if (!goes_on) ++counts[static_cast<size_t>(link.order - 1)];
  }
  return counts;
}

}  // namespace seamount::hydrology
