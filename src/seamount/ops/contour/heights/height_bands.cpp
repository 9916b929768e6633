#include "seamount/ops/contour/heights/height_bands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::contour {
namespace {

constexpr double kBasinShare = 0.15;  ///< depth of a basin, as a share of the range, where no outline tells
constexpr double kMinSummit = 0.05;   ///< least share of the range above its outline that a summit takes

size_t at(int i) { return static_cast<size_t>(i); }

/// Regions between the same given outlines.
struct Group {
  int root = -1;                  ///< the region whose outline bounds it; -1: the world's own outlines
  std::map<int, double> heights;  ///< by key
  std::map<int, int64_t> nodes;   ///< by level
  int64_t open_nodes = 0;         ///< of its highest level, where nothing above is given
};

class Planner {
 public:
  Planner(const std::vector<TinRegion>& regions, std::span<const int64_t> nodes, const HeightDistribution& distribution,
          const HeightsParams& params)
      : regions_(regions),
        nodes_(nodes),
        distribution_(distribution),
        params_(params),
        bands_(regions.size()),
        children_(regions.size()) {}

  std::vector<RegionBand> plan() {
    form_groups();
    enter_given_heights();
    int64_t most = 1;
    for (Group& group : groups_) {
      if (group.nodes.empty()) continue;
      const auto [level, count] = *group.nodes.rbegin();
      const bool bounded = group.root >= 0 && regions_[at(group.root)].peak_m;
      if (!bounded && !group.heights.contains(level + 1)) group.open_nodes = count;
      most = std::max(most, group.open_nodes);
    }
    for (Group& group : groups_) {
      if (group.nodes.empty()) continue;
      add_floors(group);
      add_summit(group, most);
      add_quantiles(group);
    }
    for (size_t i = 0; i < regions_.size(); ++i) set_band(i);
    return std::move(bands_);
  }

 private:
  /// The key of a region's outline.
  int outline_key(size_t region) const { return bands_[region].level + (regions_[region].basin ? 1 : 0); }

  void check_range(const TinRegion& region) const {
    const double height = *region.height_m;
    if (region.peak_m && !region.basin && *region.peak_m > distribution_.high_m()) {
      throw InvalidArgument("max_m",
                            fmt::format("the peak of '{}' lies at {} m, above {} m; raise max_m to it", region.name,
                                        format_number(*region.peak_m), format_number(distribution_.high_m())));
    }
    const bool fits = height >= distribution_.low_m() &&
                      (region.basin ? height <= distribution_.high_m() : height < distribution_.high_m());
    if (fits) return;
    const bool low = height < distribution_.low_m();
    throw InvalidArgument(
        low ? "min_m" : "max_m",
        fmt::format("the outline of '{}' lies at {} m, outside the heights from {} to {} m; {}", region.name,
                    format_number(height), format_number(distribution_.low_m()), format_number(distribution_.high_m()),
                    low ? "lower min_m to it" : "raise max_m above it"));
  }

  void form_groups() {
    groups_.resize(1);
    groups_[0].heights[0] = distribution_.low_m();
    for (size_t i = 0; i < regions_.size(); ++i) {
      const TinRegion& region = regions_[i];
      RegionBand& band = bands_[i];
      band.level = region.parent < 0 ? 0 : bands_[at(region.parent)].level + (region.basin ? -1 : 1);
      if (region.parent >= 0) {
        children_[at(region.parent)].push_back(i);
        if (!region.basin) bands_[at(region.parent)].summit = false;
      }
      band.summit = true;
      if (region.height_m) {
        check_range(region);
        band.group = static_cast<int>(groups_.size());
        groups_.push_back({static_cast<int>(i), {{outline_key(i), *region.height_m}}, {}, 0});
      } else {
        band.group = region.parent < 0 ? 0 : bands_[at(region.parent)].group;
      }
      groups_[at(band.group)].nodes[band.level] += nodes_[i];
    }
  }

  /// Given outlines inside a group hold for their key: the mean, where several lie at one.
  void enter_given_heights() {
    std::map<std::pair<int, int>, std::pair<double, int>> sums;  // by group and key
    for (size_t i = 0; i < regions_.size(); ++i) {
      const TinRegion& region = regions_[i];
      if (!region.height_m || region.basin || region.parent < 0) continue;
      auto& [sum, count] = sums[{bands_[at(region.parent)].group, bands_[i].level}];
      sum += *region.height_m;
      ++count;
    }
    for (const auto& [place, sum] : sums) {
      std::map<int, double>& heights = groups_[at(place.first)].heights;
      const double mean = sum.first / sum.second;
      const auto above = heights.upper_bound(place.second);
      const bool ascends = above == heights.begin() || std::prev(above)->second < mean;
      if (!heights.contains(place.second) && ascends) heights[place.second] = mean;
    }
  }

  /// Below the lowest outline: basins.
  void add_floors(Group& group) {
    const int lowest = group.nodes.begin()->first;
    while (group.heights.begin()->first > lowest) {
      const auto [key, height] = *group.heights.begin();
      double depth = kBasinShare * (distribution_.high_m() - distribution_.low_m());
      if (const std::optional<double> around = height_around(group, key - 1); around && *around < height) {
        depth = 0.5 * (height - *around);
      }
      group.heights[key - 1] = height - basin_depth(depth, group.nodes[key - 1]);
    }
  }

