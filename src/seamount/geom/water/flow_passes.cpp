#include "seamount/geom/water/flow_passes.h"

#include <algorithm>
#include <numeric>

#include "seamount/base/parallel.h"

namespace seamount::geom {
namespace {

/// In 64 bits, for sorting by pair first.
uint64_t pair_key(const Pass& pass) {
  return static_cast<uint64_t>(pass.a) << 32 | static_cast<uint64_t>(static_cast<uint32_t>(pass.b));
}

void keep_lowest_of_each_pair(std::vector<Pass>& passes) {
  std::sort(passes.begin(), passes.end(), [](const Pass& p, const Pass& q) {
    const uint64_t first = pair_key(p), second = pair_key(q);
    if (first != second) return first < second;
    return p.height != q.height ? p.height < q.height : p.cell < q.cell;
  });
  passes.erase(std::unique(passes.begin(), passes.end(),
                           [](const Pass& p, const Pass& q) { return pair_key(p) == pair_key(q); }),
               passes.end());
}

/// The passes between the cells of rows [begin, end) and their neighbours to the east and south.
std::vector<Pass> passes_of_rows(const HeightField& terrain, const Grid<int32_t>& basins, int begin, int end) {
  std::vector<Pass> passes;
  const int width = terrain.width();
  const float* z = terrain.data();
  const int32_t* basin = basins.data();
  const auto meet = [&](int64_t i, int64_t j) {
    if (basin[i] == basin[j]) return;
    passes.push_back(
        {std::max(z[i], z[j]), std::min(basin[i], basin[j]), std::max(basin[i], basin[j]), static_cast<int32_t>(i)});
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

}  // namespace

Basins find_basins(const FlowDirections& directions, const RunContext& run) {
  Basins basins{Grid<int32_t>(directions.frame()), {-1}};
  const uint8_t* code = directions.data();
  for (int64_t i = 0; i < directions.frame().cells(); ++i) {
    if (i % 65536 == 0) run.check_cancelled();
    basins.of.data()[i] = code[i] == kPit ? basins.count() : code[i] == kOutlet ? kOutside : -1;
    if (code[i] == kPit) basins.pits.push_back(static_cast<int32_t>(i));
  }
  if (basins.count() > 1) label_upstream(directions, basins.of, run);
  return basins;
}

std::vector<Pass> find_passes(const HeightField& terrain, const Basins& basins, const RunContext& run) {
  constexpr int kRows = 64;
  std::vector<std::vector<Pass>> parts(static_cast<size_t>((terrain.height() + kRows - 1) / kRows));
  parallel_blocks(run, terrain.height(), kRows, [&](int64_t begin, int64_t end) {
    parts[static_cast<size_t>(begin / kRows)] =
        passes_of_rows(terrain, basins.of, static_cast<int>(begin), static_cast<int>(end));
  });
  std::vector<Pass> passes;
  for (std::vector<Pass>& part : parts) {
    run.check_cancelled();
    passes.insert(passes.end(), part.begin(), part.end());
    part = {};
  }
  std::sort(passes.begin(), passes.end(), [&](const Pass& p, const Pass& q) {
    run.check_cancelled();
    if (p.height != q.height) return p.height < q.height;
    const uint64_t first = pair_key(p), second = pair_key(q);
    return first != second ? first < second : p.cell < q.cell;
  });
  run.check_cancelled();
  return passes;
}

BasinGroups::BasinGroups(int32_t count)
    : leader_(static_cast<size_t>(count)), next_(leader_.size(), -1), last_(leader_.size()) {
  std::iota(leader_.begin(), leader_.end(), 0);
  last_ = leader_;
}

int32_t BasinGroups::find(int32_t basin) {
  auto i = static_cast<size_t>(basin);
  while (static_cast<size_t>(leader_[i]) != i) {
    leader_[i] = leader_[static_cast<size_t>(leader_[i])];
    i = static_cast<size_t>(leader_[i]);
  }
  return static_cast<int32_t>(i);
}

void BasinGroups::join(int32_t a, int32_t b) {
  const auto low = static_cast<size_t>(std::min(a, b)), high = static_cast<size_t>(std::max(a, b));
  leader_[high] = static_cast<int32_t>(low);
  next_[static_cast<size_t>(last_[low])] = static_cast<int32_t>(high);
  last_[low] = last_[high];
}

}  // namespace seamount::geom
