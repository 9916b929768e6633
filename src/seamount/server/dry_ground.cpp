#include "seamount/server/dry_ground.h"

#include <algorithm>

#include "seamount/geom/water/inland.h"
#include "seamount/recipe/kinds.h"

namespace seamount::server {
namespace {

/// Cells that a level leaves out do not count: a dike that is seen in none of them keeps no sea from being sea.
bool is_dry(const HeightField& terrain, const Grid<uint8_t>& hollows, int x, int y, int step) {
  const auto dry = [&](int u, int v) { return hollows.clamped(u, v) != 0 && terrain.clamped(u, v) < 0.0F; };
  if (dry(x, y)) return true;
  if (terrain(x, y) < 0.0F) return false;
  for (int k = 0; k < 9; ++k)
    if (dry(x + (k % 3 - 1) * step, y + (k / 3 - 1) * step)) return true;
  return false;
}

}  // namespace

std::optional<std::string> DryGround::bytes(const std::string& key, const recipe::Value& value,
                                            const RasterWindow& window) {
  if (!value.is<recipe::kinds::Terrain>()) return std::nullopt;
  const HeightField& terrain = value.get<recipe::kinds::Terrain>();
  const Hollows hollows = hollows_of(key, terrain);
  if (hollows->empty()) return std::nullopt;
  const int step = 1 << std::clamp(window.level, 0, 16);
  return mask_bytes(terrain.frame(), window, [&](int x, int y) { return is_dry(terrain, *hollows, x, y, step); });
}

DryGround::Hollows DryGround::hollows_of(const std::string& key, const HeightField& terrain) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const auto& entry) { return entry.first == key; });
  if (found != kept_.end()) return found->second;
  kept_.emplace_back(key, std::make_shared<const Grid<uint8_t>>(geom::find_hollows(terrain, 0.0F, {}, {})));
  if (kept_.size() > kKept) kept_.pop_front();
  return kept_.back().second;
}

}  // namespace seamount::server
