#include <algorithm>
#include <array>
#include <tuple>

#include "seamount/geom/water/groups.h"
#include "seamount/ops/hydrology/lake_areas.h"
#include "seamount/ops/hydrology/outline.h"
#include "seamount/tiles/traced_water.h"

namespace seamount::tiles {
namespace {

constexpr std::array<std::array<int, 2>, 4> kSides = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// A lake, or what of it lies in a tile.
struct Lake {
  Rect around;
  CellPlace first;  ///< row by row
  int64_t cells = 0;
  float level = 0.0F;

  void add(int column, int row) {
    around = united(around, {column, row, 1, 1});
    ++cells;
  }
  void add(const Lake& other) {
    around = united(around, other.around);
    cells += other.cells;
    if (std::tie(other.first.row, other.first.column) < std::tie(first.row, first.column)) first = other.first;
  }
};

/// The lakes of a tile, and which of them each cell is in; -1: none.
struct TileLakes {
  Grid<int32_t> of;
  std::vector<Lake> all;
};

TileLakes lakes_of(const HeightField& bed, const HeightField& level, const Rect& rect) {
  TileLakes lakes{Grid<int32_t>(bed.frame(), -1), {}};
  std::vector<int32_t> left;
  for (int32_t first = 0; first < static_cast<int32_t>(bed.size()); ++first) {
    if (lakes.of.data()[first] >= 0 || !(bed.data()[first] < level.data()[first])) continue;
    const auto number = static_cast<int32_t>(lakes.all.size());
    Lake lake;
    lake.first = {rect.column + first % rect.width, rect.row + first / rect.width};
    lake.level = level.data()[first];
    lakes.of.data()[first] = number;
    left.assign(1, first);
    while (!left.empty()) {
      const int x = left.back() % rect.width, y = left.back() / rect.width;
      left.pop_back();
      lake.add(rect.column + x, rect.row + y);
      for (const auto& [dx, dy] : kSides) {
        if (!bed.contains(x + dx, y + dy) || lakes.of(x + dx, y + dy) >= 0) continue;
        if (level(x + dx, y + dy) != lake.level || !(bed(x + dx, y + dy) < lake.level)) continue;
        lakes.of(x + dx, y + dy) = number;
        left.push_back((y + dy) * rect.width + x + dx);
      }
    }
    lakes.all.push_back(lake);
  }
  return lakes;
}

/// Those of a tile's lakes that are large or may go on beside it, and which of them each rim cell is in.
void note_lakes(const Drainage& water, int tile, double min_cells, const StoredNotes& notes) {
  const Rect rect = water.layout().tile(tile);
  const TileLakes found = lakes_of(water.bed(rect), water.level(rect), rect);
  std::vector<Lake> all;
  std::vector<int32_t> of_rim, kept(found.all.size(), -1);
  const auto keep = [&](int32_t lake) {
    int32_t& number = kept[static_cast<size_t>(lake)];
    if (number >= 0) return number;
    number = static_cast<int32_t>(all.size());
    all.push_back(found.all[static_cast<size_t>(lake)]);
    return number;
  };
  for (int32_t rim = 0; rim < rim_size(water.layout(), tile); ++rim) {
    const int32_t lake = found.of.data()[geom::rim_cell(rim, rect.width, rect.height)];
    of_rim.push_back(lake >= 0 ? keep(lake) : -1);
  }
  for (size_t lake = 0; lake < found.all.size(); ++lake)
    if (static_cast<double>(found.all[lake].cells) >= min_cells) keep(static_cast<int32_t>(lake));
  notes.write(tile, all, of_rim);
}

/// Lakes of at least so many cells, from the largest on, of equal ones in their order.
class Lakes {
 public:
  Lakes(const Layout& layout, const StoredNotes& notes, double min_cells) : layout_(layout) {
    std::vector<Lake> own;
    for (int tile = 0; tile < layout_.count(); ++tile) {
      std::vector<int32_t> of_rim;
      notes.read(tile, own, of_rim);
      for (int32_t& lake : of_rim)
        if (lake >= 0) lake += static_cast<int32_t>(all_.size());
      all_.insert(all_.end(), own.begin(), own.end());
      of_rim_.push_back(std::move(of_rim));
    }
    join();
    std::erase_if(all_,
                  [&](const Lake& lake) { return lake.cells == 0 || static_cast<double>(lake.cells) < min_cells; });
    std::sort(all_.begin(), all_.end(), [](const Lake& a, const Lake& b) {
      return a.cells != b.cells ? a.cells > b.cells
                                : std::tie(a.first.row, a.first.column) < std::tie(b.first.row, b.first.column);
    });
  }
  const std::vector<Lake>& all() const { return all_; }

