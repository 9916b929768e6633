#include "seamount/tiles/layout.h"

#include <fmt/format.h>

namespace seamount::tiles {

Rect united(const Rect& a, const Rect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  const int column = std::min(a.column, b.column), row = std::min(a.row, b.row);
  return {column, row, std::max(a.column + a.width, b.column + b.width) - column,
          std::max(a.row + a.height, b.row + b.height) - row};
}

Rect common(const Rect& a, const Rect& b) {
  const int column = std::max(a.column, b.column), row = std::max(a.row, b.row);
  return {column, row, std::min(a.column + a.width, b.column + b.width) - column,
          std::min(a.row + a.height, b.row + b.height) - row};
}

Rect with_reach(const Rect& rect, const Reach& reach, const GridFrame& frame) {
  const auto begin = [&](int cell) { return std::max(0, cell - reach.cells) / reach.step * reach.step; };
  const auto end = [&](int cell, int size) {
    return static_cast<int>(std::min<int64_t>(size, int64_t{cell} + reach.cells));
  };
  const int column = begin(rect.column), row = begin(rect.row);
  return {column, row, end(rect.column + rect.width, frame.width) - column,
          end(rect.row + rect.height, frame.height) - row};
}

std::string Layout::name(int index) const {
  const Rect rect = tile(index);
  return fmt::format("tile {} of row {} (columns {} to {}, rows {} to {})", index % columns() + 1,
                     index / columns() + 1, rect.column, rect.column + rect.width - 1, rect.row,
                     rect.row + rect.height - 1);
}

}  // namespace seamount::tiles
