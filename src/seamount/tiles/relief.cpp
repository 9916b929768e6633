#include "seamount/tiles/relief.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "seamount/tiles/rank_lists.h"
#include "seamount/tiles/spread.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {

std::optional<Relief> relief_of(const World& world, const OutputOf& raster, const RunContext& run) {
  struct OfTile {
    int32_t tile;
    float lowest, highest;  ///< no number: some cell is unknown
  };
  const Layout layout(world.frame(raster), world.tile_size());
  std::vector<OfTile> mine;
  std::mutex finding;
  constexpr double kBytes = 2 * sizeof(float);  // of a cell
  const int pieces = at_once(kBytes * layout.size * layout.size, world.memory_bytes(), run);
  RunContext quiet = run;
  quiet.progress = nullptr;
  spread(world.ranks(), quiet, layout.count(), pieces, [&](int tile, const RunContext&) {
    const recipe::Value value = world.window(raster, layout.tile(tile));
    const auto* cells = static_cast<const float*>(cells_of(value));
    OfTile one{tile, cells[0], cells[0]};
    for (int64_t i = 0; i < layout.tile(tile).cells(); ++i) {
      if (std::isnan(cells[i])) {
        one.lowest = cells[i];
        break;
      }
      one = {tile, std::min(one.lowest, cells[i]), std::max(one.highest, cells[i])};
    }
    const std::lock_guard lock(finding);
    mine.push_back(one);
    return !std::isnan(one.lowest);
  });
  std::vector<OfTile> all = from_all(world.ranks(), mine);
  if (all.empty()) return std::nullopt;
  std::sort(all.begin(), all.end(), [](const OfTile& a, const OfTile& b) { return a.tile < b.tile; });
  Relief found{all.front().lowest, all.front().highest};
  for (const OfTile& one : all) {
    if (std::isnan(one.lowest)) return std::nullopt;
    found = {std::min(found.lowest, one.lowest), std::max(found.highest, one.highest)};
  }
  return found;
}

}  // namespace seamount::tiles