 private:
  void join() {
    geom::Groups groups(static_cast<int32_t>(all_.size()));
    for_each_border_pair(layout_, [&](const RimPlace& a, const RimPlace& b) {
      const CellPlace one = cell_place(layout_, a), other = cell_place(layout_, b);
      if (one.column != other.column && one.row != other.row) return;  // by sides only
      const int32_t x = of_rim_[static_cast<size_t>(a.tile)][static_cast<size_t>(a.rim)],
                    y = of_rim_[static_cast<size_t>(b.tile)][static_cast<size_t>(b.rim)];
      if (x < 0 || y < 0 || all_[static_cast<size_t>(x)].level != all_[static_cast<size_t>(y)].level) return;
      const int32_t low = std::min(groups.find(x), groups.find(y)), high = std::max(groups.find(x), groups.find(y));
      if (low == high) return;
      groups.join(low, high);
      all_[static_cast<size_t>(low)].add(all_[static_cast<size_t>(high)]);
      all_[static_cast<size_t>(high)].cells = 0;
    });
  }

  const Layout& layout_;
  std::vector<Lake> all_;
  std::vector<std::vector<int32_t>> of_rim_;  ///< by tile and rim number
};

NamedArea trace(const Lake& lake, size_t number, const Drainage& water, const GridFrame& whole, const RunContext& run) {
  const Rect& around = lake.around;
  const HeightField bed = water.bed(around), level = water.level(around);
  Grid<uint8_t> seen(bed.frame(), 0);
  const int32_t first = (lake.first.row - around.row) * around.width + lake.first.column - around.column;
  const hydrology::LakeArea walked = hydrology::walk_lake(bed, level, first, seen);
  const hydrology::CellWindow window{around.column, around.column + around.width - 1, around.row,
                                     around.row + around.height - 1};
  const auto belongs = [&](int x, int y) {
    return bed.contains(x - around.column, y - around.row) && seen(x - around.column, y - around.row) != 0;
  };
  return hydrology::lake_area(walked, number, hydrology::outline_of(window, whole, belongs, run), whole.cell_m);
}

Drawing trace_all(const World& world, const Drainage& water, const Lakes& lakes, double min_area_m2,
                  const RunContext& run) {
  constexpr double kBytes = 32;  // of a cell of a window
  const GridFrame& whole = water.frame();
  Drawing drawing;
  drawing.crs = whole.crs;
  for (const Lake& lake : lakes.all()) {
    run.check_cancelled();
    if (static_cast<double>(lake.cells) * whole.cell_m * whole.cell_m < min_area_m2) continue;
    const GridFrame around{lake.around.width, lake.around.height};
    world.check_fits(kBytes * static_cast<double>(around.cells()), "a lake", "is traced as a whole", around);
    drawing.areas.push_back(trace(lake, drawing.areas.size() + 1, water, whole, run));
  }
  return drawing;
}

}  // namespace

Drawing trace_tiled_lakes(const World& world, const Drainage& water, double min_area_m2, const RunContext& run) {
  constexpr double kRounding = 0.999;
  const double cell_m = water.frame().cell_m, min_cells = kRounding * min_area_m2 / cell_m / cell_m;
  const auto notes = water.notes("-lakes");
  water.each_tile(run.part(0.0, 0.7), [&](int tile) {
    if (!notes->has(tile)) note_lakes(water, tile, min_cells, *notes);
  });
  Drawing drawing;
  by_first(world.ranks(),
           [&] { drawing = trace_all(world, water, Lakes(water.layout(), *notes, min_cells), min_area_m2, run); });
  remove_together(world.ranks(), std::vector{notes});
  return drawing;
}

}  // namespace seamount::tiles
