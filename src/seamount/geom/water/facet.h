// The way of steepest descent between the eight directions of a grid.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/flow.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Where water runs from a cell whose neighbours lie `fall` metres lower (flow.h's order; none or uphill: <= 0): down
/// the steepest of the eight facets around it (Tarboton 1997), to one of that facet's two corners: for a draw that is
/// even in [0, 1) so that the way follows the slope on average, for 0.5 to the nearer one. kPit where none is lower.
inline uint8_t steepest_facet(const std::array<float, 8>& fall, float draw) {
  float steepest = 0.0F, way = 0.0F;  // squared slope, and its direction in eighths of a circle
  for (unsigned straight = 0; straight < 8; straight += 2) {
    const float ahead = fall[straight];
    for (const int turn : {1, -1}) {
      const float across = fall[(straight + 8 + static_cast<unsigned>(turn)) & 7U], aside = across - ahead;
      float square = ahead * std::abs(ahead), turned = 0.0F;
      if (aside > 0.0F && aside < ahead) {
        square += aside * aside, turned = aside / ahead;
      } else if (const float along = 0.5F * across * std::abs(across); along > square) {
        square = along, turned = 1.0F;
      }
      if (square <= steepest) continue;
      steepest = square;
      way = static_cast<float>(straight) + static_cast<float>(turn) * turned;
    }
  }
  return steepest > 0.0F ? static_cast<uint8_t>(static_cast<unsigned>(way + 8.0F + draw) & 7U) : kPit;
}

/// The draw of a cell, its index in a row-major grid: below 1 by so much that a direction (below 16) plus a draw never
/// rounds up to the next.
inline float facet_draw(Seed seed, size_t cell) {
  const auto bits = mix_bits(seed.value + cell * 0x9e3779b97f4a7c15ULL) >> 40;
  return std::min(static_cast<float>(bits) * 0x1p-24F, 1.0F - 0x1p-16F);
}

/// Turns flow_directions() of a filled terrain so that water follows the slope on average and not the eight directions
/// of the grid: each cell draws one of the two corners of its steepest facet that is lower than itself. Flats keep
/// their ways. Parallel, 15 ns per cell.
void turn_to_facets(const HeightField& filled, float sea_level_m, Seed seed, FlowDirections& directions,
                    const RunContext& run);

}  // namespace seamount::geom
