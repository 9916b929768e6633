// A set of samples on disk, made in any number of runs, whatever they show.
//
//   DIR/manifest.jsonl     line 1: what all samples share; then a line per sample, in order, with everything drawn
//   DIR/000000_KIND.png    the pictures of sample 0, one of each kind
//
// A sample's line is written after its files and holds their digests. After a kill, the manifest's complete lines say
// what is done: the next run goes on behind them, and the set is the same bytes as if it had been made at once. It
// believes no line and no file unseen: each is read, missing files are made again, others are never overwritten.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"

namespace seamount::train {

/// What a line of the manifest says of its sample.
struct SampleRecord {
  uint64_t index = 0;
  std::vector<std::string> digests;  ///< of its files (io/file_digest.h), as hex digits, in the order of the kinds
};

struct SampleSet {
  std::string folder;
  uint64_t count = 0;
  std::vector<std::string> kinds;  ///< "labels", "height"
  std::string header;              ///< the manifest's first line
  /// Writes the files of a sample, a function of its index alone, and returns its line. Called by several threads.
  std::function<std::string(uint64_t index, const RunContext& run)> make;
  /// What such a line says; throws Error if it is not what make() returns.
  std::function<SampleRecord(const std::string& line)> read;
};

struct SampleSetReport {
  uint64_t made = 0;     ///< in this run
  uint64_t present = 0;  ///< found finished
};

/// "DIR/000012_height.png".
std::string sample_file(const std::string& folder, uint64_t index, const std::string& kind);

/// The first line of the manifest in a folder, where there is one. Throws IoError.
std::optional<std::string> find_set_header(const std::string& folder);

/// Throws InvalidArgument{"--out"} if the folder holds a set with another first line.
void check_set_header(const std::string& folder, const std::string& header);

/// Makes samples until there are `count`, and those whose files are missing. Throws InvalidArgument if the folder holds
/// a set with another header, or samples without a manifest; IoError if a line cannot be read or a file is not the one
/// that its line describes (remedy in the message); WriteError; Cancelled (what is finished stays). Parallel over
/// samples.
SampleSetReport make_sample_set(const SampleSet& set, const RunContext& run);

}  // namespace seamount::train
