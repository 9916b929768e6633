#include "seamount/ops/sketch/ink.h"

#include <algorithm>
#include <cmath>

#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/skeleton.h"

namespace seamount::sketch {
namespace {

constexpr int32_t kNone = -1;

class Sheet {
 public:
  Sheet(const Ground& ground, const RunContext& run)
      : ground_(ground), frame_(ground.heights.frame()), cells_(frame_, 0), run_(run) {}

  void draw(const Strokes& strokes) {
    for (size_t i = 0; i < strokes.places.size(); ++i)
      if (strokes.down[i] >= 0) draw(strokes.places[i], strokes.places[static_cast<size_t>(strokes.down[i])]);
    geom::thin(cells_, run_);
  }

  /// Fills small holes and opens the others.
  void untangle(double small_cells) {
    fill_holes(small_cells);
    geom::thin(cells_, run_);
    while (open_hole()) geom::thin(cells_, run_);
  }

  /// Finds for each cell the one downstream. Pieces begin at a root or, for want of one, at an outlet or anywhere.
  void grow_trees(const std::vector<int32_t>& roots, bool outlets, const std::vector<int32_t>& ends, size_t least) {
    down_.assign(cells_.size(), kUnseen);
    for (const int32_t root : roots)
      for_block(root, 1, [&](int32_t cell) {
        if (is_new(cell) && (!outlets || is_outlet(cell, ends))) grow_tree(cell, least);
      });
    for (int32_t cell = 0; cell < static_cast<int32_t>(cells_.size()); ++cell)
      if (is_new(cell) && is_outlet(cell, ends)) grow_tree(cell, least);
    for (int32_t cell = 0; cell < static_cast<int32_t>(cells_.size()); ++cell) {
      if (!is_new(cell)) continue;
      if (outlets)
        cells_.data()[cell] = 0;
      else
        grow_tree(cell, least);
    }
    drop_corners();
  }

  std::vector<Polyline> lines() const {
    std::vector<uint8_t> above(cells_.size(), 0);
    for (const int32_t next : down_)
      if (next >= 0) ++above[static_cast<size_t>(next)];
    std::vector<Polyline> lines;
    for (int32_t cell = 0; cell < static_cast<int32_t>(cells_.size()); ++cell) {
      if (down_[static_cast<size_t>(cell)] < 0 || above[static_cast<size_t>(cell)] == 1) continue;
      geom::CellChain chain{cell};
      do chain.push_back(down_[static_cast<size_t>(chain.back())]);
      while (down_[static_cast<size_t>(chain.back())] >= 0 && above[static_cast<size_t>(chain.back())] == 1);
      lines.push_back(geom::smooth_chain(chain, frame_));
    }
    return lines;
  }

  int32_t cell_at(Vec2 place) const {
    const int x = std::clamp(static_cast<int>(std::lround(frame_.column(place.x))), 0, frame_.width - 1);
    const int y = std::clamp(static_cast<int>(std::lround(frame_.row(place.y))), 0, frame_.height - 1);
    return y * frame_.width + x;
  }

  const Grid<uint8_t>& cells() const { return cells_; }

 private:
  static constexpr int32_t kUnseen = -2;

  template <class Visit>
  void for_block(int32_t cell, int reach, const Visit& visit) const {
    const int x = cell % frame_.width, y = cell / frame_.width;
    for (int v = std::max(0, y - reach); v <= std::min(frame_.height - 1, y + reach); ++v)
      for (int u = std::max(0, x - reach); u <= std::min(frame_.width - 1, x + reach); ++u) visit(v * frame_.width + u);
  }

  int neighbours(int32_t cell) const {
    int count = -1;
    for_block(cell, 1, [&](int32_t one) { count += cells_.data()[one] != 0 ? 1 : 0; });
    return count;
  }

  void draw(Vec2 from, Vec2 to) {
    const double x = frame_.column(from.x), y = frame_.row(from.y), dx = frame_.column(to.x) - x,
                 dy = frame_.row(to.y) - y;
    const int steps = std::max(1, static_cast<int>(std::ceil(std::max(std::abs(dx), std::abs(dy)))));
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const int u = std::clamp(static_cast<int>(std::lround(x + t * dx)), 0, frame_.width - 1);
      const int v = std::clamp(static_cast<int>(std::lround(y + t * dy)), 0, frame_.height - 1);
      const size_t cell = static_cast<size_t>(v) * static_cast<size_t>(frame_.width) + static_cast<size_t>(u);
      if (ground_.is_land(cell)) cells_.data()[cell] = 1;
    }
  }

  /// Numbers the pieces (4-connected) of what is not drawn, from 1 on; those that touch the edge are 0.
  int32_t number_holes() {
    hole_.assign(cells_.size(), kUnseen);
    int32_t holes = 0;
    std::vector<int32_t> piece;
    for (int32_t first = 0; first < static_cast<int32_t>(cells_.size()); ++first) {
      if (cells_.data()[first] != 0 || hole_[static_cast<size_t>(first)] != kUnseen) continue;
      bool open = false;
      const int32_t number = holes + 1;
      piece.assign(1, first);
      hole_[static_cast<size_t>(first)] = number;
      for (size_t i = 0; i < piece.size(); ++i) {
        const int x = piece[i] % frame_.width, y = piece[i] / frame_.width;
        open = open || x == 0 || y == 0 || x == frame_.width - 1 || y == frame_.height - 1;
        for (size_t k = 0; k < 8; k += 2) {
          const int u = x + geom::kFlowDx[k], v = y + geom::kFlowDy[k];
          if (!cells_.contains(u, v) || cells_(u, v) != 0) continue;
          int32_t& there = hole_[static_cast<size_t>(v * frame_.width + u)];
          if (there != kUnseen) continue;
          there = number;
          piece.push_back(v * frame_.width + u);
        }
      }
      if (open)
        for (const int32_t cell : piece) hole_[static_cast<size_t>(cell)] = 0;
      else
        ++holes;
    }
    return holes;
  }

