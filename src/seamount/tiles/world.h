// What is known of a recipe's results while it is run in tiles: small values in memory, large rasters on disk.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "seamount/recipe/plan.h"
#include "seamount/recipe/value.h"
#include "seamount/tiles/options.h"
#include "seamount/tiles/ranks.h"
#include "seamount/tiles/stored_raster.h"

namespace seamount::tiles {

/// An output of a step, by the step's place in the recipe.
using OutputOf = std::pair<size_t, std::string>;

/// Removes what lies on disk, once all ranks are done with it; other runs that share it keep it.
template <class OnDisk>
void remove_together(Ranks& ranks, const std::vector<OnDisk>& all) {
  if (!ranks.first())
    for (const OnDisk& one : all) one->let_go();
  wait_for_all(ranks);
  if (ranks.first())
    for (const OnDisk& one : all) one->remove();
}

class World {
 public:
  /// `folder`: for the tiles, which stay there until forget_tiles(). `plan` and `ranks` must outlive the world.
  World(const recipe::Plan& plan, std::string folder, const TileOptions& options, Ranks& ranks);

  const recipe::Plan& plan() const { return plan_; }
  const recipe::Recipe& recipe() const { return *plan_.recipe; }
  const recipe::Step& step(size_t index) const { return recipe().steps[index]; }
  /// REQUIRES: a source from a step.
  OutputOf output_of(const recipe::Source& source) const { return {plan_.index_of.at(source.step), source.port}; }

  bool has(const OutputOf& output) const { return values_.contains(output) || rasters_.contains(output); }
  /// Where a raster that is there lies.
  const GridFrame& frame(const OutputOf& output) const;
  /// A raster's window, or all of it if it is so large. REQUIRES: has it.
  recipe::Value window(const OutputOf& output, const Rect& rect) const;
  /// All of a value. Throws Error if a raster does not fit into the memory that may be used. REQUIRES: has it.
  recipe::Value whole(const OutputOf& output) const;
  /// The same row by row. REQUIRES: has it, a raster.
  void rows(const OutputOf& output, int first, int count, void* cells) const;

  /// Keeps a value: in memory, or a raster of more than a tile on disk.
  void keep(const OutputOf& output, const recipe::Value& value);
  /// A raster of which some tiles may be on disk already; it is there once keep_tiles() is told so.
  std::shared_ptr<const StoredRaster> on_disk(const OutputOf& output, const GridFrame& frame) const;
  /// The same of a raster that is no output: `name` and kind of one in between.
  std::shared_ptr<const StoredRaster> on_disk_as(const OutputOf& name, const recipe::Kind& kind,
                                                 const GridFrame& frame) const;
  void keep_tiles(const OutputOf& output, std::shared_ptr<const StoredRaster> tiles);
  /// Gives all ranks what rank 0 has kept of a step. Every rank calls it.
  void share_kept(size_t step);

  /// May `bytes` be taken at once for a raster of that size?
  bool fits(double bytes, const GridFrame& frame) const;
  /// Those that are rasters, as wholes? REQUIRES: has them.
  bool fit(const std::vector<OutputOf>& outputs) const;
  /// Throws Error unless `bytes` may be taken at once, with what for and what to do instead.
  void check_fits(double bytes, const std::string& who, const std::string& why, const GridFrame& frame) const;

  double memory_bytes() const { return memory_bytes_; }

  Ranks& ranks() const { return *ranks_; }
  int tile_size() const { return options_.tile; }
  /// The folder of something that lies on disk under a step's key and a name.
  std::string folder_of(const OutputOf& name) const;
  /// Removes the tiles of this run, once all ranks are done with them.
  void forget_tiles() const;

 private:
  const recipe::Plan& plan_;
  std::string folder_;
  TileOptions options_;
  Ranks* ranks_;
  double memory_bytes_;
  std::map<OutputOf, recipe::Value> values_;
  std::map<OutputOf, std::shared_ptr<const StoredRaster>> rasters_;
};

}  // namespace seamount::tiles
