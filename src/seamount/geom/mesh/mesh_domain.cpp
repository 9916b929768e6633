#include "seamount/geom/mesh/mesh_domain.h"

#include <array>
#include <bit>
#include <cmath>

#include "seamount/base/parallel.h"

namespace seamount::geom {
namespace {

/// Squares around a cell, clockwise from the north-east, as steps to their north-western corners.
constexpr std::array<LatticePoint, 4> kAround = {{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};
/// Which square lacks the corner that the cell itself is; the next one along a square's own corners (clockwise) is the
/// first neighbour of the cell in the square.
constexpr std::array<MeshSquare, 4> kClockwise = {MeshSquare::without_nw, MeshSquare::without_ne,
                                                  MeshSquare::without_se, MeshSquare::without_sw};
constexpr std::array<int, 4> kOwnCorner = {3, 0, 1, 2};  // of kClockwise, in each square of kAround

/// What a square holds of the two eighths of a circle around its corner `own`, clockwise: 1 the first, 2 the second.
unsigned eighths(MeshSquare square, int own) {
  if (square == MeshSquare::none) return 0;
  if (square == MeshSquare::whole) return 3;
  int missing = 0;
  while (kClockwise[static_cast<size_t>(missing)] != square) ++missing;
  constexpr std::array<unsigned, 4> kHeld = {0, 2, 3, 1};  // without the cell, its next, its opposite, its previous
  return kHeld[static_cast<size_t>((missing - own + 4) % 4)];
}

MeshSquare square_of(const HeightField& heights, int x, int y) {
  const std::array<bool, 4> known = {!std::isnan(heights(x, y)), !std::isnan(heights(x + 1, y)),
                                     !std::isnan(heights(x + 1, y + 1)), !std::isnan(heights(x, y + 1))};
  int count = 0;
  for (const bool k : known) count += k;
  if (count == 4) return MeshSquare::whole;
  if (count < 3) return MeshSquare::none;
  for (size_t k = 0; k < 4; ++k) {
    if (!known[k]) return kClockwise[k];
  }
  return MeshSquare::none;
}

}  // namespace

MeshDomain::MeshDomain(const HeightField& heights, const RunContext& run)
    : width_(heights.width()), height_(heights.height()) {
  known_ = parallel_sum<int64_t>(run.part(0.0, 0.5), height_, 64, [&](int64_t begin, int64_t end) {
    int64_t known = 0;
    for (int64_t y = begin; y < end; ++y) {
      for (const float z : heights.row(static_cast<int>(y))) known += !std::isnan(z);
    }
    return known;
  });
  triangles_ = 2 * int64_t{width_ - 1} * (height_ - 1);
  if (known_ == static_cast<int64_t>(heights.size())) return;
  squares_.resize(static_cast<size_t>(width_ - 1) * static_cast<size_t>(height_ - 1));
  parallel_rows(run.part(0.5, 1.0), width_ - 1, height_ - 1, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width_ - 1; ++x) squares_[at(x, y)] = square_of(heights, x, y);
    }
  });
  part_all();
  triangles_ = 0;
  for (const MeshSquare square : squares_)
    triangles_ += square == MeshSquare::whole ? 2 : square == MeshSquare::none ? 0 : 1;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) left_out_ += !std::isnan(heights(x, y)) && sectors(x, y) == 0;
  }
}

/// Eighths of the circle around a cell that are in the domain, clockwise from north.
unsigned MeshDomain::sectors(int x, int y) const {
  unsigned held = 0;
  for (size_t k = 0; k < 4; ++k) held |= eighths(square(x + kAround[k].x, y + kAround[k].y), kOwnCorner[k]) << (2 * k);
  return held;
}

bool MeshDomain::is_rim(LatticePoint cell) const {
  if (is_whole() || sectors(cell.x, cell.y) == 0) return false;
  for (const LatticePoint step : kAround) {
    const int x = cell.x + step.x, y = cell.y + step.y;
    if (x < 0 || y < 0 || x >= width_ - 1 || y >= height_ - 1) continue;
    if (squares_[at(x, y)] != MeshSquare::whole) return true;
  }
  return false;
}

bool MeshDomain::square_holds(int x, int y, LatticePoint cell) const {
  for (size_t k = 0; k < 4; ++k) {
    if (cell.x + kAround[k].x == x && cell.y + kAround[k].y == y) return eighths(square(x, y), kOwnCorner[k]) != 0;
  }
  return false;
}

bool MeshDomain::holds_step(LatticePoint a, LatticePoint b) const {
  const LatticePoint first = std::min(a, b);
  const bool along_row = a.y == b.y;
  for (const int side : {-1, 0}) {
    const int x = first.x + (along_row ? 0 : side), y = first.y + (along_row ? side : 0);
    if (square_holds(x, y, a) && square_holds(x, y, b)) return true;
  }
  return false;
}

bool MeshDomain::holds_triangle(LatticePoint a, LatticePoint b, LatticePoint c) const {
  if (is_whole()) return true;
  // The middle in thirds of a cell: it lies strictly inside of the triangle, so never on a hole's rim.
  const int x3 = a.x + b.x + c.x, y3 = a.y + b.y + c.y;
  const int dx = x3 % 3, dy = y3 % 3;
  switch (square(x3 / 3, y3 / 3)) {
    case MeshSquare::none:
      return false;
    case MeshSquare::whole:
      return true;
    case MeshSquare::without_nw:
      return dx + dy >= 3;
    case MeshSquare::without_se:
      return dx + dy <= 3;
    case MeshSquare::without_ne:
      return dy >= dx;
    case MeshSquare::without_sw:
      return dx >= dy;
  }
  return false;
}

/// Leaves only the widest of the arcs around a cell in the domain. True if there were more.
bool MeshDomain::part_where_pinched(int x, int y) {
  const unsigned held = sectors(x, y);
  const unsigned starts = held & ~((held << 1 | held >> 7) & 0xFFU);
  if (std::popcount(starts) < 2) return false;
  unsigned widest = 0;
  for (int first = 0; first < 8; ++first) {
    if ((starts >> first & 1U) == 0) continue;
    unsigned arc = 0;
    for (int k = 0; k < 8 && (held >> (first + k) % 8 & 1U) != 0; ++k) arc |= 1U << (first + k) % 8;
    if (std::popcount(arc) > std::popcount(widest)) widest = arc;
  }
  for (size_t k = 0; k < 4; ++k) {
    const unsigned part = held >> (2 * k) & 3U;
    if (part != 0 && (widest >> (2 * k) & part) == 0)
      squares_[at(x + kAround[k].x, y + kAround[k].y)] = MeshSquare::none;
  }
  return true;
}

void MeshDomain::part_all() {
  std::vector<LatticePoint> waiting;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) waiting.push_back({x, y});
    while (!waiting.empty()) {
      const LatticePoint cell = waiting.back();
      waiting.pop_back();
      if (!part_where_pinched(cell.x, cell.y)) continue;
      for (int j = std::max(0, cell.y - 1); j <= std::min(height_ - 1, cell.y + 1); ++j) {
        for (int i = std::max(0, cell.x - 1); i <= std::min(width_ - 1, cell.x + 1); ++i) waiting.push_back({i, j});
      }
    }
  }
}

}  // namespace seamount::geom
