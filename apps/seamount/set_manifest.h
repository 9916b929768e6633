// The manifest of a set of samples: how its lines are written and read.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app.h"
#include "seamount/train/island_set.h"
#include "seamount/train/sample_set.h"
#include "seamount/train/sketch_set.h"
#include "seamount/train/stored_sketches.h"

namespace seamount::app {

/// A set of one sort.
struct SetSort {
  std::string name;                    ///< "islands"
  std::span<const char* const> kinds;  ///< of files
};
const SetSort& island_sets();
const SetSort& sketch_sets();

/// What the samples of a set share.
struct SetOf {
  recipe::Json params = recipe::Json::object();
  uint64_t seed = 0;
};

/// The line of a sample: its files, and what was drawn.
std::string sample_line(const SetSort& sort, uint64_t index, const std::vector<std::string>& digests,
                        recipe::Json drawn);
/// What a line says; throws Error.
train::SampleRecord read_island_line(const std::string& line);
train::SampleRecord read_sketch_line(const std::string& line);

/// What the manifest in the folder says, where there is one. Throws InvalidArgument{flag} for one of another sort.
std::optional<SetOf> find_set(const std::string& folder, const SetSort& sort, const std::string& flag);

// Sets to learn from. Throw InvalidArgument{"--set"} where there is none, Error with the line that cannot be read.
struct StoredSketches {
  int size = 0;
  std::vector<train::StoredSketch> examples;
};
StoredSketches read_stored_sketches(const std::string& folder);
struct StoredIslands {
  train::IslandSetParams params;
  size_t count = 0;
};
StoredIslands read_stored_islands(const std::string& folder);

}  // namespace seamount::app
