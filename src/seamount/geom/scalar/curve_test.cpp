#include "seamount/geom/scalar/curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

const Curve kProfile = {{{0, 900}, {1, 40}, {2, 0}, {2.5, -20}, {3, -2}, {3.2, -2}, {5, -1200}}};

TEST(CurveFunction, PassesThroughItsKnotsAndIsConstantBeyond) {
  for (const CurveKind kind : {CurveKind::monotone_cubic, CurveKind::linear}) {
    const CurveFunction f(kProfile, kind);
    for (const Knot& knot : kProfile.knots) EXPECT_DOUBLE_EQ(f(knot.x), knot.y);
    EXPECT_EQ(f(-10), 900);
    EXPECT_EQ(f(99), -1200);
  }
}

TEST(CurveFunction, CubicNeverLeavesTheRangeOfItsTwoKnots) {
  Rng rng(Seed{1});
  for (int trial = 0; trial < 200; ++trial) {
    Curve curve;
    double x = 0;
    for (int i = 0; i < 7; ++i) curve.knots.push_back({x += rng.uniform(0.01, 3.0), std::pow(rng.uniform(-3, 3), 3)});
    const CurveFunction f(curve);
    for (size_t i = 0; i + 1 < curve.knots.size(); ++i) {
      const auto [a, b] = std::pair(curve.knots[i], curve.knots[i + 1]);
      double before = a.y;
      for (int k = 0; k <= 50; ++k) {
        const double y = f(a.x + (b.x - a.x) * k / 50.0);
        EXPECT_GE((y - before) * (b.y > a.y ? 1 : -1), -1e-12) << "not monotone in segment " << i;
        before = y;
      }
    }
  }
}

TEST(CurveFunction, CubicHasContinuousSlopes) {
  const CurveFunction f(kProfile);
  for (size_t i = 1; i + 1 < kProfile.knots.size(); ++i) {
    const double x = kProfile.knots[i].x, h = 1e-6;
    EXPECT_NEAR((f(x) - f(x - h)) / h, (f(x + h) - f(x)) / h, 0.05);
  }
}

TEST(CurveFunction, LinearIsHalfWayInTheMiddle) {
  const CurveFunction f(kProfile, CurveKind::linear);
  EXPECT_DOUBLE_EQ(f(0.5), 470);
  EXPECT_DOUBLE_EQ(f(4.1), -601);
}

TEST(CurveFunction, OneKnotIsAConstant) { EXPECT_EQ(CurveFunction({{{3, 8}}})(-1), 8); }

TEST(CurveFunction, NamesTheKnotThatBreaksTheRule) {
  const auto message = [](const Curve& curve) -> std::string {
    try {
      CurveFunction(curve, CurveKind::linear, "profile");
    } catch (const InvalidArgument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(message({}), testing::HasSubstr("profile: has no knot"));
  EXPECT_THAT(message({{{0, 1}, {2, 5}, {2, 6}}}), testing::HasSubstr("knot 2 (2, 6)"));
  EXPECT_THAT(message({{{0, 1}, {-1, 5}}}), testing::HasSubstr("knot 1 (-1, 5)"));
  EXPECT_THAT(message({{{0, std::numeric_limits<double>::quiet_NaN()}}}), testing::HasSubstr("not finite"));
}

TEST(CurveTable, StaysWithinItsErrorBound) {
  const CurveFunction f(kProfile);
  const CurveTable table(f, 0.0, 5.0);
  double second = 0;
  for (double x = 0.01; x < 4.99; x += 0.001) {
    second = std::max(second, std::abs(f(x - 1e-4) - 2 * f(x) + f(x + 1e-4)) / 1e-8);
  }
  const double step = 5.0 / 4095;
  const double bound = 2 * second * step * step / 8 + 2e-7 * 1200 + 1200 * 5e-7;
  std::vector<float> xs, ys;
  for (double x = -1; x < 6; x += 0.00137) xs.push_back(static_cast<float>(x));
  ys.resize(xs.size());
  table.evaluate(xs, ys);
  for (size_t i = 0; i < xs.size(); ++i) {
    EXPECT_NEAR(ys[i], f(static_cast<double>(xs[i])), bound) << xs[i];
    EXPECT_EQ(ys[i], table(xs[i]));
  }
}

}  // namespace
}  // namespace seamount::geom
