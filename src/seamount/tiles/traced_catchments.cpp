#include <map>
#include <string>
#include <tuple>

#include "seamount/ops/hydrology/outline.h"
#include "seamount/recipe/kinds.h"
#include "seamount/tiles/traced_water.h"

namespace seamount::tiles {
namespace {

/// A catchment, or what of it lies in a tile.
struct Catchment {
  Rect around;
  CellPlace mouth;
  int64_t cells = 0;
  uint64_t most = 0;

  void add(const Catchment& other) {
    around = united(around, other.around);
    cells += other.cells;
    const bool before = std::tie(other.mouth.row, other.mouth.column) < std::tie(mouth.row, mouth.column);
    if (other.most < most || (other.most == most && !before)) return;
    most = other.most;
    mouth = other.mouth;
  }
};

/// The tile's parts of the first `count` of them, by their numbers.
void note_parts(const Drainage& water, const StoredRaster& basins, int tile, size_t count, const StoredNotes& notes) {
  const Rect rect = water.layout().tile(tile);
  const recipe::Value numbers = basins.read(rect);
  const Grid<uint64_t> drained = water.cells(tile);
  std::map<int32_t, Catchment> found;
  for (int y = 0; y < rect.height; ++y) {
    for (int x = 0; x < rect.width; ++x) {
      const float number = numbers.get<recipe::kinds::Field>()(x, y);
      if (!(number >= 1.0F) || number > static_cast<float>(count)) continue;
      const int column = rect.column + x, row = rect.row + y;
      found[static_cast<int32_t>(number)].add({{column, row, 1, 1}, {column, row}, 1, drained(x, y)});
    }
  }
  std::vector<int32_t> which;
  std::vector<Catchment> parts;
  for (const auto& [number, part] : found) {
    which.push_back(number);
    parts.push_back(part);
  }
  notes.write(tile, which, parts);
}

std::vector<Catchment> put_together(const Layout& layout, const StoredNotes& notes, size_t count) {
  std::vector<Catchment> all(count), parts;
  std::vector<int32_t> which;
  for (int tile = 0; tile < layout.count(); ++tile) {
    notes.read(tile, which, parts);
    for (size_t i = 0; i < which.size(); ++i) all[static_cast<size_t>(which[i]) - 1].add(parts[i]);
  }
  return all;
}

std::vector<Polygon> trace(const Catchment& one, float number, const StoredRaster& basins, const RunContext& run) {
  const Rect& around = one.around;
  const recipe::Value part = basins.read(around);
  const ScalarField& numbers = part.get<recipe::kinds::Field>();
  const auto belongs = [&](int x, int y) {
    return numbers.contains(x - around.column, y - around.row) && numbers(x - around.column, y - around.row) == number;
  };
  return hydrology::outline_of(hydrology::CellWindow{around.column, around.column + around.width - 1, around.row,
                                                     around.row + around.height - 1},
                               basins.frame(), belongs, run);
}

Drawing trace_all(const World& world, const std::vector<Catchment>& found, const StoredRaster& basins,
                  double min_area_m2, const RunContext& run) {
  constexpr double kBytes = 24;  // of a cell of a window
  const GridFrame& whole = basins.frame();
  Drawing drawing;
  drawing.crs = whole.crs;
  for (size_t i = 0; i < found.size(); ++i) {
    run.check_cancelled();
    const double area_m2 = static_cast<double>(found[i].cells) * whole.cell_m * whole.cell_m;
    if (area_m2 < min_area_m2) break;
    const GridFrame around{found[i].around.width, found[i].around.height};
    world.check_fits(kBytes * static_cast<double>(around.cells()), "a catchment", "is traced as a whole", around);
    drawing.areas.push_back({"catchment " + std::to_string(i + 1),
                             trace(found[i], static_cast<float>(i + 1), basins, run),
                             {{"area_m2", area_m2},
                              {"mouth_x", whole.x(found[i].mouth.column)},
                              {"mouth_y", whole.y(found[i].mouth.row)}}});
  }
  return drawing;
}

}  // namespace

Drawing trace_tiled_catchments(const World& world, const Drainage& water, const StoredRaster& basins,
                               double min_area_m2, const RunContext& run) {
  const GridFrame& whole = water.frame();
  const size_t count = water.basins_of_at_least(min_area_m2 / (whole.cell_m * whole.cell_m));
  const auto notes = water.notes("-catchments");
  water.each_tile(run.part(0.0, 0.6), [&](int tile) {
    if (!notes->has(tile)) note_parts(water, basins, tile, count, *notes);
  });
  Drawing drawing;
  by_first(world.ranks(),
           [&] { drawing = trace_all(world, put_together(water.layout(), *notes, count), basins, min_area_m2, run); });
  remove_together(world.ranks(), std::vector{notes});
  return drawing;
}

}  // namespace seamount::tiles
