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

BorderFlats::BorderFlats(const Layout& layout, const GridFrame& frame, float sea_m, const RunContext& run)
    : layout_(layout), frame_(frame), sea_m_(sea_m), run_(run) {}

void BorderFlats::look_at(int tile, const HeightField& surface) {
  const Rect rect = layout_.tile(tile), window = with_reach(rect, Reach::neighbourhood(1), frame_);
  const geom::OpenSides open = open_sides_of(window, layout_);
  const Rect own{rect.column - window.column, rect.row - window.row, rect.width, rect.height};
  Grid<uint8_t> seen(surface.frame(), uint8_t{0});
  std::vector<int32_t> parts(static_cast<size_t>(rim_size(layout_, tile)), -1);
  std::vector<float> heights(parts.size());
  for (int32_t rim = 0; rim < static_cast<int32_t>(parts.size()); ++rim) {
    const int32_t cell = geom::rim_cell(rim, rect.width, rect.height);
    const int x = own.column + cell % rect.width, y = own.row + cell / rect.width;
    heights[static_cast<size_t>(rim)] = surface(x, y);
    if (seen(x, y) != 0 || !is_flat(surface, x, y, open, sea_m_)) continue;
    const FlatCells flat(surface, y * surface.width() + x, open, sea_m_, own, seen);
    Part part{{}, {window.column + x, window.row + y}};
    for (const int32_t one : flat.cells) {
      const int cx = one % surface.width() - own.column, cy = one / surface.width() - own.row;
      part.around = united(part.around, {rect.column + cx, rect.row + cy, 1, 1});
      const int32_t number = geom::rim_number(cx, cy, rect.width, rect.height);
      if (number >= 0) parts[static_cast<size_t>(number)] = static_cast<int32_t>(parts_.size());
    }
    parts_.push_back(part);
  }
  part_of_rim_.push_back(std::move(parts));
  height_of_rim_.push_back(std::move(heights));
}

void BorderFlats::drain(const std::function<HeightField(const Rect&)>& read,
                        const std::function<void(const GridFrame&)>& check) {
  geom::Groups flats(static_cast<int32_t>(parts_.size()));
  for_each_border_pair(layout_, [&](const RimPlace& a, const RimPlace& b) {
    const auto part = [&](const RimPlace& p) {
      return part_of_rim_[static_cast<size_t>(p.tile)][static_cast<size_t>(p.rim)];
    };
    const auto height = [&](const RimPlace& p) {
      return height_of_rim_[static_cast<size_t>(p.tile)][static_cast<size_t>(p.rim)];
    };
    if (part(a) < 0 || part(b) < 0 || height(a) != height(b)) return;
    const int32_t x = flats.find(part(a)), y = flats.find(part(b));
    if (x != y) flats.join(x, y);
  });
  for (int32_t i = 0; i < static_cast<int32_t>(parts_.size()); ++i) {
    run_.check_cancelled();
    if (flats.find(i) != i) continue;
    Rect around;
    flats.for_each_member(i, [&](int32_t k) { around = united(around, parts_[static_cast<size_t>(k)].around); });
    drain_one(around, parts_[static_cast<size_t>(i)].first, read, check);
  }
}

void BorderFlats::drain_one(const Rect& around, const CellPlace& first,
                            const std::function<HeightField(const Rect&)>& read,
                            const std::function<void(const GridFrame&)>& check) {
  // Two cells more: whether a neighbour drains is told by its own neighbours.
  const Rect window = with_reach(around, Reach::neighbourhood(2), frame_);
  check(frame_.window(window.column, window.row, window.width, window.height));
  const HeightField surface = read(window);
  const geom::FlowDirections codes = geom::flow_directions(surface, sea_m_, run_);
  Grid<uint8_t> seen(surface.frame(), uint8_t{0});
  const Rect inside{around.column - window.column, around.row - window.row, around.width, around.height};
  const int32_t from = (first.row - window.row) * window.width + first.column - window.column;
  const FlatCells flat(surface, from, open_sides_of(window, layout_), sea_m_, inside, seen);
  for (const int32_t cell : flat.cells) {
    const int column = window.column + cell % window.width, row = window.row + cell / window.width;
    const int tile = row / layout_.size * layout_.columns() + column / layout_.size;
    const Rect rect = layout_.tile(tile);
    codes_[tile].push_back({(row - rect.row) * rect.width + column - rect.column, codes.data()[cell]});
  }
}

void BorderFlats::put(int tile, geom::FlowDirections& codes) const {
  const auto found = codes_.find(tile);
  if (found == codes_.end()) return;
  for (const Code& one : found->second) codes.data()[one.cell] = one.code;
}

}  // namespace seamount::tiles
