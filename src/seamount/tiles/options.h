// How a recipe is run in tiles.
#pragma once

#include <cstdint>
#include <string>

#include "seamount/recipe/cache.h"

namespace seamount::tiles {

class Ranks;

struct TileOptions {
  std::string out_folder = "out";
  std::string cache_folder = recipe::Cache::default_folder();  ///< empty: nothing is left for the next run
  int tile = 4096;                                             ///< cells along a tile, >= 1
  uint64_t memory_bytes = 0;  ///< what looks at everything may take so much; 0: half of the machine's, over its ranks
  Ranks* ranks = nullptr;     ///< the processes that run it together; nullptr: this one alone
};

}  // namespace seamount::tiles
