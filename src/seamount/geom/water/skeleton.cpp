#include "seamount/geom/water/skeleton.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/geom/polygon/distance.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/water/flow.h"

namespace seamount::geom {
namespace {

/// Which of the 8 neighbours (bit k: direction k of geom/water/flow.h) are set.
int neighbours(const Grid<uint8_t>& grid, int x, int y) {
  int bits = 0;
  for (size_t k = 0; k < 8; ++k) {
    if (grid.contains(x + kFlowDx[k], y + kFlowDy[k]) && grid(x + kFlowDx[k], y + kFlowDy[k]) != 0) bits |= 1 << k;
  }
  return bits;
}

int count_bits(int bits) {
  int count = 0;
  for (; bits != 0; bits &= bits - 1) ++count;
  return count;
}

/// A cell may go if its set neighbours hang together without it and it is on the border of the figure: Yokoi's number
/// of 8-connectivity is 1.
constexpr std::array<bool, 256> make_simple() {
  std::array<bool, 256> simple{};
  for (int bits = 0; bits < 256; ++bits) {
    int number = 0;
    for (int k = 0; k < 8; k += 2) {
      const bool straight = (bits >> k & 1) == 0, slanted = (bits >> (k + 1) & 1) == 0,
                 next = (bits >> ((k + 2) % 8) & 1) == 0;
      number += static_cast<int>(straight) - static_cast<int>(straight && slanted && next);
    }
    simple[static_cast<size_t>(bits)] = number == 1;
  }
  return simple;
}
constexpr std::array<bool, 256> kSimple = make_simple();

/// Set cells from the border of the figure inwards; beyond the grid is outside.
std::vector<int32_t> by_distance(const Grid<uint8_t>& inside, const RunContext& run) {
  GridFrame wider = inside.frame();
  wider.width += 2;
  wider.height += 2;
  wider.cell_m = 1.0;
  Grid<uint8_t> outside(wider, 1);
  for (int y = 0; y < inside.height(); ++y)
    for (int x = 0; x < inside.width(); ++x) outside(x + 1, y + 1) = inside(x, y) != 0 ? 0 : 1;
  const ScalarField distance = distance_to(outside, run);
  // Squared distances are whole numbers: a bucket for each up to where lines are never thick.
  constexpr size_t kBuckets = 4096;
  std::vector<std::vector<int32_t>> buckets(kBuckets);
  for (int y = 0; y < inside.height(); ++y) {
    for (int x = 0; x < inside.width(); ++x) {
      if (inside(x, y) == 0) continue;
      const float d = distance(x + 1, y + 1);
      const auto bucket = std::min(kBuckets - 1, static_cast<size_t>(std::lround(d * d)));
      buckets[bucket].push_back(y * inside.width() + x);
    }
  }
  std::vector<int32_t> cells;
  for (const std::vector<int32_t>& bucket : buckets) cells.insert(cells.end(), bucket.begin(), bucket.end());
  return cells;
}

/// Walks the chains of a skeleton; each step is taken once.
class Tracer {
 public:
  explicit Tracer(const Grid<uint8_t>& skeleton) : skeleton_(skeleton), used_(skeleton.frame(), 0) {}

  std::vector<CellChain> trace() {
    for_each_cell([&](int x, int y) {
      const int degree = count_bits(neighbours(skeleton_, x, y));
      if (degree == 0) chains_.push_back({cell(x, y)});
      if (degree != 2) leave(x, y);
    });
    for_each_cell([&](int x, int y) {  // only rings are left
      if (used_(x, y) == 0) leave(x, y);
    });
    return std::move(chains_);
  }

 private:
  int32_t cell(int x, int y) const { return y * skeleton_.width() + x; }

  template <class Visit>
  void for_each_cell(const Visit& visit) {
    for (int y = 0; y < skeleton_.height(); ++y)
      for (int x = 0; x < skeleton_.width(); ++x)
        if (skeleton_(x, y) != 0) visit(x, y);
  }

  void leave(int x, int y) {
    const int bits = neighbours(skeleton_, x, y);
    for (size_t k = 0; k < 8; ++k) {
      if ((bits >> k & 1) == 0 || (used_(x, y) >> k & 1) != 0) continue;
      walk(x, y, k);
    }
  }

