#include "seamount/geom/grid/disc_tile.h"

#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

constexpr int kRow = DiscTile::kCells + 2 * DiscTile::kRim;
constexpr int kUnits = DiscTile::kCellUnits;
constexpr int kSpacingSquared = static_cast<int>(DiscTile::kSpacingUnits * DiscTile::kSpacingUnits);

/// Cells in a vector of a row; the two before a cell and the two after it would do.
constexpr int kLanes = 8;

/// A cell seen from another one.
struct Neighbour {
  int dx, dy;
};

/// Cells whose points can be nearer than the spacing to points of the cell at (0, 0), nearest first: they decide most
/// tests. The four cells at (+-2, +-2) are too far.
constexpr std::array<Neighbour, 20> kNeighbours = {{{1, 0},   {-1, 0},  {0, 1},  {0, -1}, {1, 1},  {-1, 1}, {1, -1},
                                                    {-1, -1}, {2, 0},   {-2, 0}, {0, 2},  {0, -2}, {2, 1},  {2, -1},
                                                    {-2, 1},  {-2, -1}, {1, 2},  {1, -2}, {-1, 2}, {-1, -2}}};

/// Which quarters of a square, with its lower corner at (x, y) of a cell and quarters of side `half`, does no disc
/// cover whole? Bit qx + 2 qy. px, py: offsets of the points, at the cell two rows below it and two columns before it.
SEAMOUNT_VECTORISED int open_quarters(const int32_t* px, const int32_t* py, int x, int y, int half) {
  int32_t best[4][kLanes];
  for (int i = 0; i < kLanes; ++i) best[0][i] = best[1][i] = best[2][i] = best[3][i] = kSpacingSquared;
  for (int row = 0; row < 5; ++row, px += kRow, py += kRow) {
    for (int i = 0; i < kLanes; ++i) {
      const int32_t dx = px[i] + (i - 2) * kUnits - x;
      const int32_t dy = py[i] + (row - 2) * kUnits - y;
      // To the further side of the western, eastern, southern and northern quarters.
      const int32_t w = dx > half - 1 - dx ? dx : half - 1 - dx;
      const int32_t e = dx - half > 2 * half - 1 - dx ? dx - half : 2 * half - 1 - dx;
      const int32_t s = dy > half - 1 - dy ? dy : half - 1 - dy;
      const int32_t n = dy - half > 2 * half - 1 - dy ? dy - half : 2 * half - 1 - dy;
      const int32_t ww = w * w, ee = e * e, ss = s * s, nn = n * n;
      best[0][i] = ww + ss < best[0][i] ? ww + ss : best[0][i];
      best[1][i] = ee + ss < best[1][i] ? ee + ss : best[1][i];
      best[2][i] = ww + nn < best[2][i] ? ww + nn : best[2][i];
      best[3][i] = ee + nn < best[3][i] ? ee + nn : best[3][i];
    }
  }
  int open = 0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    int32_t least = kSpacingSquared;
    for (int i = 0; i < kLanes; ++i) least = best[quarter][i] < least ? best[quarter][i] : least;
    if (least == kSpacingSquared) open |= 1 << quarter;
  }
  return open;
}

}  // namespace

bool DiscTile::is_clear(size_t cell, int x, int y) const {
  for (const Neighbour n : kNeighbours) {
    const size_t other = cell + static_cast<size_t>(n.dy * kSide + n.dx);
    const int dx = n.dx * kCellUnits + x_[other] - x;
    const int dy = n.dy * kCellUnits + y_[other] - y;
    if (dx * dx + dy * dy < kSpacingSquared) return false;
  }
  return true;
}

/// Each dart at a random square: uniform over all that is left, as they are of one size.
void DiscTile::throw_darts(int size, size_t darts, Rng& rng) {
  const auto mask = static_cast<uint64_t>(size - 1);
  for (; darts > 0 && !squares_.empty(); --darts) {
    const uint64_t bits = rng.bits();
    Square& square = squares_[((bits >> 32) * squares_.size()) >> 32];
    const size_t cell = square.cell;
    if (is_empty(cell)) {
      const int x = square.x + static_cast<int>(bits & mask);
      const int y = square.y + static_cast<int>((bits >> 12) & mask);
      if (!is_clear(cell, x, y)) continue;
      x_[cell] = x;
      y_[cell] = y;
    }
    square = squares_.back();
    squares_.pop_back();
  }
}

/// Drops what a disc covers whole.
void DiscTile::split(int size) {
  const int half = size / 2;
  smaller_.clear();
  for (const Square square : squares_) {
    const size_t cell = square.cell;
    if (!is_empty(cell)) continue;
    const size_t corner = cell - static_cast<size_t>(kRim * kSide + kRim);
    const int open = open_quarters(&x_[corner], &y_[corner], square.x, square.y, half);
    for (int quarter = 0; quarter < 4; ++quarter) {
      if ((open >> quarter & 1) == 0) continue;
      smaller_.push_back({square.cell, static_cast<uint16_t>(square.x + (quarter & 1) * half),
                          static_cast<uint16_t>(square.y + (quarter >> 1) * half)});
    }
  }
  squares_.swap(smaller_);
}

void DiscTile::list_empty(const std::array<uint32_t, kCells>& open) {
  squares_.clear();
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      if ((open[static_cast<size_t>(y)] >> x & 1U) == 0 || !is_empty(index(x, y))) continue;
      squares_.push_back({static_cast<uint16_t>(index(x, y)), 0, 0});
    }
  }
}

void DiscTile::sprinkle(const std::array<uint32_t, kCells>& open, double darts, Rng& rng) {
  list_empty(open);
  throw_darts(kCellUnits, static_cast<size_t>(darts * static_cast<double>(squares_.size())), rng);
}

void DiscTile::fill(const std::array<uint32_t, kCells>& open, Rng& rng) {
  list_empty(open);
  for (int size = kCellUnits; size > 1 && !squares_.empty(); size /= 2) {
    throw_darts(size, squares_.size(), rng);
    split(size);
  }
  for (const Square square : squares_) {  // single lattice points
    const size_t cell = square.cell;
    if (!is_empty(cell) || !is_clear(cell, square.x, square.y)) continue;
    x_[cell] = square.x;
    y_[cell] = square.y;
  }
}

}  // namespace seamount::geom
