// P0 eq. 1.1 against values by hand and the slow formula, in polar form and for areas.
#include "seamount/ops/island/coordinate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/geom/polygon/distance.h"

namespace seamount::island {
namespace {

constexpr double kRadii[] = {0, 2000, 2300, 3200, 3900, 6000};

/// Eq. 1.1 as printed, with R_0 = 0 and x~ clamped to 5.
double by_hand(double r) {
  for (int i = 0; i < 5; ++i) {
    if (r < kRadii[i + 1]) return i + (r - kRadii[i]) / (kRadii[i + 1] - kRadii[i]);
  }
  return 5;
}

std::vector<Polygon> disc(double radius) {
  Ring ring;
  for (int i = 0; i < 1440; ++i) {
    const double a = 2 * std::numbers::pi * i / 1440;
    ring.push_back({radius * std::cos(a), radius * std::sin(a)});
  }
  return {{ring, {}}};
}

ScalarField evaluate(const Plan& plan, const GridFrame& frame, double smoothing) {
  const RegionCoordinate coordinate(plan, frame, smoothing, {});
  ScalarField out(frame);
  for (int y = 0; y < frame.height; ++y) coordinate.row(frame.x(0), frame.cell_m, frame.y(y), {}, out.row(y));
  return out;
}

TEST(RegionCoordinate, PolarFormIsEquation1_1) {
  std::vector<PolarOutline> outlines;
  for (int i = 1; i <= 5; ++i) outlines.push_back({{kRadii[i]}});
  const Vec2 centre{350, -120};
  const GridFrame frame = GridFrame::centred(151, 133, 97);
  const ScalarField x = evaluate(plan_from_polar(outlines, centre, {}), frame, 0);
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const double r = std::hypot(frame.x(column) - centre.x, frame.y(row) - centre.y);
      ASSERT_NEAR(x(column, row), by_hand(r), 2e-5) << column << " " << row;
    }
  }
}

TEST(RegionCoordinate, PolarFormFollowsRadiiThatChangeWithTheAngle) {
  PolarOutline coast;
  for (int i = 0; i < 360; ++i)
    coast.radii_m.push_back(3000 + 600 * std::cos(3 * i * std::numbers::pi / 180) +
                            300 * std::sin(i * std::numbers::pi / 180));
  const Plan plan = plan_from_polar({coast}, {}, {.beach_m = 200, .lagoon_m = 500, .reef_m = 400, .slope_m = 900});
  const GridFrame frame = GridFrame::centred(120, 120, 100);
  const ScalarField x = evaluate(plan, frame, 0);
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const double px = frame.x(column), py = frame.y(row), r = std::hypot(px, py), a = std::atan2(py, px);
      const double beach = 3000 + 600 * std::cos(3 * a) + 300 * std::sin(a);
      const double outlines[] = {0, beach - 200, beach, beach + 500, beach + 900, beach + 1800};
      double expected = 5;
      for (int i = 4; i >= 0; --i) {
        if (r < outlines[i + 1]) expected = i + std::max(0.0, (r - outlines[i]) / (outlines[i + 1] - outlines[i]));
      }
      ASSERT_NEAR(x(column, row), expected, 3e-3) << column << " " << row;
    }
  }
}

TEST(RegionCoordinate, AreasOnCirclesEqualEquation1_1) {
  Plan plan;
  for (int i = 0; i < 5; ++i) plan.areas[static_cast<size_t>(i)] = disc(kRadii[i + 1]);
  plan.widths = natural_widths(std::numbers::pi * 4e6);
  const GridFrame frame = GridFrame::centred(260, 260, 50);
  const ScalarField x = evaluate(plan, frame, 0);
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const double r = std::hypot(frame.x(column), frame.y(row));
      // Between outlines the distance form is exact; inside the first one a Poisson solution on the lattice stands for
      // it.
      const double tolerance = r > kRadii[1] + 50 ? 2e-3 : 0.03;
      ASSERT_NEAR(x(column, row), by_hand(r), tolerance) << column << " " << row;
    }
  }
}

TEST(RegionCoordinate, DerivedOutlinesAreOffsetsOfTheCoast) {
  Plan plan;
  plan.areas[kCoast] = disc(3000);
  plan.widths = {.beach_m = 250, .lagoon_m = 900, .reef_m = 600, .slope_m = 1500};
  const GridFrame frame = GridFrame::centred(280, 280, 50);
  const ScalarField x = evaluate(plan, frame, 0);
  const double radii[] = {0, 2750, 3000, 3900, 4500, 6000};
  for (int column = 0; column < frame.width; ++column) {
    const double r = std::hypot(frame.x(column), frame.y(140));
    if (r < radii[1] + 50) continue;
    double expected = 5;
    for (int i = 4; i >= 1; --i) {
      if (r < radii[i + 1]) expected = i + (r - radii[i]) / (radii[i + 1] - radii[i]);
    }
    EXPECT_NEAR(x(column, 140), expected, 2e-3);
  }
}

