#include "seamount/ops/contour/edit/outflow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "seamount/base/text.h"
#include "seamount/geom/solve/drain.h"
#include "seamount/geom/solve/raise_sinks.h"
#include "seamount/ops/contour/move/places.h"

namespace seamount::contour {
namespace {

constexpr std::array<int, 8> kDx = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<int, 8> kDy = {0, -1, -1, -1, 0, 1, 1, 1};
constexpr double kShallow = 0.5;  ///< of a gap between levels: hollows that no valley is cut for

using Waiting = std::pair<float, int64_t>;
using Queue = std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>>;

template <class Visit>
void for_each_neighbour(const ScalarField& heights, int64_t cell, Visit&& visit) {
  const auto x = static_cast<int>(cell % heights.width());
  const auto y = static_cast<int>(cell / heights.width());
  for (size_t k = 0; k < 8; ++k)
    if (heights.contains(x + kDx[k], y + kDy[k]))
      visit(static_cast<int64_t>(y + kDy[k]) * heights.width() + x + kDx[k], k % 2 == 0 ? 1.0 : std::sqrt(2.0));
}

bool on_border(const ScalarField& heights, int64_t cell) {
  const int64_t x = cell % heights.width();
  const int64_t y = cell / heights.width();
  return x == 0 || y == 0 || x == heights.width() - 1 || y == heights.height() - 1;
}

/// Where water would stand if it could leave over the lattice's edge only.
ScalarField water_levels(const ScalarField& heights, const RunContext& run) {
  ScalarField water(heights.frame(), std::numeric_limits<float>::infinity());
  Queue queue;
  for (int64_t cell = 0; cell < static_cast<int64_t>(heights.size()); ++cell) {
    if (!on_border(heights, cell)) continue;
    water.cells()[static_cast<size_t>(cell)] = heights.cells()[static_cast<size_t>(cell)];
    queue.emplace(heights.cells()[static_cast<size_t>(cell)], cell);
  }
  for (int64_t taken = 1; !queue.empty(); ++taken) {
    if (taken % 16384 == 0) run.check_cancelled();
    const auto [level, cell] = queue.top();
    queue.pop();
    for_each_neighbour(heights, cell, [&, level = level](int64_t next, double) {
      float& there = water.cells()[static_cast<size_t>(next)];
      if (std::isfinite(there)) return;
      there = std::max(level, heights.cells()[static_cast<size_t>(next)]);
      queue.emplace(there, next);
    });
  }
  return water;
}

/// How much deeper water stands at a node than before. Within the outline ground is new: all of it counts.
struct Excess {
  ScalarField before;  ///< water levels

  double at(const EditArea& area, const ScalarField& heights, const ScalarField& water, size_t i) const {
    const double depth = static_cast<double>(water.cells()[i]) - static_cast<double>(heights.cells()[i]);
    if (area.inward.cells()[i] > 0.0F) return depth;
    return std::min(depth, static_cast<double>(water.cells()[i]) - static_cast<double>(before.cells()[i]));
  }

  /// The node where that is most, -1 if nowhere more than `least`; those of `skip` are left out.
  int64_t deepest(const EditArea& area, const ScalarField& heights, const ScalarField& water, double least,
                  const std::vector<char>& skip) const {
    int64_t node = -1;
    double most = least;
    for (size_t i = 0; i < heights.size(); ++i) {
      const double depth = at(area, heights, water, i);
      if (depth <= most || skip[i] != 0) continue;
      most = depth;
      node = static_cast<int64_t>(i);
    }
    return node;
  }
};

/// Three quarters of the ground outside is gentler.
double steep_slope(const EditArea& area) {
  const ScalarField& ground = area.ground;
  std::vector<float> slopes;
  for (int y = 1; y + 1 < ground.height(); ++y)
    for (int x = 1; x + 1 < ground.width(); ++x)
      if (area.inward(x, y) <= 0.0F)
        slopes.push_back(std::hypot(ground(x + 1, y) - ground(x - 1, y), ground(x, y + 1) - ground(x, y - 1)));
  if (slopes.empty()) return 0.0;
  const auto at = slopes.begin() + static_cast<ptrdiff_t>(slopes.size() * 3 / 4);
  std::nth_element(slopes.begin(), at, slopes.end());
  return static_cast<double>(*at) / (2.0 * ground.cell_m());
}

class Valley {
 public:
  Valley(const EditArea& area, ScalarField& heights, double bank_slope)
      : area_(area), heights_(heights), rise_(std::max(bank_slope, 1e-3) * heights.cell_m()) {}