  /// Unless it is given, not deeper than a hill of that width would be high, and half as much again.
  double basin_depth(double derived, int64_t nodes) const {
    if (params_.basin_depth_m) return *params_.basin_depth_m;
    const auto all =
        static_cast<double>(std::max<int64_t>(std::accumulate(nodes_.begin(), nodes_.end(), int64_t{0}), 1));
    const double relief = distribution_.high_m() - distribution_.low_m();
    return std::min(derived, 1.5 * relief * std::sqrt(static_cast<double>(std::max<int64_t>(nodes, 1)) / all));
  }

  /// The height of a key in the group around this one.
  std::optional<double> height_around(const Group& group, int key) const {
    if (group.root < 0 || regions_[at(group.root)].parent < 0) return std::nullopt;
    const Group& around = groups_[at(bands_[at(regions_[at(group.root)].parent)].group)];
    const auto found = around.heights.find(key);
    return found == around.heights.end() ? std::nullopt : std::optional<double>(found->second);
  }

  void add_summit(Group& group, int64_t most) {
    const int key = group.nodes.rbegin()->first + 1;
    if (group.heights.contains(key)) return;
    const double below = group.heights.rbegin()->second;
    double share = 1.0;
    if (params_.summits == Summits::by_size) {
      share = std::sqrt(static_cast<double>(group.open_nodes) / static_cast<double>(most));
    }
    group.heights[key] = below + (distribution_.high_m() - below) * std::max(share, kMinSummit);
  }

  /// Keys between known ones lie where as much ground is below them as their levels hold.
  void add_quantiles(Group& group) {
    const auto count = [&](int from, int to) {
      int64_t sum = 0;
      for (auto level = group.nodes.lower_bound(from); level != group.nodes.end() && level->first < to; ++level) {
        sum += level->second;
      }
      return static_cast<double>(std::max<int64_t>(sum, 1));
    };
    const std::map<int, double> known = group.heights;
    for (auto low = known.begin(), high = std::next(low); high != known.end(); low = high++) {
      for (int key = low->first + 1; key < high->first; ++key) {
        const double share = count(low->first, key) / count(low->first, high->first);
        group.heights[key] = distribution_.quantile(low->second, high->second, share);
      }
    }
  }

  void set_band(size_t i) {
    RegionBand& band = bands_[i];
    const std::map<int, double>& heights = groups_[at(band.group)].heights;
    band.from_m = heights.at(band.level);
    band.to_m = heights.at(band.level + 1);
    band.outline_m = heights.at(outline_key(i));
    set_depth(i);
    set_peak(i);
    if (regions_[i].basin) return;
    std::optional<double> highest;
    bool plain = false;
    for (const size_t c : children_[i]) {
      const TinRegion& child = regions_[c];
      if (child.basin) {
        band.alone |= child.height_m && *child.height_m != band.from_m;
      } else if (!child.height_m) {
        plain = true;
      } else {
        band.alone |= *child.height_m != band.to_m;
        highest = std::max(highest.value_or(*child.height_m), *child.height_m);
      }
    }
    if (highest) band.to_m = plain ? std::max(band.to_m, *highest) : *highest;
  }

  /// No basin in it.
  bool is_floor(size_t i) const {
    return regions_[i].basin &&
           std::none_of(children_[i].begin(), children_[i].end(), [&](size_t child) { return regions_[child].basin; });
  }

  /// A basin's own depth where its keys reach down to the outline around its hill: not every crater is that deep.
  void set_depth(size_t i) {
    RegionBand& band = bands_[i];
    if (!is_floor(i) || groups_[at(band.group)].root == static_cast<int>(i)) return;
    band.from_m = band.to_m - basin_depth(0.5 * (band.to_m - band.from_m), nodes_[i]);
    band.alone = true;
  }

  /// A peak of its own, for a summit or a basin's floor.
  void set_peak(size_t i) {
    const TinRegion& region = regions_[i];
    RegionBand& band = bands_[i];
    if (!region.peak_m || !(region.basin ? is_floor(i) : band.summit)) return;
    double& end = region.basin ? band.from_m : band.to_m;
    if (region.basin ? *region.peak_m >= band.to_m : *region.peak_m <= band.from_m) {
      throw InvalidArgument("tin", fmt::format("the peak of '{}' at {} m is not {} than its outline, which the "
                                               "distribution puts at {} m; give the outline a height",
                                               region.name, format_number(*region.peak_m),
                                               region.basin ? "lower" : "higher", format_number(band.outline_m)));
    }
    band.alone = band.alone || end != *region.peak_m;
    end = *region.peak_m;
  }

  const std::vector<TinRegion>& regions_;
  std::span<const int64_t> nodes_;
  const HeightDistribution& distribution_;
  const HeightsParams& params_;
  std::vector<RegionBand> bands_;
  std::vector<std::vector<size_t>> children_;
  std::vector<Group> groups_;
};

}  // namespace

std::vector<RegionBand> height_bands(const std::vector<TinRegion>& regions, std::span<const int64_t> nodes,
                                     const HeightDistribution& distribution, const HeightsParams& params) {
  return Planner(regions, nodes, distribution, params).plan();
}

}  // namespace seamount::contour
