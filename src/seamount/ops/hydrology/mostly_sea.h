// A word where most of a terrain counts as sea, which of a desert below sea level nobody expects.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

/// Says so, with the parameter that takes it for land. Linear.
inline void say_mostly_sea(const HeightField& terrain, bool sea, const RunContext& run) {
  if (!sea || !run.note) return;
  const auto below = std::count_if(terrain.cells().begin(), terrain.cells().end(), [](float z) { return z <= 0.0F; });
  const auto all = static_cast<int64_t>(terrain.size());
  if (2 * below > all)
    run.say(std::to_string(100 * below / all) +
            " % of the terrain lies at or below 0 m and counts as sea (\"sea\": false takes it for land)");
}

}  // namespace seamount::hydrology