  /// From the lowest node of the pond to lower ground. False if there is none.
  bool cut(int64_t sink, const RunContext& run) {
    std::vector<int64_t> way = lowest_way(sink, 1.0F, run);
    // Ground outside stays: where that bars the lowest way, another through the outline may be free.
    if (is_barred(way)) way = lowest_way(sink, 0.2F, run);
    if (way.size() < 2) return false;
    Queue banks;
    for (size_t i = 0; i < way.size(); ++i) lower(way[i], bed(way, i), banks);
    while (!banks.empty()) {
      const auto [level, cell] = banks.top();
      banks.pop();
      if (level > height(cell)) continue;
      for_each_neighbour(heights_, cell, [&, level = level](int64_t next, double far) {
        lower(next, level + static_cast<float>(rise_ * far), banks);
      });
    }
    return true;
  }

 private:
  float height(int64_t cell) const { return heights_.cells()[static_cast<size_t>(cell)]; }

  /// Height of the new bed along a way: it falls evenly from the sink.
  float bed(const std::vector<int64_t>& way, size_t i) const {
    const float top = height(way.back());
    const float low = std::min(height(way.front()), top);
    return low + static_cast<float>(i) / static_cast<float>(way.size() - 1) * (top - low);
  }

  bool is_barred(const std::vector<int64_t>& way) const {
    for (size_t i = 1; i < way.size(); ++i)
      if (!within(way[i]) && height(way[i]) > bed(way, i) + static_cast<float>(rise_)) return true;
    return false;
  }

  bool within(int64_t cell) const { return area_.inward.cells()[static_cast<size_t>(cell)] > 0.0F; }

  void lower(int64_t cell, float to, Queue& banks) {
    if (!within(cell) || height(cell) <= to) return;
    heights_.cells()[static_cast<size_t>(cell)] = to;
    banks.emplace(to, cell);
  }

  /// From lower ground (or the lattice's edge) to the sink. Ground within the outline counts by a share of what it lies
  /// above the sink.
  std::vector<int64_t> lowest_way(int64_t sink, float share, const RunContext& run) const {
    std::vector<int64_t> from(heights_.size(), -1);
    Queue queue;
    from[static_cast<size_t>(sink)] = sink;
    queue.emplace(0.0F, sink);
    for (int64_t taken = 1; !queue.empty(); ++taken) {
      if (taken % 16384 == 0) run.check_cancelled();
      const int64_t cell = queue.top().second;
      queue.pop();
      if (height(cell) < height(sink) || on_border(heights_, cell)) {
        std::vector<int64_t> way = {cell};
        while (way.back() != sink) way.push_back(from[static_cast<size_t>(way.back())]);
        return way;
      }
      for_each_neighbour(heights_, cell, [&](int64_t next, double) {
        if (from[static_cast<size_t>(next)] >= 0) return;
        from[static_cast<size_t>(next)] = cell;
        const float above = height(next) - height(sink);
        queue.emplace(within(next) ? share * above : above, next);
      });
    }
    return {};
  }

