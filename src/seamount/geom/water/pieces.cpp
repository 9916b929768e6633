#include "seamount/geom/water/pieces.h"

#include <algorithm>
#include <queue>
#include <unordered_map>

#include "seamount/geom/water/groups.h"

namespace seamount::geom {
namespace {

constexpr int32_t kNobody = -1;

bool within(int x, int y, int width, int height) { return x >= 0 && y >= 0 && x < width && y < height; }

/// Grows basins from their first cells, the lowest cell first; cells at or below the level that is on its way are taken
/// without the heap.
class Flood {
 public:
  Flood(const HeightField& piece, float sea, const OpenSides& open)
      : width_(piece.width()), height_(piece.height()), out_{piece, Grid<int32_t>(piece.frame(), kNobody), {}} {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const int32_t rim = rim_number(x, y, width_, height_);
        const bool outside = out_.filled(x, y) <= sea || open.at(x, y, width_, height_);
        if (!outside && rim < 0) continue;
        out_.basins(x, y) = outside ? 0 : rim + 1;
        if (rim >= 0 || beside_ground(x, y, sea)) heap_.push({out_.filled(x, y), y * width_ + x});
      }
    }
  }

  Flooded run(const RunContext& context) {
    for (int64_t done = 0; !level_.empty() || !heap_.empty(); ++done) {
      if (done % (1 << 16) == 0) context.check_cancelled();
      int32_t cell;
      if (!level_.empty()) {
        cell = level_.back();
        level_.pop_back();
      } else {
        cell = heap_.top().cell;
        heap_.pop();
      }
      spread(cell);
    }
    for (const auto& [pair, height] : lowest_)
      out_.spills.push_back({static_cast<int32_t>(pair >> 32), static_cast<int32_t>(pair & 0xffffffffU), height});
    std::sort(out_.spills.begin(), out_.spills.end(),
              [](const Spill& a, const Spill& b) { return a.a != b.a ? a.a < b.a : a.b < b.b; });
    return std::move(out_);
  }

 private:
  struct Place {
    float height;
    int32_t cell;
    bool operator<(const Place& other) const {  // the lowest on top
      return height != other.height ? height > other.height : cell > other.cell;
    }
  };

  bool beside_ground(int x, int y, float sea) const {
    for (size_t k = 0; k < 8; ++k) {
      if (out_.filled(x + kFlowDx[k], y + kFlowDy[k]) > sea) return true;
    }
    return false;
  }

  void spread(int32_t cell) {
    const int x = cell % width_, y = cell / width_;
    const float level = out_.filled.data()[cell];
    const int32_t basin = out_.basins.data()[cell];
    for (size_t k = 0; k < 8; ++k) {
      const int nx = x + kFlowDx[k], ny = y + kFlowDy[k];
      if (!within(nx, ny, width_, height_)) continue;
      const int32_t other = ny * width_ + nx;
      int32_t& of = out_.basins.data()[other];
      float& z = out_.filled.data()[other];
      if (of != kNobody) {
        if (of != basin) meet(basin, of, std::max(level, z));
        continue;
      }
      of = basin;
      if (z <= level) {
        z = level;
        level_.push_back(other);
      } else {
        heap_.push({z, other});
      }
    }
  }

  void meet(int32_t a, int32_t b, float height) {
    const uint64_t pair = (static_cast<uint64_t>(std::min(a, b)) << 32) | static_cast<uint32_t>(std::max(a, b));
    const auto [known, fresh] = lowest_.emplace(pair, height);
    if (!fresh) known->second = std::min(known->second, height);
  }

  int width_, height_;
  Flooded out_;
  std::priority_queue<Place> heap_;
  std::vector<int32_t> level_;
  std::unordered_map<uint64_t, float> lowest_;
};

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
  return Flood(piece, sea_level_m, open).run(run);
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
