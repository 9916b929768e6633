#include "seamount/ops/ecosystem/thing_budget.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace seamount::ecosystem {
namespace {

size_t triangles(const Things& all, const Thing& thing) {
  return all.shapes[thing.shape].levels[thing.level].triangle_count();
}

/// Leaves the first that fit in an order by lot, and keeps their own order.
void thin_out(Things& all, uint64_t most, Seed seed) {
  std::vector<size_t> order(all.things.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::vector<uint64_t> lots(order.size());
  for (size_t i = 0; i < lots.size(); ++i) lots[i] = Rng(seed.derive("thin", i)).bits();
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return lots[a] < lots[b]; });
  std::vector<bool> kept(order.size(), false);
  uint64_t sum = 0;
  for (const size_t i : order) {
    sum += triangles(all, all.things[i]);
    if (sum > most) break;
    kept[i] = true;
  }
  std::vector<Thing> left;
  for (size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) left.push_back(all.things[i]);
  all.things = std::move(left);
}

}  // namespace

void keep_budget(Things& all, uint64_t max_triangles, Seed seed, const RunContext& run) {
  uint64_t sum = all.triangle_count();
  if (max_triangles == 0 || sum <= max_triangles) return;
  const std::string before = std::to_string(sum);
  std::vector<size_t> order(all.things.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto size = [&](size_t i) { return all.things[i].scale * all.shapes[all.things[i].shape].height_m; };
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    const float sa = size(a), sb = size(b);
    return sa != sb ? sa < sb : a < b;
  });
  size_t coarser = 0;
  for (uint32_t level = 1; sum > max_triangles; ++level) {
    bool any = false;
    for (const size_t i : order) {
      if (sum <= max_triangles) break;
      Thing& thing = all.things[i];
      if (level >= all.shapes[thing.shape].levels.size()) continue;
      any = true;
      sum -= triangles(all, thing);
      thing.level = level;
      sum += triangles(all, thing);
      if (level == 1) ++coarser;
    }
    run.check_cancelled();
    if (!any) break;
  }
  run.say("max_triangles: " + std::to_string(coarser) + " of " + std::to_string(all.things.size()) +
          " things are drawn with less detail (" + before + " triangles are now " + std::to_string(sum) + ")");
  if (sum <= max_triangles) return;
  const size_t count = all.things.size();
  thin_out(all, max_triangles, seed);
  run.say("max_triangles: " + std::to_string(max_triangles) + " are not enough for " + std::to_string(count) +
          " things, " + std::to_string(all.things.size()) + " are left");
}

}  // namespace seamount::ecosystem
