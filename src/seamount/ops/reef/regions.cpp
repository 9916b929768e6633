#include "seamount/ops/reef/regions.h"

namespace seamount::reef {

std::vector<RegionOfMask> regions_of(const Grid<uint8_t>& mask) {
  const int width = mask.width(), height = mask.height();
  Grid<uint8_t> seen(mask.frame(), 0);
  std::vector<RegionOfMask> regions;
  for (int y0 = 0; y0 < height; ++y0) {
    for (int x0 = 0; x0 < width; ++x0) {
      if (mask(x0, y0) == 0 || seen(x0, y0) != 0) continue;
      RegionOfMask region;
      const auto visit = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= width || y >= height) {
          region.at_edge = true;
          return;
        }
        if (mask(x, y) == 0 || seen(x, y) != 0) return;
        seen(x, y) = 1;
        region.cells.push_back(static_cast<int64_t>(y) * width + x);
      };
      visit(x0, y0);
      for (size_t i = 0; i < region.cells.size(); ++i) {
        const auto x = static_cast<int>(region.cells[i] % width), y = static_cast<int>(region.cells[i] / width);
        visit(x - 1, y), visit(x + 1, y), visit(x, y - 1), visit(x, y + 1);
      }
      regions.push_back(std::move(region));
    }
  }
  return regions;
}

void drop_small(Grid<uint8_t>& mask, double least_m2) {
  const double cell_m2 = mask.cell_m() * mask.cell_m();
  for (const RegionOfMask& region : regions_of(mask)) {
    if (region.at_edge || static_cast<double>(region.cells.size()) * cell_m2 >= least_m2) continue;
    for (const int64_t i : region.cells) mask.cells()[static_cast<size_t>(i)] = 0;
  }
}

}  // namespace seamount::reef
