#include "seamount/ops/reef/pieces.h"

#include <algorithm>
#include <cmath>

namespace seamount::reef {
namespace {

constexpr int kSquare = 150;    // cells: P4 sec. 4.1
constexpr int kLeastPiece = 4;  // cells
constexpr double kFar = 1e300;

struct Box {
  int west, north, east, south;  ///< half open
};

struct Piece {
  LatticeCell nearest;
  double square = kFar;  ///< of the distance to the square's place
  int cells = 0;
};

/// Piece of a box that holds `first`, marked in `seen`.
Piece walk_piece(const Grid<uint8_t>& habitat, const Box& box, LatticeCell first, double px, double py,
                 Grid<uint8_t>& seen) {
  Piece piece;
  std::vector<LatticeCell> front = {first};
  seen(first.x, first.y) = 1;
  while (!front.empty()) {
    const LatticeCell s = front.back();
    front.pop_back();
    ++piece.cells;
    const double dx = s.x - px, dy = s.y - py, square = dx * dx + dy * dy;
    if (square < piece.square) piece.square = square, piece.nearest = s;
    for (int y = std::max(box.north, s.y - 1); y < std::min(box.south, s.y + 2); ++y) {
      for (int x = std::max(box.west, s.x - 1); x < std::min(box.east, s.x + 2); ++x) {
        if (habitat(x, y) == 0 || seen(x, y) != 0) continue;
        seen(x, y) = 1;
        front.push_back({x, y});
      }
    }
  }
  return piece;
}

}  // namespace

std::vector<LatticeCell> starts_of_pieces(const Grid<uint8_t>& habitat, Seed seed) {
  const int columns = std::max(1, static_cast<int>(std::lround(static_cast<double>(habitat.width()) / kSquare)));
  const int rows = std::max(1, static_cast<int>(std::lround(static_cast<double>(habitat.height()) / kSquare)));
  Grid<uint8_t> seen(habitat.frame(), 0);
  std::vector<LatticeCell> starts;
  Piece largest;
  for (int i = 0; i < columns * rows; ++i) {
    const int cx = i % columns, cy = i / columns;
    const Box box{cx * habitat.width() / columns, cy * habitat.height() / rows, (cx + 1) * habitat.width() / columns,
                  (cy + 1) * habitat.height() / rows};
    Rng rng(seed.derive("reef.piece", static_cast<uint64_t>(i)));
    const bool one = columns * rows == 1;
    const double u = one ? 0.5 : rng.uniform(), v = one ? 0.5 : rng.uniform();
    const double px = box.west + u * (box.east - box.west) - 0.5, py = box.north + v * (box.south - box.north) - 0.5;
    for (int y = box.north; y < box.south; ++y) {
      for (int x = box.west; x < box.east; ++x) {
        if (habitat(x, y) == 0 || seen(x, y) != 0) continue;
        const Piece piece = walk_piece(habitat, box, {x, y}, px, py, seen);
        if (piece.cells >= kLeastPiece) starts.push_back(piece.nearest);
        if (piece.cells > largest.cells) largest = piece;
      }
    }
  }
  if (starts.empty() && largest.cells > 0) starts.push_back(largest.nearest);
  return starts;
}

}  // namespace seamount::reef
