// The steps of a recipe, run in tiles: which are local, which need everything, and in which order.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "seamount/recipe/cache.h"
#include "seamount/recipe/scheduler.h"
#include "seamount/tiles/chain.h"
#include "seamount/tiles/tiled_ways.h"

namespace seamount::tiles {

/// Every rank walks through it in the same way: steps run by windows, and in ways that are spread, by all of them; what
/// gets everything as a whole by rank 0.
class StepsRun {
 public:
  StepsRun(World& world, const TileOptions& options, const RunContext& run);

  /// Makes everything that `wanted` is made from, and `wanted` itself. run.progress gets fractions of it.
  void finish(const std::vector<OutputOf>& wanted);

  std::vector<recipe::StepReport> reports() const;

 private:
  void prepare_all();
  void run_whole(size_t step);
  recipe::Values computed(size_t step);
  bool run_tiled(size_t step);
  void run_way_by_first(const TiledWay& way, size_t step, const RunContext& run);
  std::vector<OutputOf> sources_of(size_t step) const;
  bool load(size_t step);
  void keep(size_t step, const recipe::Values& values);
  /// What a step takes that gets its inputs as a whole. Nothing if that cannot be said before it has read a file.
  struct Need {
    double bytes = 0.0;
    GridFrame frame;
    std::string why;
    bool too_many = false;  ///< cells for a file that is read as a whole, whatever memory there is
  };
  std::optional<Need> need_of(size_t step) const;
  recipe::Values inputs_of(size_t step) const;

  /// Makes those of `wanted` that are not there yet: a chain for each frame.
  void make(const std::vector<OutputOf>& wanted);
  void run_chain(Chain& chain);

  const GridFrame& frame_of(const OutputOf& output) const;
  bool all_there(size_t step) const;
  void say(size_t step, const std::string& line);
  void say_tile_notes();
  void report(double fraction_of_next, size_t steps);

  World& world_;
  TileOptions options_;
  const RunContext& run_;
  recipe::Cache cache_;
  std::set<size_t> forced_;  ///< local steps that have met cells without a value
  std::map<size_t, LocalStep> locals_;
  std::map<size_t, recipe::StepReport> reports_;
  std::map<std::pair<size_t, std::string>, int64_t> tile_notes_;  ///< how many tiles said so
  std::mutex saying_;                                             ///< held while tiles say something
  std::set<size_t> done_;
};

}  // namespace seamount::tiles
