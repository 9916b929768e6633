#include "seamount/ops/classify/patches.h"

#include <array>
#include <vector>

namespace seamount::classify {
namespace {

bool is_land(Region region) { return region == Region::mountain || region == Region::beach; }

/// The cells of a patch and the labels along its border, counted.
struct Patch {
  std::vector<int32_t> cells;
  std::array<int64_t, kRegionCount> around{};
};

void grow_patch(const LabelMap& labels, int32_t start, std::vector<uint8_t>& seen, Patch& patch) {
  const int width = labels.width();
  const Region own = labels.cells()[static_cast<size_t>(start)];
  patch.cells.assign(1, start);
  patch.around = {};
  seen[static_cast<size_t>(start)] = 1;
  constexpr std::array<std::array<int, 2>, 4> kSides = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  for (size_t next = 0; next < patch.cells.size(); ++next) {
    const int x = patch.cells[next] % width, y = patch.cells[next] / width;
    for (const auto& [dx, dy] : kSides) {
      if (!labels.contains(x + dx, y + dy)) continue;
      const int32_t there = patch.cells[next] + dy * width + dx;
      const Region label = labels.cells()[static_cast<size_t>(there)];
      if (label != own) {
        ++patch.around[static_cast<size_t>(label)];
      } else if (seen[static_cast<size_t>(there)] == 0) {
        seen[static_cast<size_t>(there)] = 1;
        patch.cells.push_back(there);
      }
    }
  }
}

}  // namespace

void remove_patches(LabelMap& labels, int64_t min_cells, const RunContext& run) {
  std::vector<uint8_t> seen(labels.size(), 0);
  Patch patch;
  for (size_t i = 0; i < labels.size(); ++i) {
    if (i % 65536 == 0) run.check_cancelled();
    if (seen[i] != 0) continue;
    const Region own = labels.cells()[i];
    grow_patch(labels, static_cast<int32_t>(i), seen, patch);
    if (static_cast<int64_t>(patch.cells.size()) >= min_cells) continue;
    int64_t most = 0;
    Region winner = own;
    for (const Region region : kRegions) {
      const int64_t count = patch.around[static_cast<size_t>(region)];
      if (is_land(region) != is_land(own) || count <= most) continue;
      most = count;
      winner = region;
    }
    for (const int32_t cell : patch.cells) labels.cells()[static_cast<size_t>(cell)] = winner;
  }
}

}  // namespace seamount::classify
