// Strokes against two slow and obvious versions: means over places that lie very close along the spline, as the header
// defines the weight, and the greatest of pressure times profile, which it is to be like.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/geom/brush/brush_rows.h"
#include "seamount/geom/scalar/segment.h"
#include "seamount/geom/scalar/spline.h"

namespace seamount::geom {
namespace {

using ::testing::HasSubstr;

/// Where a pen has been, closely.
struct Way {
  std::vector<Vec2> places;
  std::vector<double> pressures;
};

double greatest(const Way& way, const BrushProfile& profile, Vec2 p) {
  double most = 0.0;
  for (size_t i = 0; i < way.places.size(); ++i)
    most = std::max(most, way.pressures[i] * profile.weight(std::hypot(p.x - way.places[i].x, p.y - way.places[i].y)));
  return most;
}

/// weight = profile(D) mean(pressure), D^2 = mean(d^2 - s^2).
double defined(const Way& way, const BrushProfile& profile, Vec2 p) {
  const double r = profile.radius_m(), spread2 = r * r / 24.0, dab = std::sqrt(2.0 * 3.14159265358979 * spread2);
  const double most = *std::max_element(way.pressures.begin(), way.pressures.end());
  double masses = 0.0, squares = 0.0, pressures = 0.0;
  const auto add = [&](size_t i, double length, double spread) {
    const double d2 = dot(p - way.places[i], p - way.places[i]);
    if (d2 > 4.0 * r * r) return;
    const double pressed = way.pressures[i] / most;
    const double mass = length * std::pow(pressed * pressed + 0.25 * 0.25, 3) * std::exp(-0.5 * d2 / spread2);
    masses += mass;
    squares += mass * (d2 - spread);
    pressures += mass * way.pressures[i];
  };
  const size_t last = way.places.size() - 1;
  for (size_t i = 0; i < last; ++i) {
    const Vec2 step = way.places[i + 1] - way.places[i];
    add(i, 0.5 * std::sqrt(dot(step, step)), spread2);
    add(i + 1, 0.5 * std::sqrt(dot(step, step)), spread2);
  }
  add(0, 0.5 * dab, 0.0);
  add(last, 0.5 * dab, 0.0);
  if (!(masses > 0.0)) return 0.0;
  const double away2 = squares / masses;  // below 0 it stays about 1: BrushProfile
  return profile.weight(std::sqrt(std::max(0.0, away2))) * pressures / masses;
}

ScalarField weights_of(const Brush& brush, const GridFrame& frame, int rows_at_a_time = 1000) {
  const BrushPath path = brush_path(brush, frame, "stroke");
  ScalarField out(frame, 0.0F);
  BrushBand band;
  for (int y = 0; y < frame.height; y += rows_at_a_time) {
    if (!band.read(path, frame, y, std::min(frame.height, y + rows_at_a_time))) continue;
    band.each_row([&](int row, int x, std::span<const float> weights) {
      std::copy(weights.begin(), weights.end(), &out(x, row));
    });
  }
  return out;
}

Brush scribble(uint64_t seed, int points, double radius_m, double hardness) {
  Rng rng(Seed{seed});
  Brush brush;
  for (int i = 0; i < points; ++i) brush.points.push_back({rng.uniform(-1200, 1200), rng.uniform(-900, 900)});
  brush.radius_m = radius_m;
  brush.hardness = hardness;
  return brush;
}

/// As a hand draws: turns take room.
Brush wander(uint64_t seed, double radius_m, double hardness) {
  Rng rng(Seed{seed});
  Brush brush{{}, {}, radius_m, hardness};
  Vec2 at{-900, rng.uniform(-400, 400)};
  double way = 0.0;
  for (int i = 0; i < 40; ++i) {
    brush.points.push_back(at);
    way += rng.uniform(-0.35, 0.4);
    at = at + 110.0 * Vec2{std::cos(way), std::sin(way)};
  }
  return brush;
}

const GridFrame kFrame = GridFrame::centred(60, 48, 52.0);

template <class Wanted>
void expect_cells(const ScalarField& out, double tolerance, Wanted&& wanted) {
  const GridFrame& frame = out.frame();
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x)
      ASSERT_NEAR(out(x, y), wanted(Vec2{frame.x(x), frame.y(y)}), tolerance) << x << ", " << y;
  }
}

