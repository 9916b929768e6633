#include "seamount/geom/contour/contour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/base/rng.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

ScalarField cone(int width, int height, double peak) {
  const GridFrame frame = GridFrame::centred(width, height, 2.0);
  ScalarField field(frame);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) field(x, y) = static_cast<float>(peak - std::hypot(frame.x(x), frame.y(y)));
  }
  return field;
}

double total_area(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) sum += area(polygon);
  return sum;
}

TEST(TraceAreas, OfAConeIsACircle) {
  const std::vector<Polygon> areas = trace_areas(cone(80, 60, 100), 60.0);
  ASSERT_EQ(areas.size(), 1U);
  EXPECT_TRUE(areas[0].holes.empty());
  EXPECT_GT(signed_area(areas[0].outer), 0);
  EXPECT_NEAR(signed_area(areas[0].outer), std::numbers::pi * 1600, 10);
  for (const Vec2 p : areas[0].outer) EXPECT_NEAR(std::hypot(p.x, p.y), 40, 0.05);
}

TEST(TraceAreas, ClosesAtTheFramesEdge) {
  const ScalarField high({7, 5, 3.0, 10, 20, {}}, 5.0F);
  const std::vector<Polygon> all = trace_areas(high, 1.0);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].outer.size(), 4U);
  EXPECT_NEAR(area(all[0]), 7 * 5 * 9, 1e-9);
  EXPECT_TRUE(trace_areas(high, 6.0).empty());
  EXPECT_NEAR(total_area(trace_areas(cone(50, 30, 100), 60.0)), std::numbers::pi * 1600 - 2 * 362.7, 30);
}

TEST(TraceAreas, OneCellAndValuesThatAreNoNumbers) {
  EXPECT_EQ(trace_areas(ScalarField({1, 1, 1, 0, 0, {}}, 1.0F), 0.5).size(), 1U);
  EXPECT_TRUE(trace_areas(ScalarField({3, 1, 1, 0, 0, {}}, std::nanf("")), 0.5).empty());
  EXPECT_TRUE(trace_areas(ScalarField(), 0.5).empty());
}

TEST(TraceAreas, NestsHolesAndIslandsInHoles) {
  const GridFrame frame = GridFrame::centred(101, 101, 1.0);
  ScalarField rings(frame);
  for (int y = 0; y < 101; ++y) {
    for (int x = 0; x < 101; ++x) rings(x, y) = static_cast<float>(std::cos(std::hypot(frame.x(x), frame.y(y)) / 5.0));
  }
  const std::vector<Polygon> areas = trace_areas(rings, 0.0);
  int with_hole = 0;
  for (const Polygon& polygon : areas) {
    EXPECT_EQ(find_defect(polygon), std::nullopt);
    with_hole += polygon.holes.size() == 1;
    for (const Ring& hole : polygon.holes) EXPECT_LT(signed_area(hole), 0);
  }
  EXPECT_GE(with_hole, 1);
}

TEST(TraceAreas, AreSoundAndMatchTheFieldOnNoiseWithTies) {
  for (uint64_t seed = 1; seed < 12; ++seed) {
    const GridFrame frame = {47, 31, 2.0, -3, 8, {}};
    ScalarField field(frame);
    Rng rng(Seed{seed});
    // Whole numbers: many samples equal the level, and every saddle occurs.
    for (float& v : field.cells()) v = static_cast<float>(rng.integer(0, 3));
    const std::vector<Polygon> areas = trace_areas(field, 1.0);
    for (const Polygon& polygon : areas) EXPECT_EQ(find_defect(polygon), std::nullopt) << "seed " << seed;
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        bool inside = false;
        for (const Polygon& polygon : areas) inside |= contains(polygon, {frame.x(x), frame.y(y)});
        EXPECT_EQ(inside, field(x, y) >= 1.0F) << "seed " << seed << " at " << x << ' ' << y;
      }
    }
  }
}

TEST(TraceAreas, DoNotCrossEachOtherAtDifferentLevels) {
  const ScalarField field = fbm_grid(GridFrame::centred(90, 70, 1.0), Seed{3}, {.wavelength_m = 20, .octaves = 4}, {});
  const std::vector<Polygon> low = trace_areas(field, 0.1), high = trace_areas(field, 0.13);
  for (const Polygon& a : low) {
    for (const Polygon& b : high) {
      const Box box = bounding_box(b.outer);
      const bool on_edge = box.low.x <= -45 || box.high.x >= 45 || box.low.y <= -35 || box.high.y >= 35;
      EXPECT_TRUE(on_edge || !find_crossing(a.outer, b.outer));
    }
  }
}

TEST(TraceLines, KeepHighGroundOnTheLeftAndEndAtTheEdge) {
  const ScalarField field = cone(50, 30, 100);
  const GridFrame& frame = field.frame();
  int open = 0;
  for (const Polyline& line : trace_lines(field, 60.0)) {
    const bool closed = line.front() == line.back();
    open += !closed;
    if (!closed) {
      for (const Vec2 end : {line.front(), line.back()}) {
        EXPECT_NEAR(std::min(std::abs(end.y - frame.north_m), std::abs(end.y - frame.south_m())), 0, 1e-9);
      }
    }
    for (size_t i = 1; i < line.size(); ++i) EXPECT_GT(cross(line[i] - line[i - 1], Vec2{} - line[i]), -1.0);
  }
  EXPECT_EQ(open, 2);
  const std::vector<Polyline> circle = trace_lines(field, 80.0);
  ASSERT_EQ(circle.size(), 1U);
  EXPECT_EQ(circle[0].front(), circle[0].back());
}

TEST(TraceMask, LosesTheStairsAndStaysWithinACell) {
  const GridFrame frame = GridFrame::centred(120, 90, 5.0);
  Grid<uint8_t> mask(frame);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 120; ++x) mask(x, y) = frame.y(y) < 60 + 0.31 * frame.x(x) ? 1 : 0;
  }
  const std::vector<Polygon> traced = trace_mask(mask);
  ASSERT_EQ(traced.size(), 1U);
  const Ring& ring = traced[0].outer;
  int inner = 0;
  for (const Vec2 p : ring) {
    if (std::abs(p.x) > 280 || p.y < -220) continue;
    ++inner;
    EXPECT_LT(std::abs(p.y - (60 + 0.31 * p.x)), 0.45 * 5.0);
  }
  EXPECT_GT(inner, 50);
  EXPECT_EQ(find_defect(traced[0]), std::nullopt);
}

TEST(TraceMask, KeepsEveryCellOnItsSideExceptAtTheBorderItself) {
  const ScalarField noise = fbm_grid(GridFrame::centred(80, 80, 1.0), Seed{6}, {.wavelength_m = 30, .octaves = 4}, {});
  Grid<uint8_t> mask(noise.frame());
  for (size_t i = 0; i < mask.size(); ++i) mask.cells()[i] = noise.cells()[i] > 0 ? 1 : 0;
  const std::vector<Polygon> traced = trace_mask(mask);
  const Grid<uint8_t> back = rasterise(traced, mask.frame());
  int wrong = 0;
  for (int y = 1; y < 79; ++y) {
    for (int x = 1; x < 79; ++x) {
      if (mask(x, y) == back(x, y)) continue;
      ++wrong;
      bool border = false;
      for (int v = -1; v <= 1; ++v) {
        for (int u = -1; u <= 1; ++u) border |= mask(x + u, y + v) != mask(x, y);
      }
      EXPECT_TRUE(border) << x << ' ' << y;
    }
  }
  EXPECT_LT(wrong, 160);
}

}  // namespace
}  // namespace seamount::geom
