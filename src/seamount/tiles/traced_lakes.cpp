#include <algorithm>
#include <tuple>

#include "seamount/ops/hydrology/lake_areas.h"
#include "seamount/ops/hydrology/outline.h"
#include "seamount/tiles/patches.h"
#include "seamount/tiles/traced_water.h"

namespace seamount::tiles {
namespace {

struct Lake : Patch {
  float level = 0.0F;
};

TilePatches<Lake> lakes_of(const HeightField& bed, const HeightField& level, const Rect& rect) {
  auto lakes = find_patches<Lake>(
      bed.frame(), rect, [&](int32_t cell) { return bed.data()[cell] < level.data()[cell]; },
      [&](int32_t a, int32_t b) { return level.data()[a] == level.data()[b]; });
  for (Lake& lake : lakes.all) lake.level = level(lake.first.column - rect.column, lake.first.row - rect.row);
  return lakes;
}

/// Those of a tile's lakes that are large or may go on beside it, and which of them each rim cell is in.
void note_lakes(const Drainage& water, int tile, double min_cells, const StoredNotes& notes) {
  const Rect rect = water.layout().tile(tile);
  const TilePatches<Lake> found = lakes_of(water.bed(rect), water.level(rect), rect);
  std::vector<Lake> all;
  std::vector<int32_t> kept(found.all.size(), -1);
  const auto keep = [&](int32_t lake) {
    int32_t& number = kept[static_cast<size_t>(lake)];
    if (number >= 0) return number;
    number = static_cast<int32_t>(all.size());
    all.push_back(found.all[static_cast<size_t>(lake)]);
    return number;
  };
  std::vector<int32_t> of_rim = patches_of_rim(found, water.layout(), tile);
  for (int32_t& lake : of_rim) lake = lake >= 0 ? keep(lake) : -1;
  for (size_t lake = 0; lake < found.all.size(); ++lake)
    if (static_cast<double>(found.all[lake].cells) >= min_cells) keep(static_cast<int32_t>(lake));
  notes.write(tile, all, of_rim);
}

/// Lakes of at least so many cells, from the largest on, of equal ones in their order.
std::vector<Lake> all_lakes(const Layout& layout, const StoredNotes& notes, double min_cells) {
  JoinedPatches<Lake> joined;
  std::vector<Lake> own;
  for (int tile = 0; tile < layout.count(); ++tile) {
    std::vector<int32_t> of_rim;
    notes.read(tile, own, of_rim);
    joined.add_tile(own, std::move(of_rim));
  }
  joined.join(layout, [](const Lake& a, const Lake& b) { return a.level == b.level; });
  std::vector<Lake> lakes = joined.all();
  std::erase_if(lakes,
                [&](const Lake& lake) { return lake.cells == 0 || static_cast<double>(lake.cells) < min_cells; });
  std::sort(lakes.begin(), lakes.end(), [](const Lake& a, const Lake& b) {
    return a.cells != b.cells ? a.cells > b.cells
                              : std::tie(a.first.row, a.first.column) < std::tie(b.first.row, b.first.column);
  });
  return lakes;
}

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

Drawing trace_all(const World& world, const Drainage& water, const std::vector<Lake>& lakes, double min_area_m2,
                  const RunContext& run) {
  constexpr double kBytes = 32;  // of a cell of a window
  const GridFrame& whole = water.frame();
  Drawing drawing;
  drawing.crs = whole.crs;
  for (const Lake& lake : lakes) {
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
           [&] { drawing = trace_all(world, water, all_lakes(water.layout(), *notes, min_cells), min_area_m2, run); });
  remove_together(world.ranks(), std::vector{notes});
  return drawing;
}

}  // namespace seamount::tiles