Way way_of(const Brush& brush) {
  Way way{sample_catmull_rom(brush.points, 10.0), {}};
  way.pressures.assign(way.places.size(), 1.0);
  return way;
}

TEST(Brush, IsItsDefinitionAlongTheLibrarysSpline) {
  for (const double hardness : {0.0, 0.6}) {
    for (const double radius : {60.0, 400.0}) {
      const Brush brush = wander(static_cast<uint64_t>(radius), radius, hardness);
      const BrushPath path = brush_path(brush, kFrame, "stroke");
      EXPECT_TRUE(path.even);
      const Way way = way_of(brush);
      const double off = 0.015 * path.profile.radius_m();  // of D, by steps along the way; most at the ends
      expect_cells(weights_of(brush, kFrame), 1.75 * off / path.profile.fall_m + 2e-3,
                   [&](Vec2 p) { return defined(way, path.profile, p); });
    }
  }
}

TEST(Brush, AStraightStrokeIsTheProfileOfTheDistanceWithRoundEnds) {
  for (const double hardness : {0.0, 0.5}) {
    const Brush brush{{{-900, -300}, {800, 400}}, {}, 420, hardness};
    const BrushProfile profile = brush_path(brush, kFrame, "stroke").profile;
    expect_cells(weights_of(brush, kFrame), 0.03, [&](Vec2 p) {
      return profile.weight(std::sqrt(squared_distance_to_segment(p, brush.points[0], brush.points[1])));
    });
    const Vec2 along = (1.0 / 1838.48) * (brush.points[1] - brush.points[0]);
    const ScalarField out = weights_of(brush, kFrame);
    expect_cells(out, 2e-3, [&](Vec2 p) {  // away from the ends
      const double at = dot(p - brush.points[0], along);
      if (at < 400 || at > 1438)
        return static_cast<double>(
            out(static_cast<int>(std::lround(kFrame.column(p.x))), static_cast<int>(std::lround(kFrame.row(p.y)))));
      return profile.weight(std::abs(cross(along, p - brush.points[0])));
    });
  }
}

TEST(Brush, IsAboutTheGreatestAlongTheWayAndNeverTwiceThat) {
  for (const uint64_t seed : {1, 2, 3}) {
    Brush brush = scribble(seed, 12, 350, 0.0);
    Way way = way_of(brush);
    const BrushProfile profile = brush_path(brush, kFrame, "stroke").profile;
    expect_cells(weights_of(brush, kFrame), 0.25, [&](Vec2 p) { return greatest(way, profile, p); });
    const ScalarField out = weights_of(brush, kFrame);
    for (const float w : out.cells()) ASSERT_TRUE(w >= 0.0F && w <= 1.02F);
  }
}

TEST(Brush, PressureThatGrowsIsAboutTheGreatestToo) {
  const Brush brush{{{-1000, 100}, {1000, 100}}, {0.1, 1.0}, 400, 0.0};
  const BrushPath path = brush_path(brush, kFrame, "stroke");
  EXPECT_FALSE(path.even);
  Way way;
  for (int i = 0; i <= 1000; ++i) {
    way.places.push_back({-1000 + 2.0 * i, 100});
    way.pressures.push_back(0.1 + 0.0009 * i);
  }
  expect_cells(weights_of(brush, kFrame), 0.03, [&](Vec2 p) { return defined(way, path.profile, p); });
  expect_cells(weights_of(brush, kFrame), 0.04, [&](Vec2 p) { return greatest(way, path.profile, p); });
}

TEST(Brush, PressureRunsThroughWhatIsGivenAndNotBeyond) {
  const Brush brush{{{-1000, 0}, {-400, 100}, {0, -100}, {300, 0}, {900, 50}}, {0.2, 0.9, 0.9, 0.1, 0.6}, 60, 0};
  const BrushPath path = brush_path(brush, kFrame, "stroke");
  for (size_t i = 0; i < brush.points.size(); ++i) {
    double nearest = 1e9, pressure = 0.0;
    for (const BrushSample& sample : path.samples) {
      const double d = std::hypot(sample.at.x - brush.points[i].x, sample.at.y - brush.points[i].y);
      if (d < nearest) {
        nearest = d;
        pressure = sample.pressure;
      }
      EXPECT_GE(sample.pressure, 0.1);
      EXPECT_LE(sample.pressure, 0.9);
    }
    EXPECT_NEAR(pressure, brush.pressure[i], 0.03);
  }
}

