// A set of island samples on disk, made in any number of runs.
//
//   DIR/manifest.jsonl      line 1: what all samples share; then a line per sample, in order, with everything drawn
//   DIR/000000_labels.png   hue is the region, value the subsidence (geom/grid/painted_labels.h)
//   DIR/000000_height.png   16 bits: code 0 is low_m, 65535 is high_m
//
// A sample's line is written after its files. After a kill, the manifest's complete lines say what is done: the next
// run goes on behind them, and the set is the same bytes as if it had been made at once.
#pragma once

#include <functional>
#include <string>

#include "seamount/train/island_samples.h"

namespace seamount::train {

struct IslandSetOptions {
  std::string folder;
  uint64_t count = 0;
  Seed seed;
  /// One line of the manifest: the set's (nullptr), or a sample's. The caller knows JSON.
  std::function<std::string(const IslandSample*)> line;
};

struct IslandSetReport {
  uint64_t made = 0;     ///< in this run
  uint64_t present = 0;  ///< found finished
};

/// Makes samples until there are `count`. Throws InvalidArgument if the folder holds a set with other parameters or
/// another seed, IoError if it cannot be written, Cancelled (what is finished stays). Parallel over samples.
IslandSetReport make_island_set(const IslandSetParams& params, const IslandSetOptions& options, const RunContext& run);

/// Makes the files of one sample alone, in the set's folder or any other. Heights beyond [low_m, high_m], which samples
/// of a set do not reach, are cut there. Throws IoError, Cancelled.
void make_island_files(const IslandSetParams& params, IslandSample& sample, Seed seed, const std::string& folder,
                       const RunContext& run);

}  // namespace seamount::train
