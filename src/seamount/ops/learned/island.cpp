#include "seamount/ops/learned/island.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/geom/grid/pyramid_fill.h"

namespace seamount::learned {
namespace {

constexpr float kCoastShare = 0.3F;  ///< share of land on one side of a coast, less than a half
constexpr float kBeach_m = 4.0F;     ///< rise of the ground over a cell that is half land, at scale 1
constexpr float kDry_m = 0.2F;       ///< of land over the sea at least, and of water's depth
constexpr double kShelf_m = -60.0;   ///< depth from which on the sea floor is brought to the depth asked for
constexpr size_t kSparse = 7;        ///< every so many cells tell how deep the floor is
constexpr size_t kDeepest = 200;     ///< and one of so many lies deeper than what counts as the deepest
constexpr float kSpeck_m = 30.0F;    ///< ground so far from the sea's level is no coast whatever a cell's colour

float land_of(const IslandMap& map, int x, int y) {
  return map.shares[static_cast<size_t>(Region::mountain)](x, y) + map.shares[static_cast<size_t>(Region::beach)](x, y);
}

bool sunk(const IslandMap& map, int x, int y) { return !map.subsidence.empty() && map.subsidence(x, y) > 0.005F; }

/// Lets ground that has not sunk meet the sea where land is painted to end: what it lies off there is spread over what
/// is near and taken away. The network alone is within a cell or two.
void meet_coast(const IslandMap& map, HeightField& heights, const RunContext& run) {
  const auto scale = static_cast<float>(map.scale);
  ScalarField residual(map.frame);
  Grid<float> weight(map.frame);
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < map.frame.width; ++x) {
        residual(x, y) = weight(x, y) = 0;
        const float land = land_of(map, x, y);
        if (sunk(map, x, y) || std::abs(land - 0.5F) > 0.5F - kCoastShare || std::abs(heights(x, y)) > kSpeck_m * scale)
          continue;
        residual(x, y) = kBeach_m * scale * (land - 0.5F) - heights(x, y);
        weight(x, y) = 1;
      }
    }
  });
  geom::pyramid_fill(residual, std::move(weight), {.prior = 0.0F, .fade = 0.7F}, run);
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < map.frame.width; ++x) {
        float& z = heights(x, y);
        z += residual(x, y);
        const float land = land_of(map, x, y);
        if (sunk(map, x, y) || std::abs(z) > kSpeck_m * scale) continue;
        if (land > 1 - kCoastShare) z = std::max(z, kDry_m * scale);
        if (land < kCoastShare) z = std::min(z, -kDry_m * scale);
      }
    }
  });
}

/// Brings the highest summit and the deepest floor to where they are asked for: land grows in proportion, the sea floor
/// below kShelf_m, so that coasts, lagoons and reefs stay.
void meet_range(const IslandMap& map, HeightField& heights, const RunContext& run) {
  if (!map.peak_m && !map.floor_m) return;
  const auto high = std::max_element(heights.cells().begin(), heights.cells().end());
  std::vector<float> some;  // single deep cells count for nothing
  for (size_t i = 0; i < heights.size(); i += kSparse) some.push_back(heights.data()[i]);
  const auto low = some.begin() + static_cast<int64_t>(some.size() / kDeepest);
  std::nth_element(some.begin(), low, some.end());
  const auto shelf = static_cast<float>(kShelf_m * map.scale);
  const float up = map.peak_m && *high > 0 && *map.peak_m > 0 ? static_cast<float>(*map.peak_m) / *high : 1.0F;
  const float down = map.floor_m && *low < 2 * shelf && *map.floor_m < shelf
                         ? (static_cast<float>(*map.floor_m) - shelf) / (*low - shelf)
                         : 1.0F;
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (float& z : heights.row(y)) z = z > 0 ? up * z : z < shelf ? shelf + down * (z - shelf) : z;
    }
  });
}

