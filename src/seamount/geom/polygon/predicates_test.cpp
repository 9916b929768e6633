#include "seamount/geom/polygon/predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

__extension__ using Wide = __int128;

/// Judges with whole numbers: coordinates that are multiples of 2^-55 and less than 32 away from 0, in units of that.
struct WholePlace {
  Wide x, y;
};
WholePlace whole(Vec2 p) {
  constexpr double kUnits = 0x1p55;
  return {static_cast<Wide>(p.x * kUnits), static_cast<Wide>(p.y * kUnits)};
}

int judged_orientation(Vec2 p, Vec2 q, Vec2 r) {
  const WholePlace a = whole(p), b = whole(q), c = whole(r);
  const Wide area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return area > 0 ? 1 : (area < 0 ? -1 : 0);
}

bool judged_on(Vec2 p, Vec2 a, Vec2 b) {
  return judged_orientation(a, b, p) == 0 && p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) &&
         p.y >= std::min(a.y, b.y) && p.y <= std::max(a.y, b.y);
}

/// By the definition: properly across each other, or an end of one on the other.
bool judged_meeting(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const bool across = judged_orientation(a, b, c) * judged_orientation(a, b, d) < 0 &&
                      judged_orientation(c, d, a) * judged_orientation(c, d, b) < 0;
  return across || judged_on(a, c, d) || judged_on(b, c, d) || judged_on(c, a, b) || judged_on(d, a, b);
}

/// How the sign was found before: by the rounded formula.
int rounded_orientation(Vec2 a, Vec2 b, Vec2 c) {
  const double area = cross(b - a, c - a);
  return area > 0.0 ? 1 : (area < 0.0 ? -1 : 0);
}

/// A coordinate on or near one of a few values, some with all their bits used, so that lines through several are
/// frequent and near misses more so.
double awkward(Rng& rng) {
  constexpr std::array<double, 6> kValues = {0.5, 12.0, 24.0, 0.1, 1.0 / 3.0, -7.3};
  const double value = kValues[static_cast<size_t>(rng.integer(0, 5))];
  const double steps = rng.integer(-3, 3);
  // Multiples of 2^-55 all: the last bit of the least of them is worth 2^-56, and is dropped.
  return std::floor((value + steps * std::abs(value) * 0x1p-52) * 0x1p55) * 0x1p-55;
}

Vec2 awkward_place(Rng& rng) {
  const double x = awkward(rng);
  return {x, rng.chance(0.6) ? x + rng.integer(-1, 1) * 0x1p-52 * std::abs(x) : awkward(rng)};
}

bool fits(Vec2 p) {
  const auto fine = [](double v) { return std::abs(v) < 32.0 && v * 0x1p55 == std::floor(v * 0x1p55); };
  return fine(p.x) && fine(p.y);
}

TEST(OrientationSign, IsThatOfWholeNumbersOnNearlyStraightLines) {
  Rng rng(Seed{1});
  int straight = 0, wrong_before = 0, tried = 0;
  while (tried < 200000) {
    const Vec2 a = awkward_place(rng), b = awkward_place(rng), c = awkward_place(rng);
    if (!fits(a) || !fits(b) || !fits(c)) continue;
    ++tried;
    const int judged = judged_orientation(a, b, c);
    ASSERT_EQ(orientation_sign(a, b, c), judged) << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y;
    ASSERT_EQ(exact_orientation_sign(a, b, c), judged);
    straight += judged == 0;
    wrong_before += rounded_orientation(a, b, c) != judged;
  }
  EXPECT_GT(straight, 1000);
  EXPECT_GT(wrong_before, 1000) << "the cases are not hard enough to tell";
}

TEST(OrientationSign, IsThatOfWholeNumbersAroundAPointOnADiagonal) {
  // Kettner and others 2008, "Classroom examples of robustness problems in geometric computations", figure 2.
  int wrong_before = 0;
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      const Vec2 a{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53}, b{12.0, 12.0}, c{24.0, 24.0};
      ASSERT_EQ(orientation_sign(a, b, c), judged_orientation(a, b, c)) << i << ' ' << j;
      wrong_before += rounded_orientation(a, b, c) != judged_orientation(a, b, c);
    }
  }
  EXPECT_GT(wrong_before, 1000);
}

TEST(OrientationSign, ObeysItsAlgebra) {
  Rng rng(Seed{2});
  for (int trial = 0; trial < 50000; ++trial) {
    const Vec2 a = awkward_place(rng), b = awkward_place(rng), c = awkward_place(rng);
    const int sign = orientation_sign(a, b, c);
    ASSERT_EQ(orientation_sign(b, c, a), sign);
    ASSERT_EQ(orientation_sign(c, a, b), sign);
    ASSERT_EQ(orientation_sign(b, a, c), -sign);
    ASSERT_EQ(orientation_sign(a, c, b), -sign);
    ASSERT_EQ(orientation_sign(c, b, a), -sign);
    ASSERT_EQ(orientation_sign(a, a, c), 0);
    ASSERT_EQ(orientation_sign(a, b, b), 0);
    const auto mirrored = [](Vec2 p) { return Vec2{p.y, p.x}; };
    ASSERT_EQ(orientation_sign(mirrored(a), mirrored(b), mirrored(c)), -sign);
    for (const double scale : {0x1p-300, 0x1p300, -1.0})
      ASSERT_EQ(orientation_sign(scale * a, scale * b, scale * c), sign) << scale;
  }
}

