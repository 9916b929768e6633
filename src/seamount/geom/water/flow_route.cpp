#include <algorithm>
#include <vector>

#include "seamount/geom/water/flow.h"
#include "seamount/geom/water/flow_passes.h"
#include "seamount/geom/water/groups.h"

namespace seamount::geom {
namespace {

/// The passes of a minimum spanning forest and, for every basin, those that it has a part in.
class PassForest {
 public:
  PassForest(const HeightField& terrain, const Basins& basins, float highest_pass_m, const RunContext& run)
      : groups_(basins.count()) {
    for (const Pass& pass : find_passes(terrain, basins, run)) {
      run.check_cancelled();
      if (!(pass.height < highest_pass_m)) break;
      const int32_t a = groups_.find(pass.a), b = groups_.find(pass.b);
      if (a == b) continue;
      groups_.join(a, b);
      passes_.push_back(pass);
    }
    start_.assign(static_cast<size_t>(basins.count()) + 1, 0);
    for (const Pass& pass : passes_)
      ++start_[static_cast<size_t>(pass.a) + 1], ++start_[static_cast<size_t>(pass.b) + 1];
    for (size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    items_.resize(2 * passes_.size());
    std::vector<int32_t> next(start_.begin(), start_.end() - 1);
    for (const Pass& pass : passes_) {
      for (const int32_t basin : {pass.a, pass.b})
        items_[static_cast<size_t>(next[static_cast<size_t>(basin)]++)] = &pass;
    }
  }

  /// Where the water of each group gathers: the outside, or its lowest pit.
  std::vector<int32_t> roots(const HeightField& terrain, const Basins& basins) {
    std::vector<int32_t> root(static_cast<size_t>(basins.count()), -1);
    const auto height = [&](int32_t basin) { return terrain.data()[basins.pits[static_cast<size_t>(basin)]]; };
    root[kOutside] = kOutside;
    for (int32_t basin = 1; basin < basins.count(); ++basin) {
      int32_t& best = root[static_cast<size_t>(groups_.find(basin))];
      if (best != kOutside && (best < 0 || height(basin) < height(best))) best = basin;
    }
    std::erase(root, -1);
    return root;
  }

  template <class Visit>
  void for_each_pass(int32_t basin, const Visit& visit) const {
    const auto i = static_cast<size_t>(basin);
    for (int32_t k = start_[i]; k < start_[i + 1]; ++k) visit(*items_[static_cast<size_t>(k)]);
  }

 private:
  Groups groups_;
  std::vector<Pass> passes_;
  std::vector<int32_t> start_;
  std::vector<const Pass*> items_;
};

/// Turns round the way from `cell` down to its pit and lets `cell` flow in direction `out`.
void turn_round(FlowDirections& directions, int64_t cell, uint8_t out) {
  const std::array<int64_t, 8> steps = flow_steps(directions.width());
  uint8_t* code = directions.data();
  while (true) {
    const uint8_t down = code[cell];
    code[cell] = out;
    if (down >= 8) return;
    cell += steps[down];
    out = static_cast<uint8_t>((down + 4) % 8);
  }
}

/// Lets the basin `from` flow over a pass that leads to the basin `to`.
void open_pass(const HeightField& terrain, const Basins& basins, const Pass& pass, int32_t from,
               FlowDirections& directions) {
  const int32_t to = pass.a == from ? pass.b : pass.a;
  const int width = terrain.width(), x = pass.cell % width, y = pass.cell / width;
  const std::array<int64_t, 8> steps = flow_steps(width);
  const int32_t* basin = basins.of.data();
  const bool near_side = basin[pass.cell] == from;
  for (const uint8_t k : {uint8_t{0}, uint8_t{5}, uint8_t{6}, uint8_t{7}}) {
    if (!terrain.contains(x + kFlowDx[k], y + kFlowDy[k])) continue;
    const int64_t other = pass.cell + steps[k];
    if (basin[other] != (near_side ? to : from)) continue;
    if (std::max(terrain.data()[pass.cell], terrain.data()[other]) != pass.height) continue;
    turn_round(directions, near_side ? pass.cell : other, near_side ? k : static_cast<uint8_t>((k + 4) % 8));
    return;
  }
}

}  // namespace

void route_through_pits(const HeightField& terrain, FlowDirections& directions, float highest_pass_m,
                        const RunContext& run) {
  const Basins basins = find_basins(directions, run.part(0.0, 0.5));
  if (basins.count() == 1) return;
  PassForest forest(terrain, basins, highest_pass_m, run.part(0.5, 1.0));
  std::vector<bool> done(static_cast<size_t>(basins.count()));
  std::vector<int32_t> queue = forest.roots(terrain, basins);
  for (const int32_t root : queue) done[static_cast<size_t>(root)] = true;
  for (size_t next = 0; next < queue.size(); ++next) {
    if (next % 4096 == 0) run.check_cancelled();
    const int32_t here = queue[next];
    forest.for_each_pass(here, [&](const Pass& pass) {
      const int32_t from = pass.a == here ? pass.b : pass.a;
      if (done[static_cast<size_t>(from)]) return;
      done[static_cast<size_t>(from)] = true;
      queue.push_back(from);
      open_pass(terrain, basins, pass, from, directions);
    });
  }
}

}  // namespace seamount::geom