/// Lets the reefs of ground that has not sunk crest at the depth asked for; what they lie off is taken away around
/// them.
void meet_reef(const IslandMap& map, HeightField& heights, const RunContext& run) {
  if (!map.reef_depth_m) return;
  ScalarField residual(map.frame, 0.0F);
  Grid<float> weight(map.frame, 0.0F);
  for (int y = 0; y < map.frame.height; ++y) {
    for (int x = 0; x < map.frame.width; ++x) {
      if (sunk(map, x, y) || map.shares[static_cast<size_t>(Region::reef)](x, y) < 0.9F) continue;
      residual(x, y) = -static_cast<float>(*map.reef_depth_m) - heights(x, y);
      weight(x, y) = 1;
    }
  }
  geom::pyramid_fill(residual, std::move(weight), {.prior = 0.0F, .fade = 0.3F}, run);
  for (size_t i = 0; i < heights.size(); ++i) {
    const float moved = heights.data()[i] + residual.data()[i];
    heights.data()[i] = (moved > 0) == (heights.data()[i] > 0) ? moved : heights.data()[i];  // coasts stay
  }
}

/// Share of a region in the nine cells around each of a row, the middle one counting most. `column`: room for two more.
SEAMOUNT_VECTORISED void share_row(const Region* const rows[3], Region region, int width, float* column, float* out) {
  for (int x = 0; x < width; ++x) {
    column[x + 1] = (rows[0][x] == region ? 0.25F : 0.0F) + (rows[1][x] == region ? 0.5F : 0.0F) +
                    (rows[2][x] == region ? 0.25F : 0.0F);
  }
  column[0] = column[1];
  column[width + 1] = column[width];
  for (int x = 0; x < width; ++x) out[x] = 0.25F * column[x] + 0.5F * column[x + 1] + 0.25F * column[x + 2];
}

}  // namespace

std::array<Mask, kRegionCount> shares_of(const LabelMap& labels, const RunContext& run) {
  std::array<Mask, kRegionCount> shares;
  for (Mask& share : shares) share = Mask(labels.frame());
  const int width = labels.width(), height = labels.height();
  parallel_rows(run, width, height, [&](int begin, int end) {
    std::vector<float> column(static_cast<size_t>(width) + 2);
    for (int y = begin; y < end; ++y) {
      const Region* const rows[3] = {labels.row(std::max(y - 1, 0)).data(), labels.row(y).data(),
                                     labels.row(std::min(y + 1, height - 1)).data()};
      for (size_t region = 0; region < kRegionCount; ++region)
        share_row(rows, kRegions[region], width, column.data(), shares[region].row(y).data());
    }
  });
  return shares;
}

std::array<Mask, kRegionCount> without_specks(const std::array<Mask, kRegionCount>& shares, const RunContext& run) {
  const int width = shares[0].width(), height = shares[0].height();
  Grid<uint8_t> main_region(shares[0].frame(), 0);
  for (size_t i = 0; i < main_region.size(); ++i) {
    for (size_t region = 1; region < kRegionCount; ++region) {
      if (shares[region].data()[i] > shares[main_region.data()[i]].data()[i])
        main_region.data()[i] = static_cast<uint8_t>(region);
    }
  }
  std::array<Mask, kRegionCount> out = shares;
  parallel_rows(run, width, height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        int same = 0, around = 0;
        std::array<float, kRegionCount> sums{};
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v) {
          for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
            if (u == x && v == y) continue;
            ++around;
            same += main_region(u, v) == main_region(x, y);
            for (size_t region = 0; region < kRegionCount; ++region) sums[region] += shares[region](u, v);
          }
        }
        if (same > 1 || around == 0) continue;  // two specks may touch
        for (size_t region = 0; region < kRegionCount; ++region)
          out[region](x, y) = sums[region] / static_cast<float>(around);
      }
    }
  });
  return out;
}

HeightField island(const IslandMap& map, const Network& network, Seed seed, const RunContext& run) {
  if (network.architecture().planes != kIslandPlanes)
    throw InvalidArgument("model", "is a network of " + std::to_string(network.architecture().planes) +
                                       " planes, and an island has " + std::to_string(kIslandPlanes));
  const IslandPlanes planes(map, seed, run);
  HeightField heights = network.evaluate(planes.planes(), map.frame, run);
  parallel_rows(run, map.frame.width, map.frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (float& z : heights.row(y)) z = static_cast<float>(island_height_m(z, map.scale));
    }
  });
  meet_coast(map, heights, run);
  meet_reef(map, heights, run);
  meet_range(map, heights, run);
  return heights;
}

}  // namespace seamount::learned
