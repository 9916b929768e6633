#include "seamount/ops/hydrology/catchments.h"

#include <string>
#include <vector>

#include "seamount/ops/hydrology/outline.h"

namespace seamount::hydrology {
namespace {

struct Catchment {
  CellWindow window;
  int64_t cells = 0;
  uint32_t most = 0;
  Vec2 mouth;
};

}  // namespace

Drawing trace_catchments(const ScalarField& basins, const Grid<uint32_t>& cells, double min_area_m2,
                         const RunContext& run) {
  const GridFrame& frame = basins.frame();
  std::vector<Catchment> found;
  for (int y = 0; y < frame.height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < frame.width; ++x) {
      const auto number = static_cast<size_t>(basins(x, y));
      if (number == 0) continue;
      if (found.size() < number) found.resize(number);
      Catchment& one = found[number - 1];
      one.window.add(x, y);
      ++one.cells;
      if (cells(x, y) <= one.most) continue;
      one.most = cells(x, y);
      one.mouth = {frame.x(x), frame.y(y)};
    }
  }
  Drawing drawing;
  drawing.crs = frame.crs;
  for (size_t i = 0; i < found.size(); ++i) {
    run.check_cancelled();
    const double area_m2 = static_cast<double>(found[i].cells) * frame.cell_m * frame.cell_m;
    if (area_m2 < min_area_m2) break;
    const auto number = static_cast<float>(i + 1);
    drawing.areas.push_back({"catchment " + std::to_string(i + 1),
                             outline_of(
                                 found[i].window, frame, [&](int x, int y) { return basins(x, y) == number; }, run),
                             {{"area_m2", area_m2}, {"mouth_x", found[i].mouth.x}, {"mouth_y", found[i].mouth.y}}});
  }
  return drawing;
}

}  // namespace seamount::hydrology