TEST(OrientationSign, DoesNotChangeWithAnExactShift) {
  Rng rng(Seed{3});
  for (int trial = 0; trial < 50000; ++trial) {
    const auto place = [&] { return Vec2{rng.integer(-40, 40) + 0.0, rng.integer(-40, 40) + 0.0}; };
    const Vec2 a = place(), b = place(), c = place();
    const Vec2 by{0x1p46 * rng.integer(-20, 20), 0x1p46 * rng.integer(-20, 20)};
    ASSERT_EQ(orientation_sign(a + by, b + by, c + by), orientation_sign(a, b, c));
  }
}

TEST(OrientationSign, HoldsAtTheEndsOfItsRange) {
  for (const double size : {0x1p-400, 0x1p-200, 1.0, 0x1p200, 0x1p399}) {
    const double next = std::nextafter(size, std::numeric_limits<double>::infinity());
    EXPECT_EQ(orientation_sign({0, 0}, {size, size}, {2 * size, 2 * size}), 0) << size;
    EXPECT_EQ(orientation_sign({0, 0}, {size, size}, {size, next}), 1) << size;
    EXPECT_EQ(orientation_sign({0, 0}, {size, next}, {2 * size, 2 * size}), -1) << size;
    EXPECT_EQ(orientation_sign({0x1p-400, 0x1p-400}, {size, size}, {0x1p400, 0x1p400}), 0) << size;
  }
  EXPECT_EQ(orientation_sign({0x1p-400, 0}, {1, 1}, {0x1p400, 0x1p400}), -1) << "1 and 2^-400 side by side";
}

TEST(SegmentsMeet, AsTheDefinitionSays) {
  Rng rng(Seed{4});
  int meeting = 0, tried = 0;
  while (tried < 200000) {
    const Vec2 a = awkward_place(rng), b = awkward_place(rng), c = awkward_place(rng), d = awkward_place(rng);
    if (!fits(a) || !fits(b) || !fits(c) || !fits(d)) continue;
    ++tried;
    const bool judged = judged_meeting(a, b, c, d);
    meeting += judged;
    for (const bool turned : {false, true}) {
      const Vec2 from = turned ? b : a, to = turned ? a : b;
      ASSERT_EQ(segments_meet(from, to, c, d), judged);
      ASSERT_EQ(segments_meet(from, to, d, c), judged);
      ASSERT_EQ(segments_meet(c, d, from, to), judged);
      ASSERT_EQ(segments_meet(d, c, from, to), judged);
    }
    if (!judged) continue;
    const Vec2 at = meeting_place(a, b, c, d);
    ASSERT_LE(std::abs(at.x - std::clamp(at.x, std::min(a.x, b.x), std::max(a.x, b.x))), 1e-14);
    ASSERT_LE(std::abs(at.y - std::clamp(at.y, std::min(a.y, b.y), std::max(a.y, b.y))), 1e-14);
  }
  EXPECT_GT(meeting, 10000);
  EXPECT_LT(meeting, 190000);
}

TEST(SegmentsMeet, OnASmallLatticeWhereEveryCaseComes) {
  const auto place = [](int i) { return Vec2{i % 3 + 0.0, i / 3 + 0.0}; };
  for (int i = 0; i < 9 * 9 * 9 * 9; ++i) {
    const Vec2 a = place(i % 9), b = place(i / 9 % 9), c = place(i / 81 % 9), d = place(i / 729);
    ASSERT_EQ(segments_meet(a, b, c, d), judged_meeting(a, b, c, d)) << i;
  }
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {1, 0}, {3, 0})) << "overlap";
  EXPECT_FALSE(segments_meet({0, 0}, {1, 0}, {2, 0}, {3, 0})) << "one after the other";
  EXPECT_EQ(meeting_place({0, 0}, {2, 2}, {0, 2}, {2, 0}), (Vec2{1, 1}));
  EXPECT_EQ(meeting_place({0, 0}, {2, 2}, {1, 1}, {5, 0}), (Vec2{1, 1}));
}

TEST(TurnsBack, OnlyWhereALineLiesOnItself) {
  EXPECT_TRUE(turns_back({0, 0}, {3, 3}, {1, 1}));
  EXPECT_TRUE(turns_back({0, 0}, {0, 3}, {0, -8}));
  EXPECT_FALSE(turns_back({0, 0}, {3, 3}, {4, 4}));
  EXPECT_FALSE(turns_back({0, 0}, {0, 3}, {0, 4}));
  EXPECT_FALSE(turns_back({0, 0}, {3, 3}, {1, std::nextafter(1.0, 2.0)}));
  EXPECT_FALSE(turns_back({0, 0}, {0.1, 0.3}, {0.001, 0.003})) << "a hair beside, which rounding loses";
}

}  // namespace
}  // namespace seamount::geom
