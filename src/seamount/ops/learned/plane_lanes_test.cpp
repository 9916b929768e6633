#include "seamount/ops/learned/plane_lanes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/ops/learned/plane_math.h"

namespace seamount::learned {
namespace {

TEST(PlaneLanes, StandTogetherByCellAfterwards) {
  for (const int width : {1, 7, 8, 64, 65, 131}) {
    for (const int planes : {1, 7, 8, 15, 16, 17}) {
      PlaneLanes lanes(width, planes);
      for (int k = 0; k < planes; ++k)
        for (int x = 0; x < width; ++x) lanes[k][x] = static_cast<float>(1000 * k + x);
      std::vector<float> out(static_cast<size_t>(width * planes), -1);
      lanes.interleave(out.data());
      for (int x = 0; x < width; ++x)
        for (int k = 0; k < planes; ++k) ASSERT_EQ(out[static_cast<size_t>(x * planes + k)], 1000 * k + x);
    }
  }
}

TEST(PlaneMath, IsRightToWhatItPromises) {
  for (double x = -87; x < 87; x += 0.00137) {
    const auto f = static_cast<float>(x);
    const double exact = std::exp(std::clamp<double>(f, -80, 80));
    ASSERT_NEAR(fast_exp(f), exact, 4e-6 * exact + 4e-7) << x;
    ASSERT_NEAR(fast_tanh(f), std::tanh(static_cast<double>(f)), 4e-7) << x;
  }
  for (double x = 1e-30; x < 1e17; x *= 1.0037) {
    const auto f = static_cast<float>(x);
    const double log = std::log(static_cast<double>(f)), root = std::asinh(static_cast<double>(f));
    ASSERT_NEAR(fast_log(f), log, 4e-7 * std::max(1.0, std::abs(log))) << x;
    ASSERT_NEAR(fast_asinh(f), root, 4e-7 * std::max(1.0, root)) << x;
    ASSERT_EQ(fast_asinh(-f), -fast_asinh(f));
  }
  EXPECT_EQ(fast_exp(0), 1);
  EXPECT_EQ(fast_tanh(-INFINITY), -1);
}

}  // namespace
}  // namespace seamount::learned
