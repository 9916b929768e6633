#include "seamount/ops/contour/move/displacement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "seamount/base/error.h"

namespace seamount::contour {
namespace {

/// -min of the derivative by central differences.
double measured_fall(const Displacement& delta) {
  double least = 0.0;
  constexpr double h = 1e-6;
  for (double x = h; x < 1.0 - h; x += 1e-4) least = std::min(least, (delta(x + h) - delta(x - h)) / (2 * h));
  return -least;
}

TEST(Displacement, LongestSegmentIsThePapers) {
  EXPECT_DOUBLE_EQ(longest_segment(100, 1), 50.0);
  EXPECT_NEAR(longest_segment(100, 2), 64.95, 0.01);
  EXPECT_NEAR(longest_segment(100, 3), 58.24, 0.01);
}

TEST(Displacement, LongestSegmentMakesTheDerivativeMinusOne) {
  for (int k = 1; k <= 16; ++k) {
    const Displacement delta(k);
    // delta of P2 is epsilon / (2 r) times ours.
    EXPECT_NEAR(longest_segment(1.0, k) / 2.0 * measured_fall(delta), 1.0, 1e-3) << k;
  }
}

TEST(Displacement, IsZeroAtTheRimAndOneInTheMiddle) {
  for (int k = 1; k <= 8; ++k) {
    const Displacement delta(k);
    EXPECT_EQ(delta(0.0), 0.0);
    EXPECT_EQ(delta(1.0), 0.0);
    EXPECT_EQ(delta(0.5), 1.0);
  }
}

TEST(Displacement, ADrawnOneIsScaledAndItsBoundIsItsOwn) {
  const Displacement delta(Curve{{{0, 0}, {0.3, 0.1}, {0.5, 0.5}, {0.6, 0.45}, {1, 0}}}, "profile");
  EXPECT_DOUBLE_EQ(delta(0.5), 1.0);
  EXPECT_NEAR(delta(0.3), 0.2, 1e-3);
  EXPECT_EQ(delta(0.0), 0.0);
  EXPECT_EQ(delta(1.0), 0.0);
  EXPECT_GE(delta.steepest_fall() * 1.001, measured_fall(delta));
  EXPECT_NEAR(delta.steepest_fall(), measured_fall(delta), 0.02 * delta.steepest_fall());
}

TEST(Displacement, SaysWhatIsWrongWithADrawnOne) {
  const auto message = [](const Curve& curve) -> std::string {
    try {
      const Displacement delta(curve, "profile");
      static_cast<void>(delta);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message({{{0, 0.1}, {0.5, 1}, {1, 0}}}),
            "profile: is 0.1 at 0 and 0 at 1; it must be 0 at both ends, or space tears at the disc's rim");
  EXPECT_EQ(message({{{0, 0}, {0.5, 0}, {1, 0}}}), "profile: is 0 in the middle; it must be above 0 at x = 0.5");
  EXPECT_EQ(message({{{-1, 0}, {0.5, 1}, {1, 0}}}),
            "profile: x = -1 is outside [0, 1], from the disc's rim to its rim");
}

}  // namespace
}  // namespace seamount::contour
