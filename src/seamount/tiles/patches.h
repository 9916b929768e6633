// Lakes, holes and the like: cells that hang together by their sides, found tile by tile and put together over the
// borders.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "seamount/geom/water/groups.h"
#include "seamount/tiles/borders.h"

namespace seamount::tiles {

/// Such cells, or what of them lies in a tile.
struct Patch {
  Rect around;
  CellPlace first;  ///< row by row
  int64_t cells = 0;

  void add(int column, int row) {
    around = united(around, {column, row, 1, 1});
    ++cells;
  }
  void add(const Patch& other) {
    around = united(around, other.around);
    cells += other.cells;
    if (std::tie(other.first.row, other.first.column) < std::tie(first.row, first.column)) first = other.first;
  }
};

/// The patches of a tile, and which of them each cell is in; -1: none.
template <class P>
struct TilePatches {
  Grid<int32_t> of;
  std::vector<P> all;
};

/// Cells of a tile by their numbers in it: those that `belongs(cell)`, side by side where they are the `same(a, b)`.
template <class P, class Belongs, class Same>
TilePatches<P> find_patches(const GridFrame& frame, const Rect& rect, const Belongs& belongs, const Same& same) {
  constexpr std::array<std::array<int, 2>, 4> kSides = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  TilePatches<P> patches{Grid<int32_t>(frame, -1), {}};
  std::vector<int32_t> left;
  for (int32_t first = 0; first < static_cast<int32_t>(frame.cells()); ++first) {
    if (patches.of.data()[first] >= 0 || !belongs(first)) continue;
    const auto number = static_cast<int32_t>(patches.all.size());
    P patch;
    patch.first = {rect.column + first % rect.width, rect.row + first / rect.width};
    patches.of.data()[first] = number;
    left.assign(1, first);
    while (!left.empty()) {
      const int x = left.back() % rect.width, y = left.back() / rect.width;
      left.pop_back();
      patch.add(rect.column + x, rect.row + y);
      for (const auto& [dx, dy] : kSides) {
        if (!patches.of.contains(x + dx, y + dy) || patches.of(x + dx, y + dy) >= 0) continue;
        const int32_t next = (y + dy) * rect.width + x + dx;
        if (!belongs(next) || !same(first, next)) continue;
        patches.of.data()[next] = number;
        left.push_back(next);
      }
    }
    patches.all.push_back(patch);
  }
  return patches;
}

/// The numbers of the patches that a tile's rim cells are in, by their rim numbers.
template <class P>
std::vector<int32_t> patches_of_rim(const TilePatches<P>& patches, const Layout& layout, int tile) {
  const Rect rect = layout.tile(tile);
  std::vector<int32_t> of_rim(static_cast<size_t>(rim_size(layout, tile)));
  for (size_t rim = 0; rim < of_rim.size(); ++rim)
    of_rim[rim] = patches.of.data()[geom::rim_cell(static_cast<int32_t>(rim), rect.width, rect.height)];
  return of_rim;
}

/// The patches of all tiles.
template <class P>
class JoinedPatches {
 public:
  /// REQUIRES: tiles in their order. `of_rim`: which of `own` each rim cell is in, -1 for none; empty: none is in any.
  void add_tile(const std::vector<P>& own, std::vector<int32_t> of_rim) {
    begins_.push_back(static_cast<int32_t>(all_.size()));
    all_.insert(all_.end(), own.begin(), own.end());
    of_rim_.push_back(std::move(of_rim));
  }

  /// Puts together those that are side by side and `same(a, b)`: the first of them then is all of it, and the others
  /// have no cells.
  template <class Same>
  void join(const Layout& layout, const Same& same) {
    groups_ = geom::Groups(static_cast<int32_t>(all_.size()));
    for_each_border_pair(layout, [&](const RimPlace& a, const RimPlace& b) {
      const CellPlace one = cell_place(layout, a), other = cell_place(layout, b);
      if (one.column != other.column && one.row != other.row) return;  // by sides only
      const int32_t x = at(a), y = at(b);
      if (x < 0 || y < 0 || !same(all_[static_cast<size_t>(x)], all_[static_cast<size_t>(y)])) return;
      const int32_t low = std::min(groups_.find(x), groups_.find(y)), high = std::max(groups_.find(x), groups_.find(y));
      if (low == high) return;
      groups_.join(low, high);
      all_[static_cast<size_t>(low)].add(all_[static_cast<size_t>(high)]);
      all_[static_cast<size_t>(high)].cells = 0;
    });
  }

  const std::vector<P>& all() const { return all_; }
  /// The place in all() of what a tile's own patch is part of. REQUIRES: joined.
  int32_t whole_of(int tile, int32_t own) { return groups_.find(begins_[static_cast<size_t>(tile)] + own); }

 private:
  int32_t at(const RimPlace& place) const {
    const std::vector<int32_t>& of_rim = of_rim_[static_cast<size_t>(place.tile)];
    const int32_t own = of_rim.empty() ? -1 : of_rim[static_cast<size_t>(place.rim)];
    return own < 0 ? -1 : begins_[static_cast<size_t>(place.tile)] + own;
  }

  std::vector<P> all_;
  std::vector<int32_t> begins_;               ///< by tile: where its own begin
  std::vector<std::vector<int32_t>> of_rim_;  ///< by tile and rim number
  geom::Groups groups_{0};
};

}  // namespace seamount::tiles
