#include "seamount/io/reproject.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/io/projection.h"

namespace seamount::io {
namespace {

const std::string kZone33 = "EPSG:32633", kZone32 = "EPSG:32632";

GridFrame frame_in(const std::string& crs, Vec2 lonlat, int width, int height, double cell_m) {
  const Vec2 middle = from_lonlat({lonlat}, crs)[0];
  GridFrame frame = GridFrame::centred(width, height, cell_m);
  frame.west_m += middle.x;
  frame.north_m += middle.y;
  frame.crs = crs;
  return frame;
}

/// Heights by longitude and latitude, so that places can be checked by value.
HeightField by_place(const GridFrame& frame) {
  HeightField heights(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const Vec2 at = to_lonlat({{frame.x(x), frame.y(y)}}, frame.crs)[0];
      heights(x, y) = static_cast<float>(1e4 * (at.x - 12) + 5e3 * (at.y - 47));
    }
  }
  return heights;
}

TEST(Reproject, RastersComeToTheRightPlace) {
  for (const double cell_m : {20.0, 45.0, 100.0}) {
    const HeightField there = by_place(frame_in(kZone32, {12, 47}, 120, 90, 40));
    const HeightField here = on_cells(there, frame_in(kZone33, {12, 47}, 40, 30, cell_m), {});
    const HeightField wanted = by_place(here.frame());
    for (size_t i = 0; i < here.size(); ++i) {
      ASSERT_NEAR(here.cells()[i], wanted.cells()[i], cell_m > 80 ? 4 : 0.05) << cell_m << " cell " << i;
    }
    const HeightField whole = in_system(there, kZone33, {});
    const HeightField same = by_place(whole.frame());
    int known = 0;
    for (size_t i = 0; i < whole.size(); ++i) {
      if (std::isnan(whole.cells()[i])) continue;
      ++known;
      ASSERT_NEAR(whole.cells()[i], same.cells()[i], 6) << "its edge is clamped within half a cell";
    }
    EXPECT_NEAR(known, 120 * 90, 250);  // all of it, turned by five degrees
  }
}

TEST(Reproject, OneLatticeComesOverExactly) {
  const HeightField all = by_place(frame_in(kZone33, {12, 47}, 60, 50, 30));
  GridFrame part = all.frame();
  part.width = 20, part.height = 70;
  part.west_m += 7 * 30.0;
  part.north_m += 10 * 30.0;
  const HeightField cut = on_cells(all, part, {});
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) {
      const bool inside = y >= 10 && y < 60;
      ASSERT_EQ(std::isnan(cut(x, y)), !inside) << x << " " << y;
      if (!inside) continue;
      ASSERT_EQ(cut(x, y), all(x + 7, y - 10)) << x << " " << y;
    }
  }
  LabelMap labels(all.frame(), Region::lagoon);
  labels(9, 3) = Region::reef;
  const LabelMap moved = on_cells(labels, part, {});
  EXPECT_EQ(moved(2, 13), Region::reef);
  EXPECT_EQ(moved(2, 12), Region::lagoon);
  EXPECT_EQ(moved(2, 2), Region::abyss);
}

TEST(Reproject, DrawingsGoAndComeBack) {
  for (const uint64_t seed : {1, 2, 3}) {
    Rng rng(Seed{seed});
    const Vec2 middle = from_lonlat({{12, 47}}, kZone33)[0];
    const auto point = [&] { return Vec2{middle.x + rng.uniform(-2e4, 2e4), middle.y + rng.uniform(-2e4, 2e4)}; };
    Drawing drawing;
    drawing.crs = kZone33;
    drawing.areas = {{"a", {{{point(), point(), point()}, {{point(), point(), point()}}}}}};
    drawing.lines = {{{point(), point(), point()}, 7.0, false}};
    drawing.points = {{point(), 3.0}};
    const Drawing there = in_system(drawing, kZone32), back = in_system(there, kZone33);
    EXPECT_EQ(there.crs, kZone32);
    const auto near = [](Vec2 a, Vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); };
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_LT(near(back.areas[0].parts[0].outer[i], drawing.areas[0].parts[0].outer[i]), 1e-3);
      EXPECT_LT(near(back.lines[0].points[i], drawing.lines[0].points[i]), 1e-3);
      const Vec2 degrees = to_lonlat({drawing.lines[0].points[i]}, kZone33)[0];
      EXPECT_LT(near(there.lines[0].points[i], from_lonlat({degrees}, kZone32)[0]), 1e-3);
    }
    EXPECT_LT(near(back.points[0].place, drawing.points[0].place), 1e-3);
  }
  EXPECT_THROW(in_system(Drawing{}, kZone33), InvalidArgument);  // from nowhere
}

}  // namespace
}  // namespace seamount::io
