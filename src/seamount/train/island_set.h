// A set of island samples on disk, made in any number of runs.
//
//   DIR/manifest.jsonl      line 1: what all samples share; then a line per sample, in order, with everything drawn
//   DIR/000000_labels.png   hue is the region, value the subsidence (io/label_image.h)
//   DIR/000000_height.png   16 bits: code 0 is low_m, 65535 is high_m
//
// A sample's line is written after its files and holds their digests. After a kill, the manifest's complete lines say
// what is done: the next run goes on behind them, and the set is the same bytes as if it had been made at once. It
// believes no line and no file unseen: each is read, missing files are made again, others are never overwritten.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "seamount/train/island_samples.h"

namespace seamount::train {

/// Digests of a sample's two files (io/file_digest.h), as hex digits.
struct SampleFiles {
  std::string labels_digest, height_digest;
  bool operator==(const SampleFiles&) const = default;
};

/// What a line of the manifest says of its sample.
struct SampleRecord {
  uint64_t index = 0;
  SampleFiles files;
};

struct IslandSetOptions {
  std::string folder;
  uint64_t count = 0;
  Seed seed;
  /// The manifest's lines: the set's, and a sample's to and from text. The caller knows JSON. read() throws Error if a
  /// line is not what write() makes.
  std::string header;
  std::function<std::string(const IslandSample&, const SampleFiles&)> write;
  std::function<SampleRecord(const std::string& line)> read;
};

struct IslandSetReport {
  uint64_t made = 0;     ///< in this run
  uint64_t present = 0;  ///< found finished
};

/// The first line of the manifest in a folder, where there is one. Throws IoError.
std::optional<std::string> find_set_header(const std::string& folder);

/// Throws InvalidArgument{"--out"} if the folder holds a set with another first line.
void check_set_header(const std::string& folder, const std::string& header);

/// Makes samples until there are `count`, and those whose files are missing. Throws InvalidArgument if the folder holds
/// a set with other parameters or another seed, or samples without a manifest; IoError if a line cannot be read or a
/// file is not the one that its line describes (remedy in the message); WriteError; Cancelled (what is finished stays).
/// Parallel over samples.
IslandSetReport make_island_set(const IslandSetParams& params, const IslandSetOptions& options, const RunContext& run);

/// Makes the files of one sample alone, in the set's folder or any other. Heights beyond [low_m, high_m], which samples
/// of a set do not reach, are cut there. Throws WriteError, Cancelled.
SampleFiles make_island_files(const IslandSetParams& params, IslandSample& sample, Seed seed, const std::string& folder,
                              const RunContext& run);

}  // namespace seamount::train