  void walk(int x, int y, size_t k) {
    const int32_t start = cell(x, y);
    CellChain chain{start};
    while (true) {
      used_(x, y) = static_cast<uint8_t>(used_(x, y) | 1 << k);
      x += kFlowDx[k];
      y += kFlowDy[k];
      const size_t back = (k + 4) % 8;
      used_(x, y) = static_cast<uint8_t>(used_(x, y) | 1 << back);
      chain.push_back(cell(x, y));
      const int bits = neighbours(skeleton_, x, y);
      if (count_bits(bits) != 2 || cell(x, y) == start) break;
      const int onward = bits & ~(1 << back);
      k = 0;
      while ((onward >> k & 1) == 0) ++k;
    }
    chains_.push_back(std::move(chain));
  }

  const Grid<uint8_t>& skeleton_;
  Grid<uint8_t> used_;  ///< bit k: the step in direction k was taken
  std::vector<CellChain> chains_;
};

/// Clears the pieces (8-connected) of less than min_piece cells.
void drop_small_pieces(Grid<uint8_t>& skeleton, int min_piece) {
  Grid<uint8_t> seen(skeleton.frame(), 0);
  std::vector<std::pair<int, int>> piece;
  for (int y = 0; y < skeleton.height(); ++y) {
    for (int x = 0; x < skeleton.width(); ++x) {
      if (skeleton(x, y) == 0 || seen(x, y) != 0) continue;
      piece.assign(1, {x, y});
      seen(x, y) = 1;
      for (size_t i = 0; i < piece.size(); ++i) {
        for (size_t k = 0; k < 8; ++k) {
          const int nx = piece[i].first + kFlowDx[k], ny = piece[i].second + kFlowDy[k];
          if (!skeleton.contains(nx, ny) || skeleton(nx, ny) == 0 || seen(nx, ny) != 0) continue;
          seen(nx, ny) = 1;
          piece.emplace_back(nx, ny);
        }
      }
      if (static_cast<int>(piece.size()) >= min_piece) continue;
      for (const auto& [px, py] : piece) skeleton(px, py) = 0;
    }
  }
}

}  // namespace

void thin(Grid<uint8_t>& inside, const RunContext& run) {
  const std::vector<int32_t> cells = by_distance(inside, run);
  run.check_cancelled();
  const int width = inside.width();
  // A second round takes the corners that had to wait for their neighbours.
  for (bool changed = true; changed;) {
    changed = false;
    for (const int32_t cell : cells) {
      const int x = cell % width, y = cell / width;
      if (inside(x, y) == 0) continue;
      inside(x, y) = 1;
      const int bits = neighbours(inside, x, y);
      if (!kSimple[static_cast<size_t>(bits)] || count_bits(bits) <= 1) continue;
      inside(x, y) = 0;
      changed = true;
    }
  }
}

std::vector<CellChain> trace_skeleton(const Grid<uint8_t>& skeleton) { return Tracer(skeleton).trace(); }

void prune_skeleton(Grid<uint8_t>& skeleton, int min_branch, int min_piece, const RunContext& run) {
  const int width = skeleton.width();
  const auto degree = [&](int32_t cell) { return count_bits(neighbours(skeleton, cell % width, cell / width)); };
  std::vector<CellChain> twigs;
  for (CellChain& chain : trace_skeleton(skeleton)) {
    if (static_cast<int>(chain.size()) > min_branch || chain.size() < 2) continue;
    const bool free_first = degree(chain.front()) == 1, free_last = degree(chain.back()) == 1;
    if (free_first == free_last) continue;
    if (free_last) std::reverse(chain.begin(), chain.end());
    twigs.push_back(std::move(chain));
  }
  for (const CellChain& twig : twigs)
    for (size_t i = 0; i + 1 < twig.size(); ++i) skeleton.data()[twig[i]] = 0;
  drop_small_pieces(skeleton, min_piece);
  thin(skeleton, run);
}

Polyline smooth_chain(const CellChain& cells, const GridFrame& frame) {
  constexpr int kRounds = 12;
  constexpr double kReach = 0.4;  // of a cell, from its centre
  Polyline centres;
  centres.reserve(cells.size());
  for (const int32_t cell : cells) {
    const int row = cell / frame.width;
    centres.push_back({frame.x(cell - row * frame.width), frame.y(row)});
  }
  Polyline line = centres, previous;
  const double reach = kReach * frame.cell_m;
  for (int round = 0; round < kRounds; ++round) {
    previous = line;
    for (size_t i = 1; i + 1 < line.size(); ++i) {
      const Vec2 wanted = 0.25 * (previous[i - 1] + previous[i + 1]) + 0.5 * previous[i];
      line[i].x = std::clamp(wanted.x, centres[i].x - reach, centres[i].x + reach);
      line[i].y = std::clamp(wanted.y, centres[i].y - reach, centres[i].y + reach);
    }
  }
  return simplify_line(line, 0.05 * frame.cell_m);
}

}  // namespace seamount::geom
