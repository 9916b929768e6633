#include "seamount/ops/erosion/hollows.h"

#include <cmath>
#include <limits>

namespace seamount::erosion {

void settle_hollows(Layers& ground, const Maps& site, const Drainage& drainage, float sea_m, bool fill,
                    ScalarField& lake, ScalarField& level, Ledger& ledger) {
  const auto order = drainage.order();
  float* water = level.data();
  float* depth = lake.data();
  for (const int32_t cell : order) {
    const float height = ground.surface.data()[cell];
    const bool root = drainage.is_root(cell);
    water[cell] = root ? std::max(height, sea_m) : std::max(height, water[drainage.receiver(cell)]);
    depth[cell] = root ? 0.0F : water[cell] - height;
  }
  const auto shallow = static_cast<float>(std::max(kHollow_m, kHollowShare * ground.surface.cell_m()));
  const auto stays = [&](int32_t cell) {
    return !fill || depth[cell] > shallow || value_or_one(site.mask, cell) <= 0.0F;
  };
  // The greatest depth of each lake: downstream to its outlet, and from there back to all of it.
  const auto same_lake = [&](int32_t cell) {
    return !drainage.is_root(cell) && water[cell] == water[drainage.receiver(cell)];
  };
  for (size_t k = order.size(); k-- > 0;) {
    const int32_t cell = order[k];
    if (same_lake(cell)) depth[drainage.receiver(cell)] = std::max(depth[drainage.receiver(cell)], depth[cell]);
  }
  for (const int32_t cell : order) {
    if (drainage.is_root(cell)) depth[cell] = 0.0F;
    if (same_lake(cell)) depth[cell] = std::max(depth[cell], depth[drainage.receiver(cell)]);
  }
  double filled = 0;
  for (const int32_t cell : order) {
    const bool hollow = depth[cell] > 0.0F;
    const float height = ground.surface.data()[cell];
    if (!drainage.is_root(cell) && !stays(cell)) {
      const float base = water[drainage.receiver(cell)];
      if (height < base || (hollow && height == base)) {
        const float rise = std::nextafter(base, std::numeric_limits<float>::max()) - height;
        ground.bury(cell, rise);
        filled += rise;
      }
      water[cell] = std::max(ground.surface.data()[cell], base);
    }
  }
  for (const int32_t cell : order) {
    depth[cell] = drainage.is_root(cell) ? 0.0F : std::max(0.0F, water[cell] - ground.surface.data()[cell]);
  }
  ledger.exported -= filled * ground.surface.cell_m() * ground.surface.cell_m();
}

}  // namespace seamount::erosion
