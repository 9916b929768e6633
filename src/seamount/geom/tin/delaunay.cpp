#include "seamount/geom/tin/delaunay.h"

#include <algorithm>
#include <bit>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

using Builder = DelaunayBuilder<kLatticeBits>;

size_t at(int32_t i) { return static_cast<size_t>(i); }

/// Each with its smallest corner first, in the order of these.
std::vector<Triangle> sorted_triangles(const Builder& builder, const RunContext& run) {
  std::vector<int32_t> starts(builder.points().size() + 1, 0);
  const auto for_each = [&](auto&& visit) {
    for (int32_t t = 0; t < builder.triangle_count(); ++t) {
      if (t % 65536 == 0) run.check_cancelled();
      if (builder.is_ghost(t)) continue;
      Triangle abc = builder.corners(t);
      std::rotate(abc.begin(), std::min_element(abc.begin(), abc.end()), abc.end());
      visit(abc);
    }
  };
  for_each([&](const Triangle& abc) { ++starts[at(abc[0]) + 1]; });
  for (size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  std::vector<Triangle> sorted(at(starts.back()));
  for_each([&](const Triangle& abc) { sorted[at(starts[at(abc[0])]++)] = abc; });
  return sorted;
}

/// The points of an order in rounds, each along the order: one in four is in a later round than the first.
std::vector<std::vector<int32_t>> rounds_of(const std::vector<int32_t>& order) {
  constexpr int kRounds = 16;
  std::vector<std::vector<int32_t>> rounds(kRounds);
  for (const int32_t p : order) {
    const uint64_t bits = mix_bits(static_cast<uint64_t>(p) + 1) | (1ULL << (2 * kRounds - 1));
    rounds[static_cast<size_t>(std::countr_zero(bits) / 2)].push_back(p);
  }
  return rounds;
}

}  // namespace

std::vector<Triangle> delaunay(std::span<const LatticePoint> points, const RunContext& run) {
  constexpr size_t kPointsPerReport = 1 << 12;
  const std::vector<int32_t> order = spatial_order(points, run);
  Builder builder({points.begin(), points.end()});
  if (points.size() < 3 || !builder.start(order)) return {};
  size_t done = 0;
  const std::vector<std::vector<int32_t>> rounds = rounds_of(order);
  run.check_cancelled();
  for (size_t round = rounds.size(); round-- > 0;) {
    for (const int32_t p : rounds[round]) {
      builder.insert(p);
      if (++done % kPointsPerReport != 0) continue;
      run.check_cancelled();
      run.report(static_cast<double>(done) / static_cast<double>(points.size()));
    }
  }
  return sorted_triangles(builder, run);
}

std::vector<Triangle> delaunay(std::span<const Vec2> points, const RunContext& run) {
  std::vector<LatticePoint> snapped;
  snap(points, snapped);
  return delaunay(snapped, run);
}

}  // namespace seamount::geom
