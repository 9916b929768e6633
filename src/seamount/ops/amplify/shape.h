// What a piece of coarse ground looks like, whichever way it is turned and however high its relief is: by this the
// atoms of a dictionary are learned and found.
//
// A shape is 6 x 6 cells. It is turned and mirrored, one of eight ways, so that it rises eastwards most and southwards
// next; its plane is taken at two fifths, so that crests and hollows count beside the tilt that most of the relief is
// in; what remains is described by sixteen slow cosines, scaled to length one.
#pragma once

#include <array>
#include <cstdint>

namespace seamount::amplify {

inline constexpr int kShape = 6;           ///< cells across
inline constexpr int kFeatures = 16;       ///< numbers that describe it
inline constexpr int kCore = 4;            ///< cells across, in the middle, that an atom gives detail
inline constexpr int kStep = 2;            ///< cells from one shape to the next
inline constexpr int kDetail = 2 * kCore;  ///< fine cells across of an atom's detail

using Features = std::array<float, kFeatures>;

/// Bits: 1 mirrored west to east, 2 north to south, 4 rows and columns exchanged after that.
using Turn = uint8_t;

struct Shape {
  Features features{};    ///< of length one; zeros for level ground
  float relief_m = 0.0F;  ///< what the features were divided by
  Turn turn = 0;          ///< from the ground to the turned shape
};

/// Describes the cells rows[y * stride + x], x and y in [0, 6).
Shape describe_shape(const float* cells, int stride);

/// Where on the ground cell (column, row) of a turned square of `size` cells lies: {column, row}.
constexpr std::array<int, 2> on_ground(Turn turn, int column, int row, int size) {
  int x = (turn & 4) != 0 ? row : column, y = (turn & 4) != 0 ? column : row;
  if ((turn & 1) != 0) x = size - 1 - x;
  if ((turn & 2) != 0) y = size - 1 - y;
  return {x, y};
}

}  // namespace seamount::amplify
