// One tile of a maximal Poisson-disc sampling (poisson_disc.h): 32 x 32 cells, in each of which there is room for one
// point, and a rim of two cells of the neighbouring tiles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "seamount/base/rng.h"

namespace seamount::geom {

class DiscTile {
 public:
  static constexpr int kCells = 32;               ///< cells to a side
  static constexpr int kRim = 2;                  ///< cells around them whose points matter
  static constexpr int kCellUnits = 4096;         ///< side of a cell in units of the lattice
  static constexpr int64_t kSpacingUnits = 5793;  ///< least distance: the diagonal of a cell, rounded up

  /// A point's offset from the lower corner of its cell.
  struct Offset {
    int16_t x = kNone;
    int16_t y = 0;
    bool empty() const { return x == kNone; }
  };

  /// So far from every cell that a test of distance needs no other test, and near enough for 32 bits.
  static constexpr int16_t kNone = 20000;

  DiscTile() {
    x_.fill(kNone);
    y_.fill(0);
  }

  /// The point in a cell. REQUIRES: -kRim <= x, y < kCells + kRim.
  Offset point(int x, int y) const {
    return {static_cast<int16_t>(x_[index(x, y)]), static_cast<int16_t>(y_[index(x, y)])};
  }
  void set_point(int x, int y, Offset offset) {
    x_[index(x, y)] = offset.x;
    y_[index(x, y)] = offset.y;
  }

  /// Throws `darts` per empty cell of `open` (a bit per cell, rows upwards).
  void sprinkle(const std::array<uint32_t, kCells>& open, double darts, Rng& rng);

  /// Adds points to the cells of `open` until none of their places is left that is kSpacingUnits or further from every
  /// point.
  void fill(const std::array<uint32_t, kCells>& open, Rng& rng);

 private:
  static constexpr int kSide = kCells + 2 * kRim;

  /// A square of a cell that may still have room.
  struct Square {
    uint16_t cell, x, y;
  };

  static size_t index(int x, int y) { return static_cast<size_t>((y + kRim) * kSide + x + kRim); }

  bool is_clear(size_t cell, int x, int y) const;
  bool is_empty(size_t cell) const { return x_[cell] == kNone; }
  void list_empty(const std::array<uint32_t, kCells>& open);
  void throw_darts(int size, size_t darts, Rng& rng);
  void split(int size);

  /// Offsets by cell; a vector of eight that starts in the last row's last cells but two stays within.
  std::array<int32_t, static_cast<size_t>(kSide) * kSide + 8> x_, y_;
  std::vector<Square> squares_, smaller_;
};

}  // namespace seamount::geom
