#include "seamount/geom/water/lake_levels.h"

#include <algorithm>

#include "seamount/geom/water/flow_passes.h"
#include "seamount/geom/water/groups.h"

namespace seamount::geom {
namespace {

constexpr int32_t kNone = -1;

/// A depression up to the pass where it overflows: a basin, or two depressions that meet at their pass.
struct Depression {
  float pass = std::numeric_limits<float>::infinity();
  int32_t parent = kNone;  ///< kOutside: what overflows leaves this tree
  int32_t left = kNone, right = kNone;
  int32_t target = kNone;  ///< basin beyond the pass
  double supply = 0.0;     ///< that comes into its lake, of its whole catchment: as if all of that were dry
  double loss = 0.0;       ///< of its lake when it is full, runoff that the wet ground no longer gives included
  double passed_on = 0.0;  ///< over the pass so far
  bool one_lake = false;   ///< its parts have met
};

/// A pass with the way that water takes there: from the sill, its higher cell, down the steepest slope of the other
/// side.
struct Way {
  Pass pass;
  int32_t sill;
  float slope = -1.0F;
};

Way way_over(const HeightField& terrain, const Basins& basins, float sea, const Pass& pass) {
  const std::array<int64_t, 8> steps = flow_steps(terrain.width());
  const float* z = terrain.data();
  const int32_t* basin = basins.of.data();
  const auto for_each_neighbour = [&](int32_t cell, const auto& visit) {
    const int x = cell % terrain.width(), y = cell / terrain.width();
    for (size_t k = 0; k < 8; ++k)
      if (terrain.contains(x + kFlowDx[k], y + kFlowDy[k])) visit(k, static_cast<int32_t>(cell + steps[k]));
  };
  Way way{pass, pass.cell};
  if (z[pass.cell] != pass.height) {
    for_each_neighbour(pass.cell, [&](size_t k, int32_t other) {
      const bool meets = k == 0 || k >= 5;  // as Pass::cell says
      const bool between =
          std::min(basin[pass.cell], basin[other]) == pass.a && std::max(basin[pass.cell], basin[other]) == pass.b;
      if (meets && between && z[other] == pass.height) way.sill = other;
    });
  }
  const int32_t beyond = basin[way.sill] == pass.a ? pass.b : pass.a;
  for_each_neighbour(way.sill, [&](size_t k, int32_t other) {
    if (basin[other] != beyond) return;
    const float slope = (pass.height - std::max(sea, z[other])) * (k % 2 == 0 ? 1.0F : 0.70710678F);
    way.slope = std::max(way.slope, slope);
  });
  return way;
}

/// From low to high; where several basins meet at one sill, the one first that water goes to from there.
std::vector<Pass> find_ways(const HeightField& terrain, const Basins& basins, float sea, const RunContext& run) {
  std::vector<Pass> passes = find_passes(terrain, basins, run);
  std::vector<Way> ways;
  for (size_t begin = 0, end = 0; begin < passes.size(); begin = end) {
    while (end < passes.size() && passes[end].height == passes[begin].height) ++end;
    if (end - begin == 1) continue;
    run.check_cancelled();
    ways.clear();
    for (size_t i = begin; i < end; ++i) ways.push_back(way_over(terrain, basins, sea, passes[i]));
    std::stable_sort(ways.begin(), ways.end(),
                     [](const Way& a, const Way& b) { return a.sill != b.sill ? a.sill < b.sill : a.slope > b.slope; });
    for (size_t i = begin; i < end; ++i) passes[i] = ways[i - begin].pass;
  }
  return passes;
}

/// Number 0 is the outside, 1 to basins - 1 are basins, joined ones follow: parts come before what they make up.
class DepressionTree {
 public:
  DepressionTree(const std::vector<Pass>& passes, const Basins& basins, const RunContext& run)
      : all_(static_cast<size_t>(basins.count())) {
    Groups groups(basins.count());
    std::vector<int32_t> top(all_.size());
    for (size_t i = 0; i < top.size(); ++i) top[i] = static_cast<int32_t>(i);
    for (const Pass& pass : passes) {
      run.check_cancelled();
      const int32_t a = groups.find(pass.a), b = groups.find(pass.b);
      if (a == b) continue;
      groups.join(a, b);
      meet(top[static_cast<size_t>(a)], top[static_cast<size_t>(b)], pass, top[static_cast<size_t>(std::min(a, b))]);
    }
    for (int32_t i = 1; i < basins.count(); ++i) at(i).one_lake = true;
  }

