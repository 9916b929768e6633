#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/geom/flow.h"

namespace seamount::geom {
namespace {

constexpr int32_t kOutside = 0;  // the basin of all cells that drain off the map or into the sea

/// The lowest place where two basins meet.
struct Pass {
  float height;
  int32_t a, b;  ///< a < b
  bool same_pair(const Pass& other) const { return a == other.a && b == other.b; }
};

/// In 64 bits, for sorting by pair first.
uint64_t pair_key(const Pass& pass) {
  return static_cast<uint64_t>(pass.a) << 32 | static_cast<uint64_t>(static_cast<uint32_t>(pass.b));
}

void keep_lowest_of_each_pair(std::vector<Pass>& passes) {
  std::sort(passes.begin(), passes.end(), [](const Pass& p, const Pass& q) {
    const uint64_t first = pair_key(p), second = pair_key(q);
    return first != second ? first < second : p.height < q.height;
  });
  passes.erase(std::unique(passes.begin(), passes.end(), [](const Pass& p, const Pass& q) { return p.same_pair(q); }),
               passes.end());
}

/// Numbers the pits from 1 in scan order and gives every cell the number of the basin that it lies in.
int32_t label_basins(const FlowDirections& directions, Grid<int32_t>& basins, const RunContext& run) {
  int32_t count = 1;
  const uint8_t* code = directions.data();
  for (int64_t i = 0; i < directions.frame().cells(); ++i)
    basins.data()[i] = code[i] == kPit ? count++ : code[i] == kOutlet ? kOutside : -1;
  if (count > 1) label_upstream(directions, basins, run);
  return count;
}

/// The passes between the cells of rows [begin, end) and their neighbours to the east and south.
std::vector<Pass> passes_of_rows(const HeightField& terrain, const Grid<int32_t>& basins, int begin, int end) {
  std::vector<Pass> passes;
  const int width = terrain.width();
  const float* z = terrain.data();
  const int32_t* basin = basins.data();
  const auto meet = [&](int64_t i, int64_t j) {
    if (basin[i] == basin[j]) return;
    const Pass pass{std::max(z[i], z[j]), std::min(basin[i], basin[j]), std::max(basin[i], basin[j])};
    if (!passes.empty() && passes.back().same_pair(pass))
      passes.back().height = std::min(passes.back().height, pass.height);
    else
      passes.push_back(pass);
  };
  for (int y = begin; y < end; ++y) {
    const bool south = y + 1 < terrain.height();
    for (int x = 0; x < width; ++x) {
      const int64_t i = static_cast<int64_t>(y) * width + x;
      if (x + 1 < width) meet(i, i + 1);
      if (!south) continue;
      meet(i, i + width);
      if (x > 0) meet(i, i + width - 1);
      if (x + 1 < width) meet(i, i + width + 1);
    }
  }
  keep_lowest_of_each_pair(passes);
  return passes;
}

std::vector<Pass> find_passes(const HeightField& terrain, const Grid<int32_t>& basins, const RunContext& run) {
  constexpr int kRows = 64;
  std::vector<std::vector<Pass>> parts(static_cast<size_t>((terrain.height() + kRows - 1) / kRows));
  parallel_blocks(run, terrain.height(), kRows, [&](int64_t begin, int64_t end) {
    parts[static_cast<size_t>(begin / kRows)] =
        passes_of_rows(terrain, basins, static_cast<int>(begin), static_cast<int>(end));
  });
  std::vector<Pass> passes;
  for (std::vector<Pass>& part : parts) {
    passes.insert(passes.end(), part.begin(), part.end());
    part = {};
  }
  return passes;
}

/// Basins that are joined at passes so far, each group with the list of its members.
class BasinGroups {
 public:
  explicit BasinGroups(int32_t count) : leader_(static_cast<size_t>(count)), next_(leader_.size(), -1), last_(leader_) {
    for (int32_t i = 0; i < count; ++i) at(leader_, i) = at(last_, i) = i;
  }

  int32_t find(int32_t basin) {
    while (at(leader_, basin) != basin) {
      at(leader_, basin) = at(leader_, at(leader_, basin));
      basin = at(leader_, basin);
    }
    return basin;
  }

