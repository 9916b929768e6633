// Operators that look at everything and yet can be run on rasters that do not fit into memory, each in a way of its
// own.
#pragma once

#include <optional>
#include <string>

#include "seamount/tiles/world.h"

namespace seamount::tiles {

/// Thrown where the raster itself shows that only the whole can tell.
struct NeedsWhole {
  std::string why;
};

struct TiledWay {
  const char* op;
  /// Why a step cannot be run so, for messages; empty if it can.
  std::string (*refusal)(const recipe::Step& step, const recipe::PlannedStep& planned);
  /// Makes the outputs that are read and keeps them. What it reads from other steps is there. Throws NeedsWhole.
  void (*run)(World& world, size_t step, const RunContext& run);
  /// Every rank runs it, and throws NeedsWhole where the others do; else rank 0 runs it alone.
  bool spread = false;
  /// Of what has no raster among its inputs: the size of what it reads from files, before it has read them.
  std::optional<GridFrame> (*size)(const World& world, size_t step) = nullptr;
};

/// nullptr: there is none.
const TiledWay* find_tiled_way(const recipe::Step& step);

}  // namespace seamount::tiles
