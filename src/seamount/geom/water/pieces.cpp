#include "seamount/geom/water/pieces.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "seamount/geom/water/flow_passes.h"
#include "seamount/geom/water/groups.h"

namespace seamount::geom {
namespace {

constexpr int32_t kNobody = -1;

bool within(int x, int y, int width, int height) { return x >= 0 && y >= 0 && x < width && y < height; }

/// What is known of the basins of a piece: those that end outside or at a cell of the rim, which has a label, and those
/// of pits, which get the label of the first such basin that their water meets as it rises, and the level where it
/// does.
struct Overflow {
  std::vector<int32_t> label;  ///< 0: outside; rim number + 1; kNobody: not yet
  std::vector<float> level;
};

/// Kruskal: groups of basins that meet over the passes from low to high. Which of several labels a group has does not
/// matter: they have met below every pass that is still to come.
std::vector<Spill> overflow_over(const std::vector<Pass>& passes, Overflow& basins) {
  std::vector<Spill> spills;
  Groups groups(static_cast<int32_t>(basins.label.size()));
  std::vector<int32_t> label_of = basins.label;  // of a group, by its leader
  for (const Pass& pass : passes) {
    const int32_t a = groups.find(pass.a), b = groups.find(pass.b);
    if (a == b) continue;
    const int32_t one = label_of[static_cast<size_t>(a)], other = label_of[static_cast<size_t>(b)];
    if (one != kNobody && other != kNobody) {
      spills.push_back({std::min(one, other), std::max(one, other), pass.height});
    } else if (one != other) {
      groups.for_each_member(one == kNobody ? a : b, [&](int32_t basin) {
        basins.label[static_cast<size_t>(basin)] = std::max(one, other);
        basins.level[static_cast<size_t>(basin)] = pass.height;
      });
    }
    groups.join(a, b);
    const bool both = one != kNobody && other != kNobody;
    label_of[static_cast<size_t>(std::min(a, b))] = both ? std::min(one, other) : std::max(one, other);
  }
  return spills;
}

}  // namespace

int32_t rim_size(int width, int height) {
  if (height <= 2) return width * height;
  return width == 1 ? height : 2 * width + 2 * (height - 2);
}

int32_t rim_number(int x, int y, int width, int height) {
  if (y == 0) return x;
  if (y == height - 1) return width + x;
  if (x != 0 && x != width - 1) return -1;
  const int before = 2 * width;
  return width == 1 ? before + y - 1 : before + 2 * (y - 1) + (x == 0 ? 0 : 1);
}

int32_t rim_cell(int32_t number, int width, int height) {
  if (number < width) return number;
  if (number < 2 * width) return (height - 1) * width + number - width;
  const int32_t rest = number - 2 * width;
  return width == 1 ? rest + 1 : (rest / 2 + 1) * width + (rest % 2 == 0 ? 0 : width - 1);
}

Flooded flood_piece(const HeightField& piece, float sea_level_m, const OpenSides& open, const RunContext& run) {
  const int width = piece.width(), height = piece.height();
  FlowDirections directions = flow_directions(piece, sea_level_m, run.part(0.0, 0.3));
  for (int32_t rim = 0; rim < rim_size(width, height); ++rim) {
    const int32_t cell = rim_cell(rim, width, height);
    const bool outside = piece.data()[cell] <= sea_level_m || open.at(cell % width, cell / width, width, height);
    if (!outside) directions.data()[cell] = kPit;  // a basin of its own
  }
  Basins basins = find_basins(directions, run.part(0.3, 0.6));
  Overflow found{std::vector<int32_t>(static_cast<size_t>(basins.count()), kNobody),
                 std::vector<float>(static_cast<size_t>(basins.count()), kNoSea)};
  found.label[kOutside] = 0;
  for (size_t i = 1; i < found.label.size(); ++i) {
    const int32_t pit = basins.pits[i], rim = rim_number(pit % width, pit / width, width, height);
    if (rim >= 0) found.label[i] = rim + 1;
  }
  std::vector<Spill> spills = overflow_over(find_passes(piece, basins, run.part(0.6, 0.9)), found);
  Flooded flooded{piece, std::move(basins.of), std::move(spills)};
  for (size_t i = 0; i < piece.size(); ++i) {
    int32_t& basin = flooded.basins.data()[i];
    flooded.filled.data()[i] = std::max(flooded.filled.data()[i], found.level[static_cast<size_t>(basin)]);
    basin = found.label[static_cast<size_t>(basin)];
  }
  return flooded;
}

std::vector<float> overflow_levels(int32_t nodes, std::vector<Spill> spills) {
  std::vector<float> levels(static_cast<size_t>(nodes), std::numeric_limits<float>::infinity());
  if (nodes == 0) return levels;
  levels[0] = kNoSea;
  std::sort(spills.begin(), spills.end(), [](const Spill& a, const Spill& b) { return a.height < b.height; });
  Groups groups(nodes);
  for (const Spill& spill : spills) {
    const int32_t a = groups.find(spill.a), b = groups.find(spill.b);
    if (a == b) continue;
    if (std::min(a, b) == 0)
      groups.for_each_member(std::max(a, b), [&](int32_t node) { levels[static_cast<size_t>(node)] = spill.height; });
    groups.join(a, b);
  }
  return levels;
}

PieceWaters find_waters(const HeightField& piece, float sea_level_m, const OpenSides& open, const RunContext& run) {
  const int width = piece.width(), height = piece.height();
  PieceWaters waters{Grid<int32_t>(piece.frame(), kNobody), {}};
  std::vector<int32_t> left;
  for (int32_t first = 0; first < static_cast<int32_t>(piece.size()); ++first) {
    if (first % width == 0) run.check_cancelled();
    if (piece.data()[first] > sea_level_m || waters.of.data()[first] != kNobody) continue;
    const auto number = static_cast<int32_t>(waters.all.size());
    PieceWater water{0, piece.data()[first], false};
    waters.of.data()[first] = number;
    left.assign(1, first);
    while (!left.empty()) {
      const int32_t cell = left.back();
      left.pop_back();
      const int x = cell % width, y = cell / width;
      const float z = piece.data()[cell];
      ++water.cells;
      water.lowest = std::min(water.lowest, z);
      water.open = water.open || z == kNoSea || open.at(x, y, width, height);
      for (size_t k = 0; k < 8; ++k) {
        const int nx = x + kFlowDx[k], ny = y + kFlowDy[k];
        if (!within(nx, ny, width, height)) continue;
        const int32_t other = ny * width + nx;
        if (piece.data()[other] > sea_level_m || waters.of.data()[other] != kNobody) continue;
        waters.of.data()[other] = number;
        left.push_back(other);
      }
    }
    waters.all.push_back(water);
  }
  return waters;
}

std::vector<int32_t> rim_exits(const FlowDirections& codes) {
  constexpr int32_t kUnknown = -2;
  const int width = codes.width(), height = codes.height();
  std::vector<int32_t> exits(codes.size(), kUnknown), way;
  std::vector<int32_t> of_rim(static_cast<size_t>(rim_size(width, height)));
  for (int32_t rim = 0; rim < static_cast<int32_t>(of_rim.size()); ++rim) {
    int32_t cell = rim_cell(rim, width, height), found = kUnknown;
    way.clear();
    while (found == kUnknown) {
      if (exits[static_cast<size_t>(cell)] != kUnknown) {
        found = exits[static_cast<size_t>(cell)];
        break;
      }
      way.push_back(cell);
      const uint8_t code = codes.data()[cell];
      if (code >= 8) {
        found = -1;
        break;
      }
      const int x = cell % width + kFlowDx[code], y = cell / width + kFlowDy[code];
      if (!within(x, y, width, height)) {
        found = rim_number(cell % width, cell / width, width, height);
        break;
      }
      cell = y * width + x;
    }
    for (const int32_t passed : way) exits[static_cast<size_t>(passed)] = found;
    of_rim[static_cast<size_t>(rim)] = found;
  }
  return of_rim;
}

Grid<uint64_t> gather_piece(const FlowDirections& codes, const std::vector<uint64_t>& entering, const RunContext& run) {
  const int width = codes.width(), height = codes.height();
  Grid<uint64_t> cells(codes.frame(), 1);
  for (size_t rim = 0; rim < entering.size(); ++rim)
    cells.data()[rim_cell(static_cast<int32_t>(rim), width, height)] += entering[rim];
  const auto receiver = [&](int32_t cell) -> int32_t {
    const uint8_t code = codes.data()[cell];
    if (code >= 8) return -1;
    const int x = cell % width + kFlowDx[code], y = cell / width + kFlowDy[code];
    return within(x, y, width, height) ? y * width + x : -1;
  };
  Grid<uint8_t> waiting(codes.frame(), 0);
  for (int32_t cell = 0; cell < static_cast<int32_t>(codes.size()); ++cell) {
    if (const int32_t to = receiver(cell); to >= 0) ++waiting.data()[to];
  }
  constexpr uint8_t kDone = 255;
  for (int32_t first = 0; first < static_cast<int32_t>(codes.size()); ++first) {
    if (first % width == 0) run.check_cancelled();
    if (waiting.data()[first] != 0) continue;
    for (int32_t cell = first; cell >= 0 && waiting.data()[cell] == 0;) {
      waiting.data()[cell] = kDone;
      const int32_t to = receiver(cell);
      if (to >= 0) {
        cells.data()[to] += cells.data()[cell];
        --waiting.data()[to];
      }
      cell = to;
    }
  }
  return cells;
}

}  // namespace seamount::geom
