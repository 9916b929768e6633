#include "seamount/geom/solve/raise_sinks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/rng.h"
#include "seamount/geom/solve/drain.h"

namespace seamount::geom {
namespace {

constexpr float kHigh = std::numeric_limits<float>::infinity();

const Rising kLevel{0.0F, 0.0F, [](int64_t) { return kHigh; }};

HeightField rough(uint64_t seed, int width, int height) {
  HeightField z(GridFrame::centred(width, height, 1.0));
  Rng rng(Seed{seed});
  for (float& value : z.cells()) value = static_cast<float>(rng.uniform(0, 100));
  return z;
}

/// The least surface above z that falls to the border or to an allowed cell, by sweeps until nothing changes.
HeightField filled(const HeightField& z, const std::vector<int64_t>& allowed) {
  HeightField w(z.frame(), kHigh);
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < z.height(); ++y) {
      for (int x = 0; x < z.width(); ++x) {
        const bool leaves = x == 0 || y == 0 || x == z.width() - 1 || y == z.height() - 1 ||
                            std::count(allowed.begin(), allowed.end(), static_cast<int64_t>(y) * z.width() + x) > 0;
        float least = leaves ? -kHigh : kHigh;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            if (z.contains(x + dx, y + dy)) least = std::min(least, w(x + dx, y + dy));
        const float now = std::max(z(x, y), least);
        changed = changed || now < w(x, y);
        w(x, y) = std::min(w(x, y), now);
      }
    }
  }
  return w;
}

TEST(RaiseSinks, IsTheLeastSurfaceThatDrains) {
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const HeightField z = rough(seed, 20 + static_cast<int>(seed), 25);
    const std::vector<int64_t> allowed = {static_cast<int64_t>(12) * z.width() + 9};
    HeightField raised = z;
    raise_sinks(raised, allowed, kLevel, {});
    const HeightField least = filled(z, allowed);
    for (size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(raised.cells()[i], least.cells()[i], 0.01) << seed << " " << i;
    for (const int64_t sink : find_sinks(raised, {})) EXPECT_EQ(sink, allowed[0]) << seed;
  }
}

TEST(RaiseSinks, HangsContinuouslyOnTheHeights) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    HeightField a = rough(seed, 60, 40);
    HeightField b = a;
    Rng rng(Seed{seed}.derive("noise"));
    for (float& value : b.cells()) value += static_cast<float>(rng.uniform(-0.01, 0.01));
    raise_sinks(a, {}, kLevel, {});
    raise_sinks(b, {}, kLevel, {});
    for (size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a.cells()[i], b.cells()[i], 0.02);
  }
}

TEST(RaiseSinks, TiltsWhatItRaises) {
  HeightField z(GridFrame::centred(60, 20, 1.0), 10.0F);  // a hollow with its way out in the west
  for (int y = 1; y < 19; ++y)
    for (int x = 1; x < 59; ++x) z(x, y) = 5.0F;
  z(0, 10) = 7.0F;
  raise_sinks(z, {}, {0.02F, 0.5F, [](int64_t) { return kHigh; }}, {});
  EXPECT_TRUE(find_sinks(z, {}).empty());
  for (int x = 2; x < 58; ++x) EXPECT_GT(z(x, 10), z(x - 1, 10)) << x;
  EXPECT_NEAR(z(40, 10) - z(20, 10), 20 * 0.02, 1e-3);
  EXPECT_LE(z(58, 18), 7.0F + 0.5F * 2.1F) << "by half of the pit's depth at most, and steps of a float";
}

TEST(RaiseSinks, KeepsBelowTheCeiling) {
  HeightField z = rough(3, 40, 40);
  const HeightField before = z;
  raise_sinks(z, {}, {0.1F, 1.0F, [](int64_t) { return 30.0F; }}, {});
  for (size_t i = 0; i < z.size(); ++i) {
    EXPECT_GE(z.cells()[i], before.cells()[i]);
    EXPECT_LE(z.cells()[i], std::max(30.0F, before.cells()[i]));
  }
}

TEST(RaiseSinks, LeavesWhatDrainsAlone) {
  HeightField z(GridFrame::centred(30, 30, 1.0));
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 30; ++x) z(x, y) = static_cast<float>(x + 2 * y);
  const HeightField before = z;
  raise_sinks(z, {}, {1.0F, 1.0F, [](int64_t) { return kHigh; }}, {});
  EXPECT_EQ(z, before);
}

}  // namespace
}  // namespace seamount::geom