TEST(Brush, ManyPointsOnALineAreAsFew) {
  Brush many;
  many.radius_m = 300;
  for (int i = 0; i <= 1000; ++i) {
    many.points.push_back({-800 + 1.6 * i, 100 + 0.5 * i});
    many.pressure.push_back(0.001 * i);
  }
  const Brush few{{many.points.front(), many.points.back()}, {0.0, 1.0}, 300, 0};
  EXPECT_EQ(brush_path(many, kFrame, "stroke").samples.size(), brush_path(few, kFrame, "stroke").samples.size());
  const ScalarField a = weights_of(few, kFrame), b = weights_of(many, kFrame);
  for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a.cells()[i], b.cells()[i], 4e-3);
}

TEST(Brush, BandsOfRowsAreTheWhole) {
  Brush brush = scribble(3, 8, 250, 0.2);
  const ScalarField even = weights_of(brush, kFrame);
  EXPECT_EQ(weights_of(brush, kFrame, 7), even);
  for (size_t i = 0; i < 8; ++i) brush.pressure.push_back(0.1 * static_cast<double>(i));
  EXPECT_EQ(weights_of(brush, kFrame, 7), weights_of(brush, kFrame));
}

TEST(Brush, ADabIsItsProfile) {
  for (const double pressure : {1.0, 0.4}) {
    const Brush dab{{{100, 50}, {100, 50}}, {0.1, pressure}, 420, 0.25};
    const BrushPath path = brush_path(dab, kFrame, "stroke");
    EXPECT_DOUBLE_EQ(path.profile.weight(0.25 * 420), 1.0);
    EXPECT_DOUBLE_EQ(path.profile.weight(420), 0.0);
    expect_cells(weights_of(dab, kFrame), 2e-4,
                 [&](Vec2 p) { return pressure * path.profile.weight(std::hypot(p.x - 100, p.y - 50)); });
  }
}

TEST(Brush, WhatLiesFarAwayCostsNothingAndIsExact) {
  const Brush near{{{-1e4, -500}, {1e4, 700}}, {}, 200, 0};
  const Brush far{{{-1e9, -600.0 * 1e5 + 100}, {1e9, 600.0 * 1e5 + 100}}, {}, 200, 0};
  const ScalarField a = weights_of(near, kFrame), b = weights_of(far, kFrame);
  for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a.cells()[i], b.cells()[i], 2e-3);
  Brush wild = scribble(4, 60, 50, 0);
  for (size_t i = 0; i < wild.points.size(); i += 2) wild.points[i] = 1e7 * wild.points[i];
  EXPECT_LT(brush_path(wild, kFrame, "stroke").samples.size(), 20000U);
  EXPECT_TRUE(brush_path({{{1e6, 1e6}, {2e6, 1e6}}, {}, 500, 0}, kFrame, "stroke").samples.empty());
}

TEST(Brush, FinerThanCellsItIsAsWideAsACell) {
  const ScalarField out = weights_of({{{-1000, -700}, {1100, 800}}, {}, 1.0, 0}, kFrame);
  for (int x = 12; x < 48; ++x) {  // no gap along the line
    float most = 0.0F;
    for (int y = 0; y < kFrame.height; ++y) most = std::max(most, out(x, y));
    EXPECT_GT(most, 0.1F) << x;
  }
  EXPECT_NEAR(brush_path({{{0, 0}}, {}, 1.0, 0}, kFrame, "stroke").thinned, 1.0 / (0.75 * 52.0), 1e-12);
}

std::string error_of(const Brush& brush) {
  try {
    brush_path(brush, kFrame, "strokes[3]");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Brush, MistakesAreNamed) {
  EXPECT_EQ(error_of({}), "strokes[3].points: has no point");
  EXPECT_EQ(error_of({{{0, 0}, {1, 1}, {2, 0}}, {0.5, 1.0}, 10, 0}), "strokes[3].pressure: has 2 values for 3 points");
  EXPECT_THAT(error_of({{{0, 0}, {std::nan(""), 1}}, {}, 10, 0}), HasSubstr("strokes[3].points: point 1, "));
  EXPECT_THAT(error_of({{{1e300, 0}}, {}, 10, 0}), HasSubstr("strokes[3].points: point 0, "));
}

}  // namespace
}  // namespace seamount::geom
