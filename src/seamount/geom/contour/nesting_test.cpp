#include "seamount/geom/contour/nesting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/base/rng.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/polygon/predicates.h"

namespace seamount::geom {
namespace {

using ::testing::ElementsAre;

Ring circle(Vec2 centre, double radius, int points = 40) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double a = 2.0 * std::numbers::pi * i / points;
    ring.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)});
  }
  return ring;
}

Contour contour(double height_m, Ring ring) { return {height_m, std::move(ring), -1}; }

/// An island with two hills, one with a crater that holds a hill of its own; given in no order.
std::vector<Contour> two_hills() {
  return {contour(300, circle({-40, 0}, 10)), contour(200, circle({0, 0}, 100)), contour(200, circle({-40, 0}, 5)),
          contour(300, circle({40, 10}, 30)), contour(300, circle({-40, 0}, 2)), contour(100, circle({0, 0}, 120)),
          contour(50, circle({400, 0}, 20))};
}

/// The contour with the least area among those that hold the tip of another.
std::vector<int> parents_by_testing_all(const std::vector<Contour>& contours) {
  std::vector<int> parents(contours.size(), -1);
  for (size_t i = 0; i < contours.size(); ++i) {
    double least = 0.0;
    for (size_t j = 0; j < contours.size(); ++j) {
      const double size = std::abs(signed_area(contours[j].ring));
      if (i == j || !contains(contours[j].ring, contours[i].ring[0])) continue;
      if (parents[i] >= 0 && size >= least) continue;
      parents[i] = static_cast<int>(j);
      least = size;
    }
  }
  return parents;
}

/// Wavy rings on a lattice, each with a random number of smaller copies inside, some turned round.
std::vector<Contour> random_archipelago(uint64_t seed) {
  Rng rng(Seed{seed});
  std::vector<Contour> contours;
  for (int island = 0; island < 12; ++island) {
    const Vec2 centre{(island % 4) * 100.0 + rng.uniform(-3, 3), (island / 4) * 100.0 + rng.uniform(-3, 3)};
    const double waves = rng.integer(2, 9);
    const int depth = rng.integer(1, 6);
    for (int level = 0; level < depth; ++level) {
      Ring ring = circle({0, 0}, 45.0 * std::pow(0.7, level), rng.integer(30, 60));
      for (Vec2& p : ring) p = centre + (1.0 + 0.05 * std::sin(waves * std::atan2(p.y, p.x))) * p;
      if (rng.chance(0.5)) std::reverse(ring.begin(), ring.end());
      contours.insert(contours.begin() + rng.integer(0, static_cast<int>(contours.size())), contour(level, ring));
    }
  }
  return contours;
}

TEST(ContourNesting, ParentsAreTheSmallestRingsAround) {
  EXPECT_THAT(find_contour_parents(two_hills()), ElementsAre(1, 5, 0, 1, 2, -1, -1));
  for (uint64_t seed = 0; seed < 50; ++seed) {
    const std::vector<Contour> contours = random_archipelago(seed);
    EXPECT_EQ(find_contour_parents(contours), parents_by_testing_all(contours)) << seed;
  }
  EXPECT_TRUE(find_contour_parents({}).empty());
}

TEST(ContourNesting, FamiliesStandTogetherParentsFirst) {
  std::vector<Contour> contours = two_hills();
  nest_contours(contours);
  std::vector<int> parents;
  std::vector<double> heights;
  for (const Contour& c : contours) parents.push_back(c.parent), heights.push_back(c.height_m);
  EXPECT_THAT(parents, ElementsAre(-1, 0, 1, 2, 3, 1, -1));
  EXPECT_THAT(heights, ElementsAre(100, 200, 300, 200, 300, 300, 50));
}

TEST(ContourNesting, HigherGroundComesToTheLeft) {
  std::vector<Contour> contours = two_hills();
  std::reverse(contours[1].ring.begin(), contours[1].ring.end());
  nest_contours(contours);
  orient_contours(contours);
  std::vector<bool> hills;
  for (const Contour& c : contours) hills.push_back(is_hill(c));
  EXPECT_THAT(hills, ElementsAre(true, true, true, false, true, true, true));
}