  void fill_holes(double small_cells) {
    const int32_t holes = number_holes();
    std::vector<double> size(static_cast<size_t>(holes) + 1, 0.0);
    for (size_t i = 0; i < cells_.size(); ++i) {
      if (hole_[i] <= 0) continue;
      size[static_cast<size_t>(hole_[i])] += ground_.is_land(i) ? 1.0 : small_cells + 1.0;
    }
    for (size_t i = 0; i < cells_.size(); ++i)
      if (hole_[i] > 0 && size[static_cast<size_t>(hole_[i])] <= small_cells) cells_.data()[i] = 1;
  }

  /// Clears the shortest chain between the first hole and what is not that hole. False without a hole.
  bool open_hole() {
    if (number_holes() == 0) return false;
    const auto beside = [&](int32_t cell, bool inside) {
      bool found = false;
      for_block(cell, 1, [&](int32_t one) {
        const int32_t hole = hole_[static_cast<size_t>(one)];
        found = found || (hole >= 0 && (hole == 1) == inside);
      });
      return found;
    };
    geom::CellChain best;
    for (const geom::CellChain& chain : geom::trace_skeleton(cells_)) {
      if (chain.size() < 3 || (!best.empty() && chain.size() >= best.size())) continue;
      const int32_t middle = chain[chain.size() / 2];
      if (beside(middle, true) && beside(middle, false)) best = chain;
    }
    for (size_t i = 1; i + 1 < best.size(); ++i) cells_.data()[best[i]] = 0;
    if (!best.empty()) return true;
    for (int32_t cell = 0; cell < static_cast<int32_t>(cells_.size()); ++cell) {
      if (cells_.data()[cell] == 0 || !beside(cell, true) || !beside(cell, false)) continue;
      cells_.data()[cell] = 0;
      return true;
    }
    return false;
  }

  bool is_outlet(int32_t cell, const std::vector<int32_t>& ends) const {
    const int x = cell % frame_.width, y = cell / frame_.width;
    if (x == 0 || y == 0 || x == frame_.width - 1 || y == frame_.height - 1) return true;
    bool found = false;
    for_block(cell, 1, [&](int32_t one) {
      found = found || !ground_.is_land(static_cast<size_t>(one)) || std::binary_search(ends.begin(), ends.end(), one);
    });
    return found;
  }

  bool is_new(int32_t cell) const { return cells_.data()[cell] != 0 && down_[static_cast<size_t>(cell)] == kUnseen; }

  /// Clears what is too small.
  void grow_tree(int32_t root, size_t least) {
    down_[static_cast<size_t>(root)] = kNone;
    std::vector<int32_t> tree{root};
    for (size_t i = 0; i < tree.size(); ++i) {
      const int32_t here = tree[i];
      for (const bool straight : {true, false})
        for_block(here, 1, [&](int32_t one) {
          const int apart = std::abs(one - here);
          if ((apart == 1 || apart == frame_.width) != straight || !is_new(one)) return;
          down_[static_cast<size_t>(one)] = here;
          tree.push_back(one);
        });
    }
    if (tree.size() >= least) return;
    for (const int32_t cell : tree) clear(cell);
  }

  void clear(int32_t cell) {
    cells_.data()[cell] = 0;
    down_[static_cast<size_t>(cell)] = kUnseen;
  }

  /// Where three cells touch one another, one of them may be the end of nothing.
  void drop_corners() {
    std::vector<uint8_t> above(cells_.size(), 0);
    for (const int32_t next : down_)
      if (next >= 0) above[static_cast<size_t>(next)] = 1;
    for (int32_t cell = 0; cell < static_cast<int32_t>(cells_.size()); ++cell)
      if (down_[static_cast<size_t>(cell)] >= 0 && above[static_cast<size_t>(cell)] == 0 && neighbours(cell) > 1 &&
          !is_surrounded(cell))
        clear(cell);
  }

  bool is_surrounded(int32_t cell) const {
    const int x = cell % frame_.width, y = cell / frame_.width;
    for (size_t k = 0; k < 8; k += 2) {
      const int u = x + geom::kFlowDx[k], v = y + geom::kFlowDy[k];
      if (!cells_.contains(u, v) || cells_(u, v) == 0) return false;
    }
    return true;
  }

  const Ground& ground_;
  const GridFrame& frame_;
  Grid<uint8_t> cells_;
  const RunContext& run_;
  std::vector<int32_t> hole_, down_;
};

}  // namespace

Inked ink(const Strokes& strokes, const Ground& ground, bool outlets, const std::vector<Vec2>& ends, double close_m,
          double least_m, const RunContext& run) {
  Sheet sheet(ground, run);
  sheet.draw(strokes);
  const double close = close_m / ground.heights.cell_m();
  sheet.untangle(std::max(4.0, close * close));
  std::vector<int32_t> roots, stops;
  for (size_t i = 0; i < strokes.places.size(); ++i)
    if (strokes.down[i] < 0) roots.push_back(sheet.cell_at(strokes.places[i]));
  for (const Vec2 end : ends) stops.push_back(sheet.cell_at(end));
  std::sort(stops.begin(), stops.end());
  sheet.grow_trees(roots, outlets, stops, static_cast<size_t>(std::max(2.0, least_m / ground.heights.cell_m())));
  Inked out{Mask(ground.heights.frame()), sheet.lines()};
  for (size_t i = 0; i < out.cells.size(); ++i) out.cells.data()[i] = sheet.cells().data()[i] != 0 ? 1.0F : 0.0F;
  return out;
}

}  // namespace seamount::sketch
