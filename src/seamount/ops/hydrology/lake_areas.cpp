#include "seamount/ops/hydrology/lake_areas.h"

#include <algorithm>
#include <string>
#include <vector>

#include "seamount/ops/hydrology/outline.h"

namespace seamount::hydrology {

LakeArea walk_lake(const HeightField& terrain, const HeightField& filled, int32_t first, Grid<uint8_t>& seen) {
  LakeArea lake;
  lake.level_m = filled.data()[first];
  lake.cells.push_back(first);
  seen.data()[first] = 1;
  const int width = terrain.width();
  for (size_t next = 0; next < lake.cells.size(); ++next) {
    const int32_t cell = lake.cells[next];
    const double depth = lake.level_m - static_cast<double>(terrain.data()[cell]);
    lake.depth_m = std::max(lake.depth_m, depth);
    lake.volume_m += depth;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int x = cell % width + dx, y = cell / width + dy;
      if (!terrain.contains(x, y) || seen(x, y) != 0) continue;
      if (filled(x, y) != filled.data()[first] || !(terrain(x, y) < filled(x, y))) continue;
      seen(x, y) = 1;
      lake.cells.push_back(y * width + x);
    }
  }
  return lake;
}

namespace {

std::vector<Polygon> trace_shore(const LakeArea& lake, const GridFrame& frame, const RunContext& run) {
  CellWindow window;
  std::vector<int32_t> cells = lake.cells;
  std::sort(cells.begin(), cells.end());
  for (const int32_t cell : cells) window.add(cell % frame.width, cell / frame.width);
  const auto belongs = [&](int x, int y) {
    return std::binary_search(cells.begin(), cells.end(), y * frame.width + x);
  };
  return outline_of(window, frame, belongs, run);
}

}  // namespace

NamedArea lake_area(const LakeArea& lake, size_t number, std::vector<Polygon> shore, double cell_m) {
  const double cell_m2 = cell_m * cell_m;
  NamedArea area{"lake " + std::to_string(number),
                 std::move(shore),
                 {{"level_m", lake.level_m},
                  {"depth_m", lake.depth_m},
                  {"area_m2", static_cast<double>(lake.cells.size()) * cell_m2},
                  {"volume_m3", lake.volume_m * cell_m2}}};
  area.attributes.insert(area.attributes.end(), lake.more.begin(), lake.more.end());
  return area;
}

Drawing draw_lakes(std::vector<LakeArea> lakes, const GridFrame& frame, const RunContext& run) {
  std::stable_sort(lakes.begin(), lakes.end(),
                   [](const LakeArea& a, const LakeArea& b) { return a.cells.size() > b.cells.size(); });
  Drawing drawing;
  drawing.crs = frame.crs;
  for (const LakeArea& lake : lakes) {
    run.check_cancelled();
    drawing.areas.push_back(lake_area(lake, drawing.areas.size() + 1, trace_shore(lake, frame, run), frame.cell_m));
  }
  return drawing;
}

Drawing trace_lakes(const HeightField& terrain, const HeightField& filled, double min_area_m2, const RunContext& run) {
  const GridFrame& frame = terrain.frame();
  Grid<uint8_t> seen(frame, 0);
  std::vector<LakeArea> lakes;
  for (int y = 0; y < frame.height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < frame.width; ++x) {
      if (seen(x, y) != 0 || !(terrain(x, y) < filled(x, y))) continue;
      LakeArea lake = walk_lake(terrain, filled, y * frame.width + x, seen);
      if (static_cast<double>(lake.cells.size()) * frame.cell_m * frame.cell_m >= min_area_m2)
        lakes.push_back(std::move(lake));
    }
  }
  return draw_lakes(std::move(lakes), frame, run);
}

}  // namespace seamount::hydrology
