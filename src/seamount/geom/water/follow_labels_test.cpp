#include "seamount/geom/water/follow_labels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

/// A cone of land, 100 m high, in a lagoon of 10 m within a reef and the deep; its coast at 600 m.
HeightField island(double by_m = 0) {
  HeightField z(GridFrame::centred(90, 80, 40));
  for (int y = 0; y < z.height(); ++y) {
    for (int x = 0; x < z.width(); ++x) {
      const double r = std::hypot(z.frame().x(x), z.frame().y(y));
      const double own = r < 600 ? 100 * (1 - r / 600) + 0.5 : r < 900 ? -10 : r < 1100 ? -1.5 : -200;
      z(x, y) = static_cast<float>(own + by_m);
    }
  }
  return z;
}

LabelMap regions() {
  LabelMap labels(island().frame());
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      const double r = std::hypot(labels.frame().x(x), labels.frame().y(y));
      labels(x, y) = r < 500    ? Region::mountain
                     : r < 600  ? Region::beach
                     : r < 900  ? Region::lagoon
                     : r < 1100 ? Region::reef
                                : Region::abyss;
    }
  }
  return labels;
}

bool is_land(Region region) { return region == Region::mountain || region == Region::beach; }

void expect_lawful(const LabelMap& labels, const HeightField& z, float sea_m = 0) {
  for (size_t i = 0; i < z.size(); ++i) ASSERT_EQ(is_land(labels.data()[i]), z.data()[i] > sea_m) << i;
}

TEST(FollowLabels, StayWhereNothingChanges) {
  EXPECT_EQ(follow_labels(regions(), island(), island(), 0, {}), regions());
}

TEST(FollowLabels, LandIsLandAndSeaIsSeaWhateverHappens) {
  for (const uint64_t seed : {1, 2, 3}) {
    const HeightField before = island();
    HeightField after = before;
    const ScalarField change =
        fbm_grid(after.frame(), Seed{seed}, {.wavelength_m = 700, .octaves = 4, .cell_m = 40}, {});
    for (size_t i = 0; i < after.size(); ++i) after.data()[i] += 30 * change.data()[i] + 0.01F;
    const LabelMap made = follow_labels(regions(), before, after, -300, {});
    for (const Region region : made.cells()) ASSERT_TRUE(is_land(region)) << "no sea at all";
    // Below the sea no hollow of land: what lies above or below stays comparable.
    for (size_t i = 0; i < after.size(); ++i)
      if (before.data()[i] < -100) after.data()[i] = -200;
    const LabelMap wet = follow_labels(regions(), before, after, 0, {});
    int wrong = 0;
    for (size_t i = 0; i < after.size(); ++i) wrong += after.data()[i] > 0 && !is_land(wet.data()[i]) ? 1 : 0;
    EXPECT_EQ(wrong, 0);
    const LabelMap plain = plain_labels(after, 0, {});
    for (size_t i = 0; i < after.size(); ++i) ASSERT_EQ(is_land(plain.data()[i]), is_land(wet.data()[i]));
  }
}

TEST(FollowLabels, FilledLagoonIsBeachAndTheOldBeachIsNone) {
  HeightField after = island();
  for (int y = 0; y < after.height(); ++y) {
    for (int x = 0; x < after.width(); ++x) {
      const double r = std::hypot(after.frame().x(x), after.frame().y(y));
      if (r >= 600 && r < 800) after(x, y) = 2.0F;
    }
  }
  const LabelMap made = follow_labels(regions(), island(), after, 0, {});
  expect_lawful(made, after);
  const int y = 40, middle = 45;
  EXPECT_EQ(made(middle + 19, y), Region::beach) << "by the new coast";
  EXPECT_EQ(made(middle + 13, y), Region::mountain) << "the ghost of a beach";
  EXPECT_EQ(made(middle + 21, y), Region::lagoon);
  EXPECT_EQ(made(middle + 25, y), Region::reef);
}

TEST(FollowLabels, DrownedLandIsLagoonAndItsBeachMovesUp) {
  const HeightField after = island(-30);
  const LabelMap made = follow_labels(regions(), island(), after, 0, {});
  expect_lawful(made, after);
  const int y = 40, middle = 45;
  EXPECT_EQ(made(middle + 12, y), Region::lagoon);
  EXPECT_EQ(made(middle + 10, y), Region::beach);
  EXPECT_EQ(made(middle, y), Region::mountain);
  EXPECT_EQ(made(middle + 25, y), Region::reef);
  LabelMap bare = regions();
  for (Region& region : bare.cells())
    if (!is_land(region)) region = Region::abyss;
  EXPECT_EQ(follow_labels(bare, island(), after, 0, {})(middle + 12, y), Region::abyss);
}

TEST(FollowLabels, AnyNumberOfThreadsAndTinyMaps) {
  const HeightField after = island(-20);
  EXPECT_EQ(follow_labels(regions(), island(), after, 0, {.threads = 1}),
            follow_labels(regions(), island(), after, 0, {.threads = 5}));
  for (const float z : {-3.0F, 3.0F}) {
    const HeightField one(GridFrame::centred(1, 1, 10), z);
    EXPECT_EQ(is_land(follow_labels(LabelMap(one.frame(), Region::reef), one, one, 0, {})(0, 0)), z > 0);
  }
}

}  // namespace
}  // namespace seamount::geom
