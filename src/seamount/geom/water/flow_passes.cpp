#include "seamount/geom/water/flow_passes.h"

#include <algorithm>
#include <cstring>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"

namespace seamount::geom {
namespace {

/// In 64 bits, for sorting by pair first.
uint64_t pair_key(const Pass& pass) {
  return static_cast<uint64_t>(pass.a) << 32 | static_cast<uint64_t>(static_cast<uint32_t>(pass.b));
}

bool lower(const Pass& p, const Pass& q) { return p.height != q.height ? p.height < q.height : p.cell < q.cell; }

/// The lowest pass of each pair of basins: a hash table with open addressing.
class LowestPasses {
 public:
  LowestPasses() : slots_(kLeastSlots, -1) {}

  void add(const Pass& pass) {
    const uint64_t key = pair_key(pass);
    size_t slot = first_slot(key);
    for (; slots_[slot] >= 0; slot = (slot + 1) & (slots_.size() - 1)) {
      Pass& known = passes_[static_cast<size_t>(slots_[slot])];
      if (pair_key(known) != key) continue;
      if (lower(pass, known)) known = pass;
      return;
    }
    slots_[slot] = static_cast<int32_t>(passes_.size());
    passes_.push_back(pass);
    if (2 * passes_.size() > slots_.size()) grow();
  }

  std::vector<Pass> take() { return std::move(passes_); }

 private:
  static constexpr size_t kLeastSlots = 1024;  // a power of 2, as all sizes

  size_t first_slot(uint64_t key) const {
    return static_cast<size_t>(key * 0x9E3779B97F4A7C15ULL >> 32) & (slots_.size() - 1);
  }

  void grow() {
    slots_.assign(2 * slots_.size(), -1);
    for (size_t i = 0; i < passes_.size(); ++i) {
      size_t slot = first_slot(pair_key(passes_[i]));
      while (slots_[slot] >= 0) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = static_cast<int32_t>(i);
    }
  }

  std::vector<int32_t> slots_;
  std::vector<Pass> passes_;
};

/// out[i] = 1 where a cell of [1, count - 1) has a neighbour to the east or south that lies in another basin.
SEAMOUNT_VECTORISED void meeting_row(const int32_t* here, const int32_t* south, uint8_t* out, int count) {
  for (int i = 1; i < count - 1; ++i) {
    const int32_t other =
        (here[i] ^ here[i + 1]) | (here[i] ^ south[i - 1]) | (here[i] ^ south[i]) | (here[i] ^ south[i + 1]);
    out[i] = other != 0 ? 1 : 0;
  }
}

/// The passes between the cells of rows [begin, end) and their neighbours to the east and south.
std::vector<Pass> passes_of_rows(const HeightField& terrain, const Grid<int32_t>& basins, int begin, int end) {
  LowestPasses passes;
  const int width = terrain.width();
  const float* z = terrain.data();
  const int32_t* basin = basins.data();
  const auto meet = [&](int64_t i, int64_t j) {
    if (basin[i] == basin[j]) return;
    passes.add(
        {std::max(z[i], z[j]), std::min(basin[i], basin[j]), std::max(basin[i], basin[j]), static_cast<int32_t>(i)});
  };
  std::vector<uint8_t> meets(static_cast<size_t>(width), 1);
  for (int y = begin; y < end; ++y) {
    const bool south = y + 1 < terrain.height();
    if (south)
      meeting_row(basins.row(y).data(), basins.row(y + 1).data(), meets.data(), width);
    else
      std::fill(meets.begin(), meets.end(), uint8_t{1});
    for (int x = 0; x < width; ++x) {
      const void* found = std::memchr(meets.data() + x, 1, static_cast<size_t>(width - x));
      if (found == nullptr) break;
      x = static_cast<int>(static_cast<const uint8_t*>(found) - meets.data());
      const int64_t i = static_cast<int64_t>(y) * width + x;
      if (x + 1 < width) meet(i, i + 1);
      if (!south) continue;
      meet(i, i + width);
      if (x > 0) meet(i, i + width - 1);
      if (x + 1 < width) meet(i, i + width + 1);
    }
  }
  return passes.take();
}

}  // namespace

Basins find_basins(const FlowDirections& directions, const RunContext& run) {
  constexpr int kRows = 32;
  Basins basins{Grid<int32_t>(directions.frame()), {-1}};
  const uint8_t* code = directions.data();
  const int64_t width = directions.width();
  std::vector<std::vector<int32_t>> pits(static_cast<size_t>((directions.height() + kRows - 1) / kRows));
  parallel_blocks(run.part(0.0, 0.2), directions.height(), kRows, [&](int64_t begin, int64_t end) {
    for (int64_t i = begin * width; i < end * width; ++i) {
      basins.of.data()[i] = code[i] == kOutlet ? kOutside : -1;
      if (code[i] == kPit) pits[static_cast<size_t>(begin / kRows)].push_back(static_cast<int32_t>(i));
    }
  });
  for (const std::vector<int32_t>& part : pits) basins.pits.insert(basins.pits.end(), part.begin(), part.end());
  for (int32_t i = 1; i < basins.count(); ++i) basins.of.data()[basins.pits[static_cast<size_t>(i)]] = i;
  if (basins.count() > 1) label_upstream(directions, basins.of, run.part(0.2, 1.0));
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

}  // namespace seamount::geom