TEST(ContourNesting, FindsWhatMeets) {
  EXPECT_FALSE(find_contour_crossing({}));
  EXPECT_FALSE(find_contour_crossing(two_hills()));
  for (uint64_t seed = 0; seed < 20; ++seed) EXPECT_FALSE(find_contour_crossing(random_archipelago(seed))) << seed;

  std::vector<Contour> crossing = two_hills();
  crossing.push_back(contour(10, {{390, -30}, {410, -30}, {400, -15}}));
  const auto found = find_contour_crossing(crossing);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, 6U);
  EXPECT_EQ(found->second, 7U);
  EXPECT_NEAR(std::hypot(found->at.x - 400, found->at.y), 20, 0.1);
}

TEST(ContourNesting, FindsRingsThatMeetThemselves) {
  const auto bow = find_contour_crossing({contour(0, {{0, 0}, {10, 10}, {10, 0}, {0, 10}})});
  ASSERT_TRUE(bow);
  EXPECT_EQ(bow->first, bow->second);
  EXPECT_EQ(bow->first_edge, 0U);
  EXPECT_EQ(bow->second_edge, 2U);
  EXPECT_EQ(bow->at, (Vec2{5, 5}));
  EXPECT_TRUE(find_contour_crossing({contour(0, {{0, 0}, {5, 5}, {10, 0}, {10, 10}, {5, 5}, {0, 10}})})) << "touches";
  EXPECT_TRUE(find_contour_crossing({contour(0, {{0, 0}, {10, 0}, {5, 0}})})) << "runs back";
  EXPECT_FALSE(find_contour_crossing({contour(0, {{0, 0}, {0, 0}, {10, 0}, {5, 5}})})) << "a point twice in a row";
  EXPECT_TRUE(find_contour_crossing({contour(0, circle({0, 0}, 5)), contour(1, circle({0, 0}, 5))}))
      << "one on another";
}

TEST(ContourNesting, CrossingsAreFoundAmongMany) {
  for (uint64_t seed = 0; seed < 30; ++seed) {
    std::vector<Contour> contours = random_archipelago(seed);
    Rng rng(Seed{seed}.derive("spoil"));
    Contour& spoilt = contours[static_cast<size_t>(rng.integer(0, static_cast<int>(contours.size()) - 1))];
    Contour copy = spoilt;
    for (Vec2& p : copy.ring) p = p + Vec2{0.3, 0.1};
    contours.push_back(copy);
    EXPECT_TRUE(find_contour_crossing(contours)) << seed;
  }
}

TEST(ContourNesting, APointBesideARingLiesOutsideItWhicheverEdgeOfTheTipIsListedFirst) {
  // Level with a tip that points south, both of its edges are as near: once, the one listed first decided.
  Ring tip = {{-5, 10}, {0, 0}, {5, 10}};
  for (int turn = 0; turn < 3; ++turn) {
    for (const bool hill : {true, false}) {
      Ring ring = tip;
      if (!hill) std::reverse(ring.begin(), ring.end());
      EXPECT_THAT(find_contour_parents({contour(1, ring), contour(2, {{3, 0}, {7, -3}, {7, 3}})}), ElementsAre(-1, -1));
    }
    std::rotate(tip.begin(), tip.begin() + 1, tip.end());
  }
}

TEST(ContourNesting, WhatMissesByLessThanRoundingDoesNotMeet) {
  // The corner lies 1e-19 beside an edge; sides found with rounding had it on it.
  const Vec2 corner{0.001, 0.003}, end{0.1, 0.3};
  ASSERT_EQ(cross(Vec2{} - end, corner - end), 0.0);
  const bool left = orientation_sign(end, {0, 0}, corner) > 0;
  const Contour edge = contour(0, {end, {0, 0}, left ? Vec2{-1, 1} : Vec2{1, -1}});
  EXPECT_FALSE(find_contour_crossing({edge, contour(0, {corner, {0.9, left ? -1.0 : 3.0}, {0.5, left ? -1.0 : 3.0}})}));
}

TEST(ContourNesting, FindsWhatMeetsOnTheLinesBetweenTheCellsThatItSearches) {
  // Edges nearly along such a line, across each other on it or a hair beside it.
  Rng rng(Seed{5});
  for (int trial = 0; trial < 500; ++trial) {
    const double y = 50.0 + rng.integer(-2, 2) * 7e-15;
    const auto hair = [&] { return rng.integer(1, 4) * 7.2e-15; };
    const Contour low = contour(0, {{10, y - hair()}, {90, y + hair()}, {50, 100}});
    const Contour high = contour(0, {{11, y + hair()}, {50, 0}, {91, y - hair()}});
    EXPECT_TRUE(find_contour_crossing({low, high})) << trial;
  }
}

}  // namespace
}  // namespace seamount::geom