  Depression& at(int32_t i) { return all_[static_cast<size_t>(i)]; }
  const Depression& at(int32_t i) const { return all_[static_cast<size_t>(i)]; }
  int32_t count() const { return static_cast<int32_t>(all_.size()); }

  /// Depressions that overflow to the outside, the lowest pass first.
  const std::vector<int32_t>& outermost() const { return outermost_; }

  /// The depression that ground of a basin is flooded with at this height.
  int32_t flooded_with(int32_t depression, float height) const {
    while (depression > kOutside && at(depression).pass <= height) depression = at(depression).parent;
    return depression;
  }

 private:
  /// `top` becomes what the two make up.
  void meet(int32_t a, int32_t b, const Pass& pass, int32_t& top) {
    const auto spill = [&](int32_t from, int32_t parent, int32_t target) {
      at(from).pass = pass.height;
      at(from).parent = parent;
      at(from).target = target;
    };
    if (a == kOutside || b == kOutside) {
      spill(std::max(a, b), kOutside, a == kOutside ? pass.a : pass.b);
      outermost_.push_back(std::max(a, b));
      top = kOutside;
      return;
    }
    const int32_t joined = count();
    all_.emplace_back();
    at(joined).left = a;
    at(joined).right = b;
    spill(a, joined, pass.b);
    spill(b, joined, pass.a);
    top = joined;
  }

  std::vector<Depression> all_;
  std::vector<int32_t> outermost_;
};

/// The cells that each depression floods and its parts do not, from low to high.
struct Bands {
  std::vector<int64_t> start;
  std::vector<int32_t> cells;
};

Bands find_bands(const HeightField& terrain, const Basins& basins, const DepressionTree& tree, const RunContext& run) {
  std::vector<int32_t> wet;
  std::vector<float> level(static_cast<size_t>(tree.count()), kNoSea);
  for (int32_t i = tree.count() - 1; i > kOutside; --i) {
    const Depression& here = tree.at(i);
    level[static_cast<size_t>(i)] = here.parent == kOutside ? here.pass : level[static_cast<size_t>(here.parent)];
  }
  for (int64_t i = 0; i < terrain.frame().cells(); ++i) {
    if (i % 65536 == 0) run.check_cancelled();
    if (terrain.data()[i] < level[static_cast<size_t>(basins.of.data()[i])]) wet.push_back(static_cast<int32_t>(i));
  }
  std::sort(wet.begin(), wet.end(), [&](int32_t a, int32_t b) {
    run.check_cancelled();
    const float za = terrain.data()[a], zb = terrain.data()[b];
    return za != zb ? za < zb : a < b;
  });
  // Heights rise, so the depression that a basin is flooded with only ever moves up the tree.
  std::vector<int32_t> now(static_cast<size_t>(basins.count()));
  for (size_t i = 0; i < now.size(); ++i) now[i] = static_cast<int32_t>(i);
  std::vector<int32_t> of(wet.size());
  Bands bands{std::vector<int64_t>(static_cast<size_t>(tree.count()) + 1, 0), std::vector<int32_t>(wet.size())};
  for (size_t i = 0; i < wet.size(); ++i) {
    int32_t& depression = now[static_cast<size_t>(basins.of.data()[wet[i]])];
    depression = tree.flooded_with(depression, terrain.data()[wet[i]]);
    of[i] = depression;
    ++bands.start[static_cast<size_t>(depression) + 1];
  }
  for (size_t i = 1; i < bands.start.size(); ++i) bands.start[i] += bands.start[i - 1];
  std::vector<int64_t> next(bands.start.begin(), bands.start.end() - 1);
  for (size_t i = 0; i < wet.size(); ++i) bands.cells[static_cast<size_t>(next[static_cast<size_t>(of[i])]++)] = wet[i];
  return bands;
}

/// Water through the tree: in cells x mm/yr.
class Balance {
 public:
  Balance(const HeightField& terrain, const Basins& basins, const LakeClimate& climate, DepressionTree& tree,
          const Bands& bands, const RunContext& run)
      : terrain_(terrain), climate_(climate), tree_(tree), bands_(bands) {
    for (int64_t i = 0; i < terrain.frame().cells(); ++i) {
      if (i % 65536 == 0) run.check_cancelled();
      tree_.at(basins.of.data()[i]).supply += runoff(static_cast<int32_t>(i));
    }
    for (int32_t i = 1; i < tree_.count(); ++i) {
      Depression& here = tree_.at(i);
      here.loss = loss_of_parts(here);
      for_each_cell(i, [&](int32_t cell) { here.loss += loss(cell); });
    }
    for (int32_t i = basins.count(); i < tree_.count(); ++i) settle(i);
    // Whoever overflows to the outside may feed a depression there, whose pass is lower.
    const std::vector<int32_t>& outermost = tree_.outermost();
    for (size_t i = outermost.size(); i-- > 0;) {
      Depression& here = tree_.at(outermost[i]);
      here.passed_on = overflow(here);
      if (here.passed_on > 0.0 && here.target != kOutside) pour(here.target, here.passed_on);
    }
  }