/// The dumb-bell has concave coasts and a neck: nothing polar.
Plan dumb_bell() {
  Plan plan;
  plan.areas[kCoast] = {{{{-4000, -1500},
                          {-1000, -1500},
                          {-500, -300},
                          {500, -300},
                          {1000, -1500},
                          {4000, -1500},
                          {4000, 1500},
                          {1000, 1500},
                          {500, 300},
                          {-500, 300},
                          {-1000, 1500},
                          {-4000, 1500}},
                         {}}};
  plan.widths = {.beach_m = 100, .lagoon_m = 700, .reef_m = 500, .slope_m = 1500};
  plan.land_m2 = 1.9e7;
  return plan;
}

TEST(RegionCoordinate, IsContinuousAndInRangeOnConcaveCoasts) {
  const GridFrame frame = GridFrame::centred(400, 260, 30);
  for (const double smoothing : {0.0, 1.0}) {
    const ScalarField x = evaluate(dumb_bell(), frame, smoothing);
    for (int row = 0; row + 1 < frame.height; ++row) {
      for (int column = 0; column + 1 < frame.width; ++column) {
        ASSERT_GE(x(column, row), 0.0F);
        ASSERT_LE(x(column, row), 5.0F);
        // The beach is the steepest: one region in 100 m; the summit's cone may be steep over a cell or two.
        ASSERT_LT(std::abs(x(column + 1, row) - x(column, row)), 30 / 100.0 * 1.6 + 0.05) << column << " " << row;
      }
    }
  }
}

TEST(RegionCoordinate, SmoothingSoftensCreasesButKeepsTheCoast) {
  const GridFrame frame = GridFrame::centred(400, 260, 30);
  const ScalarField sharp = evaluate(dumb_bell(), frame, 0.0);
  const ScalarField soft = evaluate(dumb_bell(), frame, 1.0);
  const auto roughness = [&](const ScalarField& x) {
    double largest = 0;
    for (int row = 1; row + 1 < frame.height; ++row) {
      for (int column = 1; column + 1 < frame.width; ++column) {
        if (x(column, row) < 4.1F || x(column, row) > 4.9F) continue;
        largest = std::max(
            largest, std::abs(static_cast<double>(x(column + 1, row)) - 2.0 * x(column, row) + x(column - 1, row)));
      }
    }
    return largest;
  };
  EXPECT_LT(roughness(soft), 0.5 * roughness(sharp));
  const ScalarField distance = geom::signed_distance(dumb_bell().areas[kCoast], frame, {});
  int moved = 0, coast = 0;
  for (size_t c = 0; c < soft.size(); ++c) {
    if (std::abs(distance.cells()[c]) > 45.0F) continue;
    ++coast;
    moved += (soft.cells()[c] < 2.0F) != (distance.cells()[c] < 0.0F) ? 1 : 0;
  }
  EXPECT_LT(moved, coast / 15);
}

TEST(RegionCoordinate, CoarseAndFineFramesAgree) {
  const GridFrame coarse = GridFrame::centred(128, 96, 96);
  const GridFrame fine = GridFrame::centred(1536, 1152, 8);
  const ScalarField a = evaluate(dumb_bell(), coarse, 0.6);
  const ScalarField b = evaluate(dumb_bell(), fine, 0.6);
  double sum = 0;
  for (int row = 0; row < coarse.height; ++row) {
    for (int column = 0; column < coarse.width; ++column) {
      double mean = 0;
      for (int j = 0; j < 12; ++j) {
        for (int i = 0; i < 12; ++i) mean += b(12 * column + i, 12 * row + j) / 144.0;
      }
      sum += std::abs(mean - a(column, row));
    }
  }
  EXPECT_LT(sum / static_cast<double>(coarse.cells()), 0.03);
}

TEST(CoordinateFromLabels, RunsAcrossEachRegion) {
  const GridFrame frame = GridFrame::centred(301, 301, 40);
  LabelMap labels(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      labels(x, y) = static_cast<Region>(std::min(4, static_cast<int>(by_hand(std::hypot(frame.x(x), frame.y(y))))));
    }
  }
  const ScalarField x = coordinate_from_labels(labels, {});
  for (int column = 0; column < frame.width; ++column) {
    const double r = std::abs(frame.x(column));
    if (r > 3900) continue;  // nothing lies outside the abyss: there x~ only rises
    EXPECT_NEAR(x(column, 150), by_hand(r), 0.09) << r;
    EXPECT_EQ(static_cast<int>(x(column, 150)), static_cast<int>(labels(column, 150)));
  }
}

TEST(CoordinateFromLabels, OneLabelEverywhereIsFine) {
  for (const Region region : kRegions) {
    const ScalarField x = coordinate_from_labels(LabelMap(GridFrame::centred(7, 3, 10), region), {});
    for (const float v : x.cells())
      EXPECT_TRUE(v >= static_cast<float>(region) && v <= static_cast<float>(region) + 1.0F);
  }
}

}  // namespace
}  // namespace seamount::island
