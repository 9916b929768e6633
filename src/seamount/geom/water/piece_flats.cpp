#include "seamount/geom/water/piece_flats.h"

#include <algorithm>
#include <array>
#include <bit>

#include "seamount/base/error.h"
#include "seamount/geom/water/flow_flats.h"
#include "seamount/geom/water/pieces.h"

namespace seamount::geom {
namespace {

/// The cells of a piece's flats that reach its rim, by their place in the window. They are marked.
std::vector<int32_t> find_rim_flats(FlowDirections& directions, const PieceIn& piece) {
  std::vector<int32_t> cells;
  const auto add = [&](int x, int y) {
    if (x < piece.x || y < piece.y || x >= piece.x + piece.width || y >= piece.y + piece.height) return;
    if (directions(x, y) != kPit) return;
    directions(x, y) = kPit | kRimFlat;
    cells.push_back(y * directions.width() + x);
  };
  size_t next = 0;
  for (int32_t rim = 0; rim < rim_size(piece.width, piece.height); ++rim) {
    const int32_t cell = rim_cell(rim, piece.width, piece.height);
    add(piece.x + cell % piece.width, piece.y + cell / piece.width);
    for (; next < cells.size(); ++next) {
      const int x = cells[next] % directions.width(), y = cells[next] / directions.width();
      for (size_t k = 0; k < 8; ++k) add(x + kFlowDx[k], y + kFlowDy[k]);
    }
  }
  return cells;
}

/// Says of a rim flat's cell where it drains and whether it is beside higher ground.
void mark(const HeightField& filled, const std::array<int64_t, 8>& steps, int32_t cell, uint8_t* codes) {
  const float z = filled.data()[cell];
  unsigned outlets = 0;
  for (size_t k = 0; k < 8; ++k) {
    const int64_t other = cell + steps[k];
    if (filled.data()[other] > z) codes[cell] |= kBesideHigher;
    const bool flat = codes[other] == kPit || codes[other] >= kRimFlat;
    if (filled.data()[other] == z && !flat) outlets |= 1U << k;
  }
  if (outlets != 0) codes[cell] = static_cast<uint8_t>((codes[cell] & ~kDirection) | first_outlet(outlets));
}

template <class IsOne>
std::vector<FlatStart> starts_where(const FlowDirections& marked, const IsOne& is_one) {
  std::vector<FlatStart> starts;
  for (int32_t cell = 0; cell < static_cast<int32_t>(marked.size()); ++cell)
    if (is_one(marked.data()[cell])) starts.push_back({cell, 0});
  return starts;
}

}  // namespace

FlowDirections piece_directions(const HeightField& filled, const PieceIn& piece, float sea_level_m,
                                const RunContext& run) {
  FlowDirections all = steepest_directions(filled, sea_level_m, run);
  const auto steps = flow_steps(filled.width());
  for (const int32_t cell : find_rim_flats(all, piece)) mark(filled, steps, cell, all.data());
  drain_flats(filled, all, run);
  FlowDirections made(filled.frame().window(piece.x, piece.y, piece.width, piece.height));
  for (int y = 0; y < piece.height; ++y) {
    const auto row = all.row(piece.y + y).subspan(static_cast<size_t>(piece.x), static_cast<size_t>(piece.width));
    std::copy(row.begin(), row.end(), made.row(y).begin());
  }
  return made;
}

std::vector<FlatStart> cells_that_drain(const FlowDirections& marked) {
  return starts_where(marked, [](uint8_t code) { return code >= kRimFlat && (code & kDirection) != kPit; });
}

std::vector<FlatStart> cells_beside_higher(const FlowDirections& marked) {
  return starts_where(marked, [](uint8_t code) { return (code & kBesideHigher) != 0; });
}

FlatSteps::FlatSteps(const FlowDirections& marked)
    : width_(marked.width()),
      steps_((static_cast<size_t>(width_) + 2) * (static_cast<size_t>(marked.height()) + 2), kNoFlat) {
  for (int y = 0; y < marked.height(); ++y) {
    const auto row = marked.row(y);
    std::transform(row.begin(), row.end(), steps_.begin() + static_cast<int64_t>(index(0, y)),
                   [](uint8_t code) { return code >= kRimFlat ? kFarAway : kNoFlat; });
  }
}

void FlatSteps::spread(std::vector<FlatStart> starts, const RunContext& run,
                       const std::function<void(std::span<const FlatStart>)>& reached) {
  if (starts.empty()) return;
  std::sort(starts.begin(), starts.end(), [](const FlatStart& a, const FlatStart& b) { return a.steps < b.steps; });
  const auto away = flow_steps(width_ + 2);
  std::vector<int64_t> here, next;
  std::vector<FlatStart> told;
  size_t start = 0;
  for (int32_t steps = starts.front().steps;; ++steps) {
    run.check_cancelled();
    for (; start < starts.size() && starts[start].steps == steps; ++start) {
      const auto cell = index(starts[start].cell % width_, starts[start].cell / width_);
      if (steps_[cell] <= steps) continue;
      steps_[cell] = steps;
      here.push_back(static_cast<int64_t>(cell));
    }
    if (here.empty() && start == starts.size()) return;
    if (here.empty()) steps = starts[start].steps - 1;
    if (steps == kFarAway - 1) throw Error("a lake has ways of 2^31 cells and more");
    for (const int64_t cell : here) {
      for (const int64_t step : away) {
        int32_t& there = steps_[static_cast<size_t>(cell + step)];
        if (there <= steps + 1) continue;
        there = steps + 1;
        next.push_back(cell + step);
      }
    }
    if (reached) {
      told.clear();
      for (const int64_t cell : here) {
        const auto x = static_cast<int32_t>(cell % (width_ + 2)) - 1, y = static_cast<int32_t>(cell / (width_ + 2)) - 1;
        told.push_back({y * width_ + x, steps});
      }
      reached(told);
    }
    here.swap(next);
    next.clear();
  }
}

void aim_rim_flats(FlowDirections& marked, const FlatSteps& to_outlet, const FlatSteps& from_higher) {
  const auto key = [&](int x, int y) {
    const int32_t higher = from_higher.at(x, y);
    return 2 * int64_t{to_outlet.at(x, y)} - (higher == kFarAway ? 0 : higher);
  };
  const auto steepest = [&](int x, int y) {
    const int64_t here = key(x, y);
    float best = 0.0F;
    uint8_t code = kPit;
    for (uint8_t k = 0; k < 8; ++k) {
      const int nx = x + kFlowDx[k], ny = y + kFlowDy[k];
      if (to_outlet.at(nx, ny) == kNoFlat) continue;
      const float fall = static_cast<float>(here - key(nx, ny)) / kFlowLength[k];
      if (fall <= best) continue;
      best = fall;
      code = k;
    }
    return code;
  };
  for (int y = 0; y < marked.height(); ++y) {
    for (int x = 0; x < marked.width(); ++x) {
      uint8_t& code = marked(x, y);
      if (code < kRimFlat) continue;
      code &= kDirection;
      if (code == kPit) code = steepest(x, y);
    }
  }
}

}  // namespace seamount::geom
