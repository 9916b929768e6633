#include "seamount/geom/contour/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/geom/contour/contour.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/polygon.h"

namespace seamount::geom {
namespace {

/// Contours so close that lines between distant points would cut through their neighbours.
std::vector<Contour> crowded() {
  const GridFrame frame = GridFrame::centred(80, 60, 1.0);
  ScalarField field(frame);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 80; ++x) {
      const Vec2 p{frame.x(x), frame.y(y)};
      field(x, y) = static_cast<float>(40 * std::sin(0.25 * p.x) * std::cos(0.2 * p.y + 0.03 * p.x) - 0.02 * p.y * p.y);
    }
  }
  std::vector<double> levels;
  for (int i = -40; i <= 40; i += 2) levels.push_back(i);
  std::vector<Contour> contours = trace_contours(field, levels);
  nest_contours(contours);
  return contours;
}

double distance_to(const Ring& ring, Vec2 p) {
  double best = INFINITY;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i];
    const Vec2 along = ring[(i + 1) % ring.size()] - a;
    const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
    best = std::min(best, std::hypot(p.x - a.x - t * along.x, p.y - a.y - t * along.y));
  }
  return best;
}

TEST(SimplifyContours, NeverMakesThemMeet) {
  const std::vector<Contour> given = crowded();
  ASSERT_FALSE(find_contour_crossing(given));
  size_t before = 0;
  for (const Contour& c : given) before += c.ring.size();
  for (const double tolerance : {0.05, 0.3, 1.0, 5.0, 50.0}) {
    std::vector<Contour> fewer = given;
    simplify_contours(fewer, tolerance, {});
    EXPECT_FALSE(find_contour_crossing(fewer)) << tolerance;
    size_t after = 0;
    for (size_t i = 0; i < fewer.size(); ++i) {
      ASSERT_GE(fewer[i].ring.size(), 3U);
      EXPECT_EQ(is_hill(fewer[i]), is_hill(given[i]));
      for (const Vec2 p : given[i].ring) EXPECT_LE(distance_to(fewer[i].ring, p), tolerance + 1e-9);
      after += fewer[i].ring.size();
    }
    EXPECT_EQ(find_contour_parents(fewer), find_contour_parents(given));
    EXPECT_LT(after, tolerance < 0.3 ? before : before * 2 / 3);
  }
}

TEST(SimplifyContours, DoesNotPassOverAnother) {
  // A long bay of the outer contour, dropped, would leave the small island in it inside.
  const std::vector<Contour> given = {
      {0, {{0, 0}, {100, 0}, {100, 100}, {52, 100}, {50.5, 90}, {50, 89}, {49.5, 90}, {48, 100}, {0, 100}}, -1},
      {0, {{49.9, 95}, {50.1, 95}, {50, 95.2}}, -1}};
  ASSERT_FALSE(find_contour_crossing(given));
  std::vector<Contour> fewer = given;
  simplify_contours(fewer, 20.0, {});
  EXPECT_FALSE(find_contour_crossing(fewer));
  EXPECT_EQ(find_contour_parents(fewer), find_contour_parents(given));
}

}  // namespace
}  // namespace seamount::geom
