#include "seamount/geom/scalar/blend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace seamount::geom {
namespace {

TEST(Smoothstep, HasThePapersValuesAndIsConstantBeyond) {
  EXPECT_EQ(smoothstep(0.0), 0.0);
  EXPECT_EQ(smoothstep(1.0), 1.0);
  EXPECT_EQ(smoothstep(0.5), 0.5);
  EXPECT_DOUBLE_EQ(smoothstep(0.25), 3 * 0.0625 - 2 * 0.015625);
  EXPECT_EQ(smoothstep(-3.0), 0.0);
  EXPECT_EQ(smoothstep(7.0), 1.0);
  EXPECT_FLOAT_EQ(smoothstep(0.25F), 0.15625F);
}

/// P0 eq. 1.12, 1.13 and 1.15, as printed.
double papers_smax(double a, double b, double k) {
  if (a == b) return a + 1.0 / (2.0 * k);
  const double minus = a + (b - a) / (1.0 + std::exp(-k * (b - a)));
  const double plus = a + (b - a) / (1.0 - std::exp(-k * (b - a)));
  return 0.5 * (minus + plus);
}

TEST(Smax, IsTheMeanOfThePapersTwoFunctions) {
  for (const double k : {0.05, 0.5, 5.0}) {
    for (double d = -8.0; d <= 8.0; d += 0.37) EXPECT_NEAR(smax(3.0, 3.0 + d, k), papers_smax(3.0, 3.0 + d, k), 1e-9);
    EXPECT_DOUBLE_EQ(smax(3.0, 3.0, k), 3.0 + 1.0 / (2.0 * k));
  }
}

TEST(Smax, IsSymmetricAndBetweenTheMaximumAndHalfALengthAbove) {
  for (const double k : {1e-3, 0.5, 50.0}) {
    for (const double d : {0.0, 1e-300, 1e-17, 1e-9, 1e-3, 1.0, 1e3, 1e9, 1e300}) {
      const double up = smax(0.0, d, k);
      EXPECT_EQ(up, smax(d, 0.0, k));
      EXPECT_GE(up, d);
      EXPECT_LE(up, d + 1.0 / (2.0 * k));
      EXPECT_TRUE(std::isfinite(up));
      EXPECT_EQ(smin(0.0, -d, k), -up);
    }
  }
}

TEST(Smax, FloatLoopAgreesWithTheScalarForm) {
  std::vector<float> a, b;
  for (double d = 1e-12; d < 1e6; d *= 1.31) {
    a.insert(a.end(), {0.0F, 0.0F, static_cast<float>(d)});
    b.insert(b.end(), {static_cast<float>(d), static_cast<float>(-d), static_cast<float>(d)});
  }
  for (const float k : {0.01F, 0.5F, 20.0F}) {
    std::vector<float> high(a.size()), low(a.size());
    smax_rows(a, b, k, high);
    smin_rows(a, b, k, low);
    for (size_t i = 0; i < a.size(); ++i) {
      const double exact = smax(static_cast<double>(a[i]), static_cast<double>(b[i]), static_cast<double>(k));
      EXPECT_NEAR(high[i], exact, 1e-6 * (1.0 / k + std::abs(exact)));
      EXPECT_GE(high[i], std::max(a[i], b[i]));
      EXPECT_NEAR(low[i], smin(static_cast<double>(a[i]), static_cast<double>(b[i]), static_cast<double>(k)),
                  1e-6 * (1.0 / k + std::abs(exact)));
      EXPECT_EQ(high[i], smax(a[i], b[i], k)) << "vector and scalar bits differ";
    }
  }
}

TEST(Smax, RowsMayBeChangedInPlace) {
  std::vector<float> a = {1, 2, 3}, b = {3, 2, 1}, out(3);
  smax_rows(a, b, 0.5F, out);
  smax_rows(a, b, 0.5F, a);
  EXPECT_EQ(a, out);
}

}  // namespace
}  // namespace seamount::geom
