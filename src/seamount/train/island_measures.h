// How good an island network is on islands that it never saw, and on maps as people paint and scan them (P0 sec. 1.6,
// fig. 1.44 and 1.45): what its model card says.
#pragma once

#include <array>
#include <string>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/ops/learned/network.h"

namespace seamount::train {

/// What is done to a map before the network sees it.
enum class MapDefect { none, blur, specks, noise, jpeg };
inline constexpr std::array<const char*, 5> kMapDefects = {"clean", "blurred", "specks", "noise", "blocks"};

struct IslandMeasures {
  int maps = 0;
  std::array<double, kMapDefects.size()> off{};  ///< mean |dz| as a share of each map's range of heights, by defect
  std::array<double, kMapDefects.size()> off_above{};  ///< of what lies above -60 m, as a share of that range
  double coast_iou = 0;                                ///< of land painted and land made, of maps that have not sunk
};

/// The network is told the range of heights. Of `count` maps of 256 x 256 of samples that training does not use. About
/// 60 ms a map.
IslandMeasures measure_islands(const learned::Network& network, int count, Seed seed, const RunContext& run);

}  // namespace seamount::train
