#include "seamount/geom/polygon/joined_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

Ring circle(Vec2 centre, double radius, int count) {
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count;
    ring.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

/// Pieces of a ring that share their ends, in mixed order and direction.
std::vector<ValuedLine> cut(const Ring& ring, int pieces, double value, Seed seed) {
  std::vector<ValuedLine> lines;
  const size_t n = ring.size();
  for (int k = 0; k < pieces; ++k) {
    const size_t from = n * static_cast<size_t>(k) / static_cast<size_t>(pieces);
    const size_t to = n * static_cast<size_t>(k + 1) / static_cast<size_t>(pieces);
    ValuedLine line{{}, value, false, {}};
    for (size_t i = from; i <= to; ++i) line.points.push_back(ring[i % n]);
    Rng rng(seed.derive("turn", static_cast<uint64_t>(k)));
    if (rng.uniform() < 0.5) std::reverse(line.points.begin(), line.points.end());
    lines.push_back(std::move(line));
  }
  for (size_t i = lines.size(); i > 1; --i) {
    Rng rng(seed.derive("order", i));
    std::swap(lines[i - 1], lines[static_cast<size_t>(rng.uniform() * static_cast<double>(i))]);
  }
  return lines;
}

TEST(JoinLines, PiecesOfRingsBecomeTheRings) {
  for (const uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    std::vector<ValuedLine> lines = cut(circle({0, 0}, 100, 60), 7, 1, Seed{seed});
    const std::vector<ValuedLine> second = cut(circle({500, 0}, 50, 31), 4, 2, Seed{seed + 10});
    lines.insert(lines.end(), second.begin(), second.end());
    const LineAreas found = areas_from_lines(lines);
    ASSERT_EQ(found.areas.size(), 2U);
    EXPECT_TRUE(found.open.empty());
    double sum = 0;
    size_t points = 0;
    for (const NamedArea& a : found.areas) {
      sum += std::abs(signed_area(a.parts[0].outer));
      points += a.parts[0].outer.size();
      EXPECT_FALSE(find_defect(a.parts[0]).has_value());
    }
    EXPECT_EQ(points, 91U);
    EXPECT_NEAR(sum, std::abs(signed_area(circle({0, 0}, 100, 60))) + std::abs(signed_area(circle({500, 0}, 50, 31))),
                1e-6);
  }
}

TEST(JoinLines, OtherValuesAndWideGapsStayApart) {
  const std::vector<ValuedLine> lines = {{{{0, 0}, {10, 0}}, 5, false, {}}, {{{10, 0}, {20, 0}}, 6, false, {}}};
  EXPECT_EQ(join_lines(lines, true, 1.0).size(), 2U);
  EXPECT_EQ(join_lines(lines, false, 1.0).size(), 1U);
  const std::vector<ValuedLine> apart = {{{{0, 0}, {10, 0}}, 5, false, {}}, {{{12, 0}, {20, 0}}, 5, false, {}}};
  EXPECT_EQ(join_lines(apart, true, 1.0).size(), 2U);
  const std::vector<ValuedLine> joined = join_lines(apart, true, 3.0);
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_EQ(joined[0].points, (Polyline{{0, 0}, {10, 0}, {12, 0}, {20, 0}}));
}

TEST(JoinLines, ClosedOnesAndLonelyOnesStay) {
  const std::vector<ValuedLine> lines = {{{{0, 0}, {10, 0}, {5, 5}}, 5, true, {{"a", 1}}},
                                         {{{0, 0}, {9, 9}, {3, 4}, {0, 0}}, 5, false, {}},
                                         {{{100, 0}, {110, 0}}, 5, false, {}}};
  const LineAreas found = areas_from_lines(lines);
  ASSERT_EQ(found.areas.size(), 2U);
  EXPECT_EQ(found.areas[0].attributes, lines[0].attributes);
  EXPECT_EQ(found.areas[1].parts[0].outer.size(), 3U);
  ASSERT_EQ(found.open.size(), 1U);
  EXPECT_EQ(found.open[0], lines[2]);
}

}  // namespace
}  // namespace seamount::geom
