// The files of a sample of islands (island_samples.h), for a set of samples on disk (sample_set.h):
//
//   000000_labels.png   hue is the region, value the subsidence (geom/grid/painted_labels.h)
//   000000_height.png   16 bits: code 0 is low_m, 65535 is high_m
#pragma once

#include <string>
#include <vector>

#include "seamount/train/island_samples.h"

namespace seamount::train {

inline constexpr const char* kIslandFiles[] = {"labels", "height"};

/// Writes the files of a sample, completing it (make_island_pair()), and returns their digests. Heights beyond [low_m,
/// high_m], which samples of a set do not reach, are cut there. Throws WriteError, Cancelled.
std::vector<std::string> make_island_files(const IslandSetParams& params, IslandSample& sample, Seed seed,
                                           const std::string& folder, const RunContext& run);

}  // namespace seamount::train
