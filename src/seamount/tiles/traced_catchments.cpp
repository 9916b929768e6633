#include <algorithm>
#include <string>
#include <tuple>

#include "seamount/ops/hydrology/outline.h"
#include "seamount/recipe/kinds.h"
#include "seamount/tiles/traced_water.h"

namespace seamount::tiles {
namespace {

struct Catchment {
  Rect around;
  int64_t cells = 0;
  uint64_t most = 0;
  CellPlace mouth;

  void add(const CellPlace& at, uint64_t drained) {
    around = united(around, {at.column, at.row, 1, 1});
    ++cells;
    const bool before = std::tie(at.row, at.column) < std::tie(mouth.row, mouth.column);
    if (drained < most || (drained == most && !before)) return;
    most = drained;
    mouth = at;
  }
};

/// The first `count` of them.
std::vector<Catchment> find(const Drainage& water, const StoredRaster& basins, size_t count, const RunContext& run) {
  std::vector<Catchment> found(count);
  const Layout& layout = water.layout();
  for (int tile = 0; tile < layout.count(); ++tile) {
    run.check_cancelled();
    const Rect rect = layout.tile(tile);
    const recipe::Value numbers = basins.read(rect);
    const Grid<uint64_t> drained = water.cells(tile);
    for (int y = 0; y < rect.height; ++y) {
      for (int x = 0; x < rect.width; ++x) {
        const float number = numbers.get<recipe::kinds::Field>()(x, y);
        if (!(number >= 1.0F) || number > static_cast<float>(count)) continue;
        found[static_cast<size_t>(number) - 1].add({rect.column + x, rect.row + y}, drained(x, y));
      }
    }
    run.report((tile + 1.0) / layout.count());
  }
  return found;
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

}  // namespace

Drawing trace_tiled_catchments(const World& world, const Drainage& water, const StoredRaster& basins,
                               double min_area_m2, const RunContext& run) {
  constexpr double kBytes = 24;  // of a cell of a window
  const GridFrame& whole = water.frame();
  const double cell_m2 = whole.cell_m * whole.cell_m;
  const std::vector<Catchment> found =
      find(water, basins, water.basins_of_at_least(min_area_m2 / cell_m2), run.part(0.0, 0.6));
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

}  // namespace seamount::tiles