  double runoff(int32_t cell) const {
    return climate_.runoff_map != nullptr ? static_cast<double>(climate_.runoff_map->data()[cell])
                                          : climate_.runoff_mm_yr;
  }
  double loss(int32_t cell) const { return std::max(0.0, runoff(cell) + climate_.loss_mm_yr); }

  static double overflow(const Depression& here) {
    return here.one_lake ? std::max(0.0, here.supply - here.loss) : 0.0;
  }

  /// The depression whose lake, if any, covers the pit of a basin.
  int32_t lake_over(int32_t depression) const {
    while (tree_.at(depression).parent > kOutside && tree_.at(tree_.at(depression).parent).one_lake)
      depression = tree_.at(depression).parent;
    return depression;
  }

  float level(int32_t depression) const {
    const Depression& here = tree_.at(depression);
    if (overflow(here) > 0.0) return here.pass;
    double left = here.supply - loss_of_parts(here);
    for (int64_t i = bands_.start[static_cast<size_t>(depression)];
         i < bands_.start[static_cast<size_t>(depression) + 1];) {
      const float height = terrain_.data()[bands_.cells[static_cast<size_t>(i)]];
      for (; i < bands_.start[static_cast<size_t>(depression) + 1] &&
             terrain_.data()[bands_.cells[static_cast<size_t>(i)]] == height;
           ++i)
        left -= loss(bands_.cells[static_cast<size_t>(i)]);
      if (left < 0.0) return height;
    }
    return here.pass;
  }

 private:
  double loss_of_parts(const Depression& here) const {
    return here.left == kNone ? 0.0 : tree_.at(here.left).loss + tree_.at(here.right).loss;
  }

  template <class Visit>
  void for_each_cell(int32_t depression, const Visit& visit) const {
    for (int64_t i = bands_.start[static_cast<size_t>(depression)];
         i < bands_.start[static_cast<size_t>(depression) + 1]; ++i)
      visit(bands_.cells[static_cast<size_t>(i)]);
  }

  int32_t sibling(int32_t depression) const {
    const Depression& parent = tree_.at(tree_.at(depression).parent);
    return parent.left == depression ? parent.right : parent.left;
  }

  /// Lets the two parts of a depression, each settled, overflow into each other.
  void settle(int32_t joined) {
    for (const int32_t part : {tree_.at(joined).left, tree_.at(joined).right})
      if (overflow(tree_.at(part)) > 0.0) return pass_on(part, joined);
  }