  const EditArea& area_;
  ScalarField& heights_;
  double rise_;  ///< of a bank, a node
};

/// The lowest node of the pond that a node lies in; all of it is marked.
int64_t lowest_in_pond(const ScalarField& heights, const ScalarField& water, int64_t node, std::vector<char>& marked) {
  std::vector<int64_t> open = {node};
  marked[static_cast<size_t>(node)] = 1;
  int64_t lowest = node;
  while (!open.empty()) {
    const int64_t cell = open.back();
    open.pop_back();
    if (heights.cells()[static_cast<size_t>(cell)] < heights.cells()[static_cast<size_t>(lowest)]) lowest = cell;
    for_each_neighbour(heights, cell, [&](int64_t next, double) {
      const auto i = static_cast<size_t>(next);
      if (marked[i] != 0 || water.cells()[i] <= heights.cells()[i]) return;
      marked[i] = 1;
      open.push_back(next);
    });
  }
  return lowest;
}

Vec2 place_of(const ScalarField& heights, int64_t cell) {
  const GridFrame& frame = heights.frame();
  const int64_t column = cell % frame.width, row = cell / frame.width;
  return {frame.x(static_cast<double>(column)), frame.y(static_cast<double>(row))};
}

/// Raises what is left of hollows within the outline.
void raise_shallow(const EditArea& area, ScalarField& heights, double gap_m, const RunContext& run) {
  std::vector<int64_t> outside = geom::find_sinks(heights, run);
  std::erase_if(outside, [&](int64_t cell) { return area.inward.cells()[static_cast<size_t>(cell)] > 0.0F; });
  const geom::Rising rising{static_cast<float>(1e-3 * gap_m), 0.25F, [&](int64_t cell) {
                              const auto i = static_cast<size_t>(cell);
                              return area.inward.cells()[i] > 0.0F ? std::numeric_limits<float>::infinity()
                                                                   : heights.cells()[i];
                            }};
  geom::raise_sinks(heights, outside, rising, run);
}

}  // namespace

std::vector<Pond> find_ponds(const EditArea& area, const ScalarField& heights, double gap_m, const RunContext& run) {
  const Excess excess{water_levels(area.ground, run)};
  const ScalarField water = water_levels(heights, run);
  const int64_t node = excess.deepest(area, heights, water, kShallow * gap_m, std::vector<char>(heights.size(), 0));
  if (node < 0) return {};
  return {{place_of(heights, node), excess.at(area, heights, water, static_cast<size_t>(node))}};
}

std::vector<Pond> let_water_out(const EditArea& area, ScalarField& heights, double gap_m, const RunContext& run) {
  constexpr int kRounds = 4;  // a valley may end in the next pond
  const Excess excess{water_levels(area.ground, run)};
  Valley valley(area, heights, steep_slope(area));
  std::vector<Pond> cut;
  for (int round = 0; round < kRounds; ++round) {
    const ScalarField water = water_levels(heights, run);
    ScalarField before(heights.frame());  // valleys are cut into `heights`
    std::copy(heights.cells().begin(), heights.cells().end(), before.cells().begin());
    std::vector<char> marked(heights.size(), 0);
    const size_t known = cut.size();
    for (;;) {
      run.check_cancelled();
      const int64_t node = excess.deepest(area, before, water, kShallow * gap_m, marked);
      if (node < 0) break;
      const int64_t sink = lowest_in_pond(before, water, node, marked);
      if (valley.cut(sink, run))
        cut.push_back({place_of(heights, sink), excess.at(area, before, water, static_cast<size_t>(node))});
    }
    if (cut.size() == known) break;
  }
  raise_shallow(area, heights, gap_m, run);
  return cut;
}

void say_ponds(const std::string& name, const std::vector<Pond>& cut, const std::vector<Pond>& held,
               const RunContext& run) {
  if (!cut.empty())
    run.say(name + ": " + std::to_string(cut.size()) + (cut.size() == 1 ? " valley was" : " valleys were") +
            " cut through the new ground, for water that would have stood " +
            format_number(std::round(cut.front().depth_m)) + " m deep at " + place_text(cut.front().at));
  if (!held.empty())
    run.say(name + ": water is held back, " + format_number(std::round(held.front().depth_m)) + " m deep at " +
            place_text(held.front().at));
}

}  // namespace seamount::contour
