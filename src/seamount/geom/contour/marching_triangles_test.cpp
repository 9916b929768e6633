#include "seamount/geom/contour/marching_triangles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seamount/geom/contour/contour.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/tin/test_tin.h"
#include "seamount/geom/tin/tin_border.h"

namespace seamount::geom {
namespace {

using ::testing::HasSubstr;

Tin cone() {
  return lattice_tin(81, 61, 2.0, Seed{1}, [](Vec2 p) { return 100.0 - std::hypot(p.x, p.y); });
}

/// What every set of contours must be, and that a place is inside a level's rings exactly where `high` says.
template <class High>
void expect_sound(const std::vector<Contour>& contours, const std::vector<double>& levels,
                  const std::vector<Vec2>& places, High&& high) {
  const auto crossing = find_contour_crossing(contours);
  EXPECT_FALSE(crossing) << crossing->at.x << " " << crossing->at.y;
  for (const Contour& c : contours) {
    ASSERT_GE(c.ring.size(), 3U);
    for (size_t i = 0; i < c.ring.size(); ++i) EXPECT_FALSE(c.ring[i] == c.ring[(i + 1) % c.ring.size()]);
  }
  std::vector<Contour> turned = contours;
  nest_contours(turned);
  for (const double level : levels) {
    for (size_t i = 0; i < places.size(); ++i) {
      int around = 0;
      for (const Contour& c : turned) {
        if (c.height_m == level && contains(c.ring, places[i])) around += is_hill(c) ? 1 : -1;
      }
      EXPECT_EQ(around, high(i, level) ? 1 : 0) << level << " at " << i;
    }
  }
}

TEST(MarchTriangles, AConeGivesCircles) {
  const std::vector<double> levels = {50, 60, 70, 99.5};
  const std::vector<Contour> contours = march_triangles(cone(), levels, {});
  ASSERT_EQ(contours.size(), 4U);
  for (const Contour& c : contours) {
    EXPECT_TRUE(is_hill(c));
    for (const Vec2 p : c.ring) EXPECT_NEAR(std::hypot(p.x, p.y), 100 - c.height_m, 0.5) << c.height_m;
  }
}

TEST(MarchTriangles, InterpolatesAlongEdges) {
  Tin tin;
  tin.nodes = {{0, 0}, {9, 0}, {0, 9}, {-9, 0}, {0, -9}};
  tin.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  tin.height_m = {30, 0, 0, 0, 0};
  const std::vector<double> levels = {10, 20};
  std::vector<Contour> contours = march_triangles(tin, levels, {});
  nest_contours(contours);
  ASSERT_EQ(contours.size(), 2U);
  EXPECT_EQ(contours[1].parent, 0);
  EXPECT_NEAR(signed_area(contours[0].ring), 2.0 * 36, 1e-9) << "a square with its corners 6 from the middle";
  EXPECT_NEAR(signed_area(contours[1].ring), 2.0 * 9, 1e-9);
}

TEST(MarchTriangles, HoldsAtNodesThatEqualALevel) {
  for (uint64_t seed = 0; seed < 12; ++seed) {
    Tin tin = lattice_tin(13, 11, 3.0, Seed{seed}, [](Vec2) { return 0.0; });
    Rng rng(Seed{seed}.derive("heights"));
    for (float& z : tin.height_m) z = static_cast<float>(rng.integer(0, 3));
    const std::vector<double> levels = {0.5, 1, 2, 2.999999, 3};
    expect_sound(march_triangles(tin, levels, {}), levels, tin.nodes,
                 [&](size_t i, double level) { return tin.height_m[i] >= level; });
  }
}

TEST(MarchTriangles, ClosesJustBeyondTheBorder) {
  const Tin flat = lattice_tin(5, 4, 10.0, Seed{1}, [](Vec2 p) { return 100 + p.x; });
  const std::vector<double> levels = {70, 80, 100, 110};
  const std::vector<Contour> contours = march_triangles(flat, levels, {});
  expect_sound(contours, levels, flat.nodes, [&](size_t i, double level) { return flat.height_m[i] >= level; });
  for (const Contour& c : contours) {
    const Box box = bounding_box(c.ring);
    EXPECT_GT(box.high.x, 20.0);
    EXPECT_LT(box.high.x, 22.5);
    EXPECT_LT(box.high.y, 17.5);
  }
}

TEST(MarchTriangles, ClosesAroundHolesAndBays) {
  // A frame of squares with a square hole and a notch.
  Tin tin = lattice_tin(9, 9, 10.0, Seed{4}, [](Vec2 p) { return 50 + 0.1 * p.x; });
  std::erase_if(tin.triangles, [&](const std::array<int32_t, 3>& t) {
    const Vec2 middle = 1.0 / 3.0 *
                        (tin.nodes[static_cast<size_t>(t[0])] + tin.nodes[static_cast<size_t>(t[1])] +
                         tin.nodes[static_cast<size_t>(t[2])]);
    return (std::abs(middle.x) < 9 && std::abs(middle.y) < 9) || (middle.x > 22 && std::abs(middle.y - 15) < 4);
  });
  EXPECT_EQ(find_tin_defect(tin), std::nullopt);
  EXPECT_EQ(border_rings(tin).size(), 2U);
  const std::vector<double> levels = {40, 45, 51};
  const std::vector<Contour> contours = march_triangles(tin, levels, {});
  EXPECT_FALSE(find_contour_crossing(contours));
  EXPECT_EQ(std::count_if(contours.begin(), contours.end(), [](const Contour& c) { return !is_hill(c); }), 2);
}

TEST(MarchTriangles, IsTheSameOnAnyNumberOfThreads) {
  const Tin tin = lattice_tin(200, 150, 1.0, Seed{1},
                              [&](Vec2 p) { return 10 * std::sin(0.2 * p.x) * std::cos(0.3 * p.y) + 0.05 * p.x; });
  std::vector<double> levels;
  levels.reserve(30);
  for (int i = 0; i < 30; ++i) levels.push_back(-12 + 0.8 * i);
  const std::vector<Contour> one = march_triangles(tin, levels, {.threads = 1});
  EXPECT_EQ(march_triangles(tin, levels, {.threads = 3}), one);
  EXPECT_GT(one.size(), 100U);
  EXPECT_FALSE(find_contour_crossing(one));
}

TEST(MarchTriangles, OfNothingIsNothing) {
  const std::vector<double> levels = {1};
  EXPECT_TRUE(march_triangles({}, levels, {}).empty());
  EXPECT_TRUE(march_triangles(cone(), {}, {}).empty());
}

TEST(TinDefects, AreNamed) {
  EXPECT_EQ(find_tin_defect(cone()), std::nullopt);
  const auto spoilt = [](auto&& spoil) {
    Tin tin = cone();
    spoil(tin);
    return find_tin_defect(tin).value_or("");
  };
  EXPECT_THAT(spoilt([](Tin& t) { t.nodes[7].x = std::nan(""); }), HasSubstr("node 7 has a place"));
  EXPECT_THAT(spoilt([](Tin& t) { t.height_m.pop_back(); }), HasSubstr("are not as many as its 4941 nodes"));
  EXPECT_THAT(spoilt([](Tin& t) { t.triangles[3][1] = 4941; }), HasSubstr("triangle 3 names node 4941 of 4941"));
  EXPECT_THAT(spoilt([](Tin& t) { std::swap(t.triangles[3][1], t.triangles[3][2]); }), HasSubstr("counter-clockwise"));
  EXPECT_THAT(spoilt([](Tin& t) { t.triangles.push_back(t.triangles[9]); }), HasSubstr("same side of the edge"));
  EXPECT_THAT(spoilt([](Tin& t) {
                t.nodes.insert(t.nodes.end(), {{0, 0}, {9, 0}, {0, 9}});
                t.height_m.insert(t.height_m.end(), {0, 0, 0});
                t.triangles.push_back({4941, 4942, 4943});
              }),
              HasSubstr("triangles lie over each other"));
}

TEST(TraceContours, AreSoundAtSamplesThatEqualALevel) {
  for (uint64_t seed = 0; seed < 12; ++seed) {
    ScalarField field({13, 11, 3.0, -3, 8, {}});
    Rng rng(Seed{seed});
    for (float& v : field.cells()) v = static_cast<float>(rng.integer(0, 3));
    std::vector<Vec2> centres;
    for (int y = 0; y < 11; ++y)
      for (int x = 0; x < 13; ++x) centres.push_back({field.frame().x(x), field.frame().y(y)});
    const std::vector<double> levels = {-5, 0.5, 1, 2, 2.999999, 3};
    expect_sound(trace_contours(field, levels), levels, centres,
                 [&](size_t i, double level) { return field.cells()[i] >= level; });
  }
}

TEST(TraceContours, CloseWithinOneCellBeyondTheFrame) {
  const ScalarField high({7, 5, 3.0, 10, 20, {}}, 5.0F);
  const std::vector<double> levels = {1, 2, 4};
  std::vector<Contour> contours = trace_contours(high, levels);
  nest_contours(contours);
  ASSERT_EQ(contours.size(), 3U);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(contours[i].height_m, levels[i]);
    EXPECT_EQ(contours[i].parent, static_cast<int>(i) - 1);
    const Box box = bounding_box(contours[i].ring);
    EXPECT_LT(box.low.x, 10.0);
    EXPECT_GT(box.low.x, 7.0);
  }
}

TEST(TinBorder, NoPartsStayJoinedByANodeAlone) {
  Tin tin = lattice_tin(9, 9, 10.0, Seed{3}, [](Vec2) { return 0.0; });
  // A hole that touches the border at one node, and another one that touches the first.
  std::erase_if(tin.triangles, [&](const auto& t) {
    const auto column = [](int32_t node) { return node % 9; };
    const auto row = [](int32_t node) { return node / 9; };
    const auto within = [&](int low_x, int high_x, int low_y, int high_y) {
      return std::all_of(t.begin(), t.end(), [&](int32_t n) {
        return column(n) >= low_x && column(n) <= high_x && row(n) >= low_y && row(n) <= high_y;
      });
    };
    return within(0, 1, 0, 1) || within(1, 3, 1, 3) || within(3, 5, 3, 5);
  });
  ASSERT_TRUE(find_tin_defect(tin).has_value());
  const size_t before = tin.triangles.size();
  open_pinches(tin);
  EXPECT_FALSE(find_tin_defect(tin).has_value());
  EXPECT_LT(tin.triangles.size(), before);
  EXPECT_GT(tin.triangles.size(), before - 40);
  const size_t after = tin.triangles.size();
  open_pinches(tin);
  EXPECT_EQ(tin.triangles.size(), after);
}

}  // namespace
}  // namespace seamount::geom