  /// More water for a basin outside of the tree that it comes from.
  void pour(int32_t basin, double amount) {
    const int32_t lake = lake_over(basin);
    tree_.at(lake).supply += amount;
    pass_on(lake, kNone);
  }

  /// Passes what a lake cannot hold on to its sibling, and so on, until some lake holds it or the water stands over
  /// the last pass within `within` (kNone: the whole tree).
  void pass_on(int32_t lake, int32_t within) {
    while (true) {
      Depression& here = tree_.at(lake);
      const double more = overflow(here) - here.passed_on;
      if (more <= 0.0 || lake == within || here.parent == kOutside) return;
      const Depression& other = tree_.at(sibling(lake));
      if (overflow(other) > 0.0) {
        Depression& joined = tree_.at(here.parent);
        joined.one_lake = true;
        joined.supply = here.supply + other.supply - here.passed_on - other.passed_on;
        lake = here.parent;
        continue;
      }
      here.passed_on += more;
      lake = lake_over(here.target);
      tree_.at(lake).supply += more;
    }
  }

  const HeightField& terrain_;
  const LakeClimate& climate_;
  DepressionTree& tree_;
  const Bands& bands_;
};

/// The lakes as they stand, and which of them a depression's basins belong to.
void read_off(const HeightField& terrain, const Basins& basins, const DepressionTree& tree, const Balance& balance,
              LakeLevels& out) {
  const double cell_m3 = terrain.cell_m() * terrain.cell_m() * 1e-3;
  std::vector<int32_t> number(static_cast<size_t>(tree.count()), kNone), of(static_cast<size_t>(basins.count()), kNone);
  std::vector<double> flooded;
  for (int32_t i = 1; i < basins.count(); ++i) {
    const int32_t top = balance.lake_over(i);
    int32_t& known = number[static_cast<size_t>(top)];
    const int32_t pit = basins.pits[static_cast<size_t>(i)];
    if (known == kNone) {
      known = static_cast<int32_t>(out.lakes.size());
      const Depression& here = tree.at(top);
      const double overflow = Balance::overflow(here);
      out.lakes.push_back({.level_m = balance.level(top), .pass_m = here.pass, .pit = pit, .closed = overflow <= 0.0});
      out.lakes.back().inflow = here.supply * cell_m3;
      out.lakes.back().outflow = overflow * cell_m3;
    }
    StandingLake& lake = out.lakes[static_cast<size_t>(known)];
    if (terrain.data()[pit] < terrain.data()[lake.pit]) lake.pit = pit;
    of[static_cast<size_t>(i)] = known;
  }
  for (int64_t i = 0; i < terrain.frame().cells(); ++i) {
    const int32_t lake = of[static_cast<size_t>(basins.of.data()[i])];
    const bool wet = lake != kNone && terrain.data()[i] < out.lakes[static_cast<size_t>(lake)].level_m;
    out.lake.data()[i] = wet ? lake : kNone;
    if (!wet) continue;
    StandingLake& here = out.lakes[static_cast<size_t>(lake)];
    ++here.cells;
    here.inflow -= balance.runoff(static_cast<int32_t>(i)) * cell_m3;
  }
}

}  // namespace

LakeLevels lake_levels(const HeightField& terrain, float sea_level_m, const LakeClimate& climate,
                       const RunContext& run) {
  LakeLevels out{{}, Grid<int32_t>(terrain.frame(), kNone)};
  const Basins basins = find_basins(flow_directions(terrain, sea_level_m, run.part(0.0, 0.2)), run.part(0.2, 0.3));
  if (basins.count() == 1) return out;
  DepressionTree tree(find_ways(terrain, basins, sea_level_m, run.part(0.3, 0.6)), basins, run);
  const Bands bands = find_bands(terrain, basins, tree, run.part(0.6, 0.9));
  const Balance balance(terrain, basins, climate, tree, bands, run.part(0.9, 1.0));
  read_off(terrain, basins, tree, balance, out);
  return out;
}

}  // namespace seamount::geom
