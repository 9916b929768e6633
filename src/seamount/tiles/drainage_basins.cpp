// Which outlet each cell drains to (drainage.h).
#include <algorithm>

#include "seamount/geom/water/inland.h"
#include "seamount/tiles/drainage.h"

namespace seamount::tiles {
namespace {

/// An end of flow that has a catchment.
struct Mouth {
  uint64_t drained = 0;
  int64_t place = 0;  ///< in the whole, row by row: what decides between equals
  int32_t tile = 0, cell = 0;
};

/// The cell in a tile to which each of its cells drains, or over which it leaves it.
Grid<int32_t> ends_in(const geom::FlowDirections& codes, const RunContext& run) {
  Grid<int32_t> ends(codes.frame(), -1);
  for (int y = 0; y < codes.height(); ++y) {
    for (int x = 0; x < codes.width(); ++x) {
      const uint8_t code = codes(x, y);
      if (code >= 8 || !codes.contains(x + geom::kFlowDx[code], y + geom::kFlowDy[code]))
        ends(x, y) = y * codes.width() + x;
    }
  }
  geom::label_upstream(codes, ends, run);
  return ends;
}

}  // namespace

/// The node that flow enters which leaves a tile at a cell; -1 where it ends there.
int32_t Drainage::entered_from(int tile, int32_t cell, uint8_t code) const {
  if (code >= 8) return -1;
  const Rect rect = layout_.tile(tile);
  const int column = rect.column + cell % rect.width + geom::kFlowDx[code];
  const int row = rect.row + cell / rect.width + geom::kFlowDy[code];
  return node_of(rim_place(layout_, column, row));
}

void Drainage::number_basins(const RunContext& run) {
  const auto nodes = static_cast<size_t>(first_node_.back());
  std::vector<Mouth> mouths;
  std::vector<int32_t> next(nodes, -1), end(nodes, -1);  // the node that its flow enters, or the cell where it ends
  for (int tile = 0; tile < layout_.count(); ++tile) {
    run.check_cancelled();
    const geom::FlowDirections codes = directions(tile);
    const HeightField z = filled(tile);
    const Grid<uint64_t> drained = cells(tile);
    const Rect rect = layout_.tile(tile);
    for (int32_t i = 0; i < static_cast<int32_t>(codes.size()); ++i) {
      if (codes.data()[i] != geom::kOutlet || (z.data()[i] <= sea_m_ && drained.data()[i] == 1)) continue;
      const int64_t place = int64_t{rect.row + i / rect.width} * layout_.width + rect.column + i % rect.width;
      mouths.push_back({drained.data()[i], place, tile, i});
    }
    const Grid<int32_t> ends = ends_in(codes, run_);
    for (int32_t rim = 0; rim < rim_size(layout_, tile); ++rim) {
      const auto node = static_cast<size_t>(node_of({tile, rim}));
      const int32_t cell = ends.data()[geom::rim_cell(rim, rect.width, rect.height)];
      next[node] = entered_from(tile, cell, codes.data()[cell]);
      end[node] = cell;
    }
    run.report((tile + 1.0) / layout_.count());
  }
  std::sort(mouths.begin(), mouths.end(), [](const Mouth& a, const Mouth& b) {
    return a.drained != b.drained ? a.drained > b.drained : a.place < b.place;
  });
  drained_.clear();
  for (const Mouth& mouth : mouths) drained_.push_back(mouth.drained);
  mouths_.assign(static_cast<size_t>(layout_.count()), {});
  for (size_t i = 0; i < mouths.size(); ++i)
    mouths_[static_cast<size_t>(mouths[i].tile)].push_back({mouths[i].cell, static_cast<int32_t>(i + 1)});
  for (auto& of_tile : mouths_)
    std::sort(of_tile.begin(), of_tile.end(), [](const Numbered& a, const Numbered& b) { return a.cell < b.cell; });
  follow_to_mouths(next, end);
}

/// basin_of_node_ from where flow goes on and ends.
void Drainage::follow_to_mouths(const std::vector<int32_t>& next, const std::vector<int32_t>& end) {
  constexpr int32_t kUnknown = -1;
  basin_of_node_.assign(next.size(), kUnknown);
  std::vector<int32_t> way;
  for (int tile = 0; tile < layout_.count(); ++tile) {
    for (int32_t first = first_node_[static_cast<size_t>(tile)]; first < first_node_[static_cast<size_t>(tile) + 1];
         ++first) {
      way.clear();
      int32_t node = first;
      while (basin_of_node_[static_cast<size_t>(node)] == kUnknown && next[static_cast<size_t>(node)] >= 0) {
        way.push_back(node);
        node = next[static_cast<size_t>(node)];
      }
      int32_t& here = basin_of_node_[static_cast<size_t>(node)];
      if (here == kUnknown) {
        const auto after = std::upper_bound(first_node_.begin(), first_node_.end(), node);
        here = basin_at(static_cast<int>(after - first_node_.begin()) - 1, end[static_cast<size_t>(node)]);
      }
      const int32_t found = here;
      for (const int32_t passed : way) basin_of_node_[static_cast<size_t>(passed)] = found;
    }
  }
}

/// The number of the catchment whose mouth a cell of a tile is; 0 for open water.
int32_t Drainage::basin_at(int tile, int32_t cell) const {
  const auto& of_tile = mouths_[static_cast<size_t>(tile)];
  const auto found = std::lower_bound(of_tile.begin(), of_tile.end(), cell,
                                      [](const Numbered& one, int32_t wanted) { return one.cell < wanted; });
  return found != of_tile.end() && found->cell == cell ? found->basin : 0;
}

size_t Drainage::basins_of_at_least(double cells) const {
  const auto smaller = std::find_if(drained_.begin(), drained_.end(),
                                    [&](uint64_t drained) { return static_cast<double>(drained) < 0.999 * cells; });
  return static_cast<size_t>(smaller - drained_.begin());
}

Grid<int32_t> Drainage::basins(int tile) const {
  const geom::FlowDirections codes = directions(tile);
  Grid<int32_t> basins(codes.frame(), -1);
  for (int y = 0; y < codes.height(); ++y) {
    for (int x = 0; x < codes.width(); ++x) {
      const uint8_t code = codes(x, y);
      const int32_t cell = y * codes.width() + x;
      if (code >= 8)
        basins(x, y) = basin_at(tile, cell);
      else if (!codes.contains(x + geom::kFlowDx[code], y + geom::kFlowDy[code]))
        basins(x, y) = basin_of_node_[static_cast<size_t>(entered_from(tile, cell, code))];
    }
  }
  geom::label_upstream(codes, basins, run_);
  const HeightField z = bed(layout_.tile(tile));  // of what drains into the unknown, that is no part
  for (size_t i = 0; i < basins.size(); ++i)
    if (z.data()[i] == geom::kUnknownGround) basins.data()[i] = 0;
  return basins;
}

}  // namespace seamount::tiles
