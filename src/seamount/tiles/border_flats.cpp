#include "seamount/tiles/border_flats.h"

#include <algorithm>

#include "seamount/geom/water/groups.h"

namespace seamount::tiles {
namespace {

/// Is a cell of a surface one of a flat: no neighbour is lower, and it is neither sea nor on the whole's edge?
bool is_flat(const HeightField& surface, int x, int y, const geom::OpenSides& open, float sea) {
  const float z = surface(x, y);
  if (z <= sea || open.at(x, y, surface.width(), surface.height())) return false;
  for (size_t k = 0; k < 8; ++k) {
    if (surface(x + geom::kFlowDx[k], y + geom::kFlowDy[k]) < z) return false;
  }
  return true;
}

/// The cells of the flat around one of its cells, within [x0, x1) x [y0, y1) of a surface.
struct FlatCells {
  std::vector<int32_t> cells;

  FlatCells(const HeightField& surface, int32_t first, const geom::OpenSides& open, float sea, const Rect& within,
            Grid<uint8_t>& seen) {
    const float z = surface.data()[first];
    cells.push_back(first);
    seen.data()[first] = 1;
    for (size_t next = 0; next < cells.size(); ++next) {
      const int x = cells[next] % surface.width(), y = cells[next] / surface.width();
      for (size_t k = 0; k < 8; ++k) {
        const int nx = x + geom::kFlowDx[k], ny = y + geom::kFlowDy[k];
        if (!within.contains({nx, ny, 1, 1}) || seen(nx, ny) != 0 || surface(nx, ny) != z) continue;
        if (!is_flat(surface, nx, ny, open, sea)) continue;
        seen(nx, ny) = 1;
        cells.push_back(ny * surface.width() + nx);
      }
    }
  }
};

geom::OpenSides open_sides_of(const Rect& rect, const Layout& layout) {
  return {rect.column == 0, rect.row == 0, rect.column + rect.width == layout.width,
          rect.row + rect.height == layout.height};
}

}  // namespace

TileFlats find_flats(const Layout& layout, const GridFrame& frame, int tile, const HeightField& surface, float sea_m) {
  const Rect rect = layout.tile(tile), window = with_reach(rect, Reach::neighbourhood(1), frame);
  const geom::OpenSides open = open_sides_of(window, layout);
  const Rect own{rect.column - window.column, rect.row - window.row, rect.width, rect.height};
  Grid<uint8_t> seen(surface.frame(), uint8_t{0});
  const auto rims = static_cast<size_t>(rim_size(layout, tile));
  TileFlats found{{}, std::vector<int32_t>(rims, -1), std::vector<float>(rims)};
  for (int32_t rim = 0; rim < static_cast<int32_t>(rims); ++rim) {
    const int32_t cell = geom::rim_cell(rim, rect.width, rect.height);
    const int x = own.column + cell % rect.width, y = own.row + cell / rect.width;
    found.height_of_rim[static_cast<size_t>(rim)] = surface(x, y);
    if (seen(x, y) != 0 || !is_flat(surface, x, y, open, sea_m)) continue;
    const FlatCells flat(surface, y * surface.width() + x, open, sea_m, own, seen);
    FlatPart part{{}, {window.column + x, window.row + y}};
    for (const int32_t one : flat.cells) {
      const int cx = one % surface.width() - own.column, cy = one / surface.width() - own.row;
      part.around = united(part.around, {rect.column + cx, rect.row + cy, 1, 1});
      const int32_t number = geom::rim_number(cx, cy, rect.width, rect.height);
      if (number >= 0) found.part_of_rim[static_cast<size_t>(number)] = static_cast<int32_t>(found.parts.size());
    }
    found.parts.push_back(part);
  }
  return found;
}

BorderFlats::BorderFlats(const Layout& layout, const GridFrame& frame, float sea_m, std::vector<TileFlats> tiles)
    : layout_(layout), frame_(frame), sea_m_(sea_m), flats_(tiles.size()), owners_(tiles.size()) {
  std::vector<FlatPart> parts;
  std::vector<int> tile_of;
  for (size_t tile = 0; tile < tiles.size(); ++tile) {
    for (int32_t& part : tiles[tile].part_of_rim)
      if (part >= 0) part += static_cast<int32_t>(parts.size());
    parts.insert(parts.end(), tiles[tile].parts.begin(), tiles[tile].parts.end());
    tile_of.resize(parts.size(), static_cast<int>(tile));
  }
  geom::Groups groups(static_cast<int32_t>(parts.size()));
  for_each_border_pair(layout_, [&](const RimPlace& a, const RimPlace& b) {
    const TileFlats &one = tiles[static_cast<size_t>(a.tile)], &other = tiles[static_cast<size_t>(b.tile)];
    const auto i = static_cast<size_t>(a.rim), k = static_cast<size_t>(b.rim);
    if (one.part_of_rim[i] < 0 || other.part_of_rim[k] < 0 || one.height_of_rim[i] != other.height_of_rim[k]) return;
    const int32_t x = groups.find(one.part_of_rim[i]), y = groups.find(other.part_of_rim[k]);
    if (x != y) groups.join(x, y);
  });
  for (int32_t i = 0; i < static_cast<int32_t>(parts.size()); ++i) {
    if (groups.find(i) != i) continue;
    const int owner = tile_of[static_cast<size_t>(i)];
    Flat flat{{}, parts[static_cast<size_t>(i)].first};
    groups.for_each_member(i, [&](int32_t k) {
      flat.around = united(flat.around, parts[static_cast<size_t>(k)].around);
      owners_[static_cast<size_t>(tile_of[static_cast<size_t>(k)])].insert(owner);
    });
    flats_[static_cast<size_t>(owner)].push_back(flat);
  }
}

std::map<int, FlatCodes> BorderFlats::drain(int tile, const std::function<HeightField(const Rect&)>& read,
                                            const std::function<void(const GridFrame&)>& check,
                                            const RunContext& run) const {
  // Most are small and lie near: their ground is read once.
  const Rect near = with_reach(layout_.tile(tile), Reach::neighbourhood(layout_.size / 4 + 3), frame_);
  Rect common;
  for (const Flat& flat : flats_[static_cast<size_t>(tile)])
    if (near.contains(window_of(flat))) common = united(common, window_of(flat));
  const HeightField ground = common.empty() ? HeightField() : read(common);
  std::map<int, FlatCodes> codes;
  for (const Flat& flat : flats_[static_cast<size_t>(tile)]) {
    run.check_cancelled();
    const Rect window = window_of(flat);
    check(frame_.window(window.column, window.row, window.width, window.height));
    drain_one(flat, common.contains(window) ? inner(ground, common, window) : read(window), run, codes);
  }
  return codes;
}

/// Two cells more around it: whether a neighbour drains is told by its own neighbours.
Rect BorderFlats::window_of(const Flat& flat) const { return with_reach(flat.around, Reach::neighbourhood(2), frame_); }

void BorderFlats::drain_one(const Flat& flat, const HeightField& surface, const RunContext& run,
                            std::map<int, FlatCodes>& codes) const {
  const Rect &around = flat.around, window = window_of(flat);
  const geom::FlowDirections made = geom::flow_directions(surface, sea_m_, run);
  Grid<uint8_t> seen(surface.frame(), uint8_t{0});
  const Rect inside{around.column - window.column, around.row - window.row, around.width, around.height};
  const int32_t from = (flat.first.row - window.row) * window.width + flat.first.column - window.column;
  const FlatCells all(surface, from, open_sides_of(window, layout_), sea_m_, inside, seen);
  for (const int32_t cell : all.cells) {
    const int column = window.column + cell % window.width, row = window.row + cell / window.width;
    const int tile = row / layout_.size * layout_.columns() + column / layout_.size;
    const Rect rect = layout_.tile(tile);
    FlatCodes& of_tile = codes[tile];
    of_tile.cells.push_back((row - rect.row) * rect.width + column - rect.column);
    of_tile.codes.push_back(made.data()[cell]);
  }
}

}  // namespace seamount::tiles
