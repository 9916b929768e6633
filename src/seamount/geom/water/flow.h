// Where water runs on a raster: depressions filled, one receiver per cell (D8), and what gathers along the way.
//
//   filled = fill_depressions(terrain, sea, run);
//   directions = flow_directions(filled, sea, run);
//   cells = flow_accumulation(directions, run);
//
// Cells on the grid's border drain off the map. Cells at or below the sea level are open water, where flow ends; pass
// kNoSea for a world without one. Heights must be finite; at most 2^31 - 1 cells.
//
// Filling: the water level of a depression is the lowest pass on its way out, as priority-flood (Barnes, Lehman and
// Mulla 2014a) finds it cell by cell. We find it basin by basin (Cordonnier, Bovy and Braun 2019): basins of steepest
// descent, the lowest pass between neighbours, a minimum spanning tree over the few passes. Same result, parallel, no
// heap of cells. Flats: Garbrecht and Martz 1997 in the linear form of Barnes, Lehman and Mulla 2014b: away from higher
// ground and, twice as strongly, towards the outlet.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"

namespace seamount::geom {

/// Where a cell's water goes: 0 to 7 is the neighbour counter-clockwise from east, then the two ends of flow.
using FlowDirections = Grid<uint8_t>;
inline constexpr uint8_t kOutlet = 8;  ///< leaves the map, or is open water
inline constexpr uint8_t kPit = 9;     ///< stays: the lowest place of a depression that was not filled

/// Steps in columns and rows (row 0 is north) of the directions 0 to 7.
inline constexpr std::array<int, 8> kFlowDx = {1, 1, 0, -1, -1, -1, 0, 1};
inline constexpr std::array<int, 8> kFlowDy = {0, -1, -1, -1, 0, 1, 1, 1};
/// Length of a step in cells.
inline constexpr std::array<float, 8> kFlowLength = {1.0F, 1.41421356F, 1.0F, 1.41421356F,
                                                     1.0F, 1.41421356F, 1.0F, 1.41421356F};

inline constexpr float kNoSea = -std::numeric_limits<float>::infinity();

/// Steps in a row-major array of the directions 0 to 7.
constexpr std::array<int64_t, 8> flow_steps(int width) {
  std::array<int64_t, 8> steps{};
  for (size_t k = 0; k < 8; ++k) steps[k] = static_cast<int64_t>(kFlowDy[k]) * width + kFlowDx[k];
  return steps;
}

/// Steepest descent; of equally steep neighbours the first. Flats drain to their outlets. A depression keeps one kPit,
/// to which the rest of its floor drains. Parallel but for flats; linear; 5 bytes per cell at most.
FlowDirections flow_directions(const HeightField& terrain, float sea_level_m, const RunContext& run);

/// The lowest surface over the terrain from which every cell drains without climbing: max(terrain, water level), so
/// lakes are flat. Parallel but for flats and passes; linear in the cells and n log n in the passes; 9 bytes per cell
/// and 16 per pass besides the terrain.
HeightField fill_depressions(const HeightField& terrain, float sea_level_m, const RunContext& run);

/// Fills only what is shallower than min_depth_m between its lowest ground and the pass where it overflows; of two
/// depressions that meet, the one with the higher ground is measured to where they meet. Cost as above.
HeightField fill_shallow_depressions(const HeightField& terrain, float sea_level_m, float min_depth_m,
                                     const RunContext& run);

/// The other way out of a depression: the ground stays and water runs from the pit to the lowest pass as if there were
/// a gorge. Turns the directions of the way from pass to pit round, so that flow may climb there and nowhere else. Only
/// passes below `highest_pass_m` are ways; depressions that are joined without a way to an outlet keep the pit of the
/// lowest. REQUIRES: directions of `terrain`. As fill_depressions().
void route_through_pits(const HeightField& terrain, FlowDirections& directions, float highest_pass_m,
                        const RunContext& run);

/// Raises every cell that is not above its receiver by one step of float arithmetic above it, so that water descends
/// strictly along `directions`, which must be of `filled` and without pits. Linear.
void tilt_flats(HeightField& filled, const FlowDirections& directions, const RunContext& run);

/// Cells whose water passes through each cell, itself included. The sum over all outlets and pits is the number of
/// cells. Parallel, linear; 5 bytes per cell.
Grid<uint32_t> flow_accumulation(const FlowDirections& directions, const RunContext& run);

/// The same with the water that each cell adds: weights of its own. Sums are rounded once per cell.
ScalarField flow_accumulation(const FlowDirections& directions, const ScalarField& weights, const RunContext& run);

/// Cells that are -1 get the label of the first cell downstream that is not. REQUIRES: outlets and pits are labelled.
/// Parallel, linear.
void label_upstream(const FlowDirections& directions, Grid<int32_t>& labels, const RunContext& run);

/// Number of pits: 0 on a surface that drains.
int64_t count_pits(const FlowDirections& directions);

}  // namespace seamount::geom
