// One level of the multigrid that solves transport.h: cells with the rates between them, and how levels hang together.
#pragma once

#include <cstddef>
#include <vector>

#include "seamount/geom/solve/transport.h"

namespace seamount::geom::transport {

/// The equation of a cell, value = right + sum of weight * neighbour's value; 32 bytes, half a cache line.
struct Cell {
  float west, east, north, south;  ///< weights: inflow from that neighbour divided by `diagonal`
  float right;                     ///< source divided by `diagonal`
  float value;
  float diagonal;  ///< all that leaves the cell, 1/s: to neighbours and `loss`; 0: nothing does, value stays 0
  float loss;      ///< what leaves for good: decay, over the border, into cells held at 0
};

/// Cells row by row, with a ring of empty ones around them so that no loop asks for the border.
struct Level {
  Level(int width_, int height_);

  size_t at(int x, int y) const {
    return static_cast<size_t>(y + 1) * static_cast<size_t>(stride) + static_cast<size_t>(x + 1);
  }
  Cell* row(int y) { return &cells[at(0, y)]; }
  const Cell* row(int y) const { return &cells[at(0, y)]; }

  int width, height;
  std::ptrdiff_t stride;
  std::vector<Cell> cells;
  std::vector<float> wall;                      ///< the part of loss that is diffusion to a place outside
  std::vector<float> column_width, row_height;  ///< in cells of the finest level
};

/// The finest level. Rates are multiplied by `scale`, sources by `source_scale` besides.
Level assemble(const Transport& transport, double scale, float source_scale);

/// What coarsen() keeps of the diffusion to a place outside.
constexpr float kFurtherWall = 0.6F;  ///< where unknowns fall to 0 there: a coarse cell's middle lies further away
constexpr float kSameWall = 1.0F;     ///< where they multiply a solution that does

/// Agglomerates 2 x 2 cells. What flows one way adds up; exchange both ways (diffusion) also has further to go.
/// `weights`, one for each of the fine cells, or none: coarse unknowns then multiply these instead of 1, so that they
/// may stand for a solution that varies strongly from cell to cell.
void coarsen(const Level& fine, const float* weights, float wall_share, Level& coarse);

/// Coarse right-hand sides: sums of the fine residuals (`held`: but for those of cells whose value is 0). Coarse values
/// become 0.
void restrict_residuals(const Level& fine, bool held, Level& coarse);

/// Coarse right-hand sides: sums of the fine ones.
void restrict_sources(const Level& fine, Level& coarse);

/// Adds coarse values, times `weights` if given, to the four fine cells of each; a value keeps at least a twentieth.
void add_correction(const Level& coarse, const float* weights, Level& fine);

/// As add_correction, on a level that is itself a correction: values of either sign.
void add_signed_correction(const Level& coarse, Level& fine);

/// Fine values become those of the coarse cell that they lie in.
void prolong(const Level& coarse, Level& fine);

}  // namespace seamount::geom::transport