  /// The smaller index leads, so that the outside stays its group's leader.
  void join(int32_t a, int32_t b) {
    if (b < a) std::swap(a, b);
    at(leader_, b) = a;
    at(next_, at(last_, a)) = b;
    at(last_, a) = at(last_, b);
  }

  template <class Visit>
  void for_each_member(int32_t leader, const Visit& visit) const {
    for (int32_t i = leader; i >= 0; i = next_[static_cast<size_t>(i)]) visit(i);
  }

 private:
  static int32_t& at(std::vector<int32_t>& list, int32_t i) { return list[static_cast<size_t>(i)]; }
  std::vector<int32_t> leader_, next_, last_;
};

/// Kruskal: when a group of basins first meets the outside, the pass where it does is the water level of all of them.
std::vector<float> water_levels(std::vector<Pass> passes, int32_t count, const RunContext& run) {
  std::sort(passes.begin(), passes.end(), [](const Pass& p, const Pass& q) {
    return p.height != q.height ? p.height < q.height : pair_key(p) < pair_key(q);
  });
  run.check_cancelled();
  std::vector<float> levels(static_cast<size_t>(count), kNoSea);
  BasinGroups groups(count);
  for (const Pass& pass : passes) {
    const int32_t a = groups.find(pass.a), b = groups.find(pass.b);
    if (a == b) continue;
    if (std::min(a, b) == kOutside) {
      groups.for_each_member(std::max(a, b), [&](int32_t basin) { levels[static_cast<size_t>(basin)] = pass.height; });
    }
    groups.join(a, b);
  }
  return levels;
}

}  // namespace

HeightField fill_depressions(const HeightField& terrain, float sea_level_m, const RunContext& run) {
  HeightField filled = terrain;
  Grid<int32_t> basins(terrain.frame());
  const int32_t count =
      label_basins(flow_directions(terrain, sea_level_m, run.part(0.0, 0.3)), basins, run.part(0.3, 0.6));
  if (count == 1) return filled;
  const std::vector<float> levels =
      water_levels(find_passes(terrain, basins, run.part(0.6, 0.8)), count, run.part(0.8, 0.9));
  parallel_rows(run.part(0.9, 1.0), terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int64_t i = static_cast<int64_t>(begin) * terrain.width(); i < static_cast<int64_t>(end) * terrain.width();
         ++i) {
      const float level = levels[static_cast<size_t>(basins.data()[i])];
      if (filled.data()[i] < level) filled.data()[i] = level;
    }
  });
  return filled;
}

void tilt_flats(HeightField& filled, const FlowDirections& directions, const RunContext& run) {
  const int width = filled.width();
  const std::array<int64_t, 8> steps = flow_steps(width);
  float* z = filled.data();
  const uint8_t* code = directions.data();
  const auto too_low = [&](int64_t i) { return code[i] < 8 && z[i] <= z[i + steps[code[i]]]; };
  std::vector<int32_t> low;
  for (int y = 0; y < filled.height(); ++y) {
    run.check_cancelled();
    for (int x = 0; x < width; ++x) {
      const int64_t i = static_cast<int64_t>(y) * width + x;
      // Only from the first cell of a chain, whose receiver stands: the rest follows upstream.
      if (!too_low(i) || too_low(i + steps[code[i]])) continue;
      low.push_back(static_cast<int32_t>(i));
      while (!low.empty()) {
        const int32_t cell = low.back();
        low.pop_back();
        z[cell] = std::nextafter(z[cell + steps[code[cell]]], INFINITY);
        for (size_t k = 0; k < 8; ++k) {
          const int cx = cell % width + kFlowDx[k], cy = cell / width + kFlowDy[k];
          if (cx < 0 || cy < 0 || cx >= width || cy >= filled.height()) continue;
          const int64_t other = cell + steps[k];
          if (code[other] == (k + 4) % 8 && z[other] <= z[cell]) low.push_back(static_cast<int32_t>(other));
        }
      }
    }
  }
}

}  // namespace seamount::geom
