#include "seamount/tiles/relief.h"

#include <algorithm>
#include <cmath>

#include "seamount/tiles/windows.h"

namespace seamount::tiles {

std::optional<Relief> relief_of(const World& world, const OutputOf& raster, const RunContext& run) {
  const Layout layout(world.frame(raster), world.tile_size());
  std::optional<Relief> found;
  for (int tile = 0; tile < layout.count(); ++tile) {
    run.check_cancelled();
    const recipe::Value value = world.window(raster, layout.tile(tile));
    const auto* cells = static_cast<const float*>(cells_of(value));
    for (int64_t i = 0; i < layout.tile(tile).cells(); ++i) {
      if (std::isnan(cells[i])) return std::nullopt;
      if (!found) found = Relief{cells[i], cells[i]};
      *found = {std::min(found->lowest, cells[i]), std::max(found->highest, cells[i])};
    }
  }
  return found;
}

}  // namespace seamount::tiles
