// Local steps that hang together, run tile by tile: every step once for a tile, on as many cells more as those after it
// look far. Nothing between them is written down.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "seamount/tiles/local_step.h"
#include "seamount/tiles/world.h"

namespace seamount::tiles {

class Chain {
 public:
  /// The steps that `wanted` needs, as far as they are not there. REQUIRES: outputs of local steps on one frame.
  Chain(World& world, const std::map<size_t, LocalStep>& steps, std::vector<OutputOf> wanted);

  /// Indices of its steps, each after those that it needs.
  const std::vector<size_t>& steps() const { return order_; }

  /// Called with the step and what it says of a tile, from many threads.
  using Say = std::function<void(size_t step, const std::string& line)>;

  /// Makes the tiles that are not on disk yet, as one of the ranks. Throws what steps throw, with the tile's place;
  /// MeetsUnknown on all ranks.
  void run(const Say& say, const RunContext& run);

 private:
  using Values = std::map<OutputOf, recipe::Value>;

  void add(size_t step);
  struct Windows {
    std::map<size_t, Rect> needed, run_on;  ///< by step
  };
  Windows windows_for(int tile) const;
  double bytes_for(int tile) const;
  void make_tile(int tile, const Say& say, const RunContext& run) const;
  recipe::Value input(const OutputOf& from, const Rect& rect, const std::map<size_t, Rect>& needed,
                      const Values& made) const;

  World& world_;
  const std::map<size_t, LocalStep>& all_;
  std::vector<OutputOf> wanted_;
  std::vector<size_t> order_;
  std::map<size_t, size_t> last_use_;  ///< of a step's outputs: the last step in `order_` that reads them
  std::vector<std::shared_ptr<const StoredRaster>> stored_;
};

}  // namespace seamount::tiles
