#include "seamount/ops/classify/terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/ops/classify/exposure.h"
#include "seamount/ops/classify/patches.h"

namespace seamount::classify {
namespace {

/// A round atoll around an island: land to 1500 m from the middle, a lagoon of `lagoon_m`, a reef crest from 4000 to
/// 4500 m, the fore reef and the deep.
HeightField atoll(double lagoon_m = -25.0, double crest_m = -1.5) {
  HeightField out(GridFrame::centred(300, 300, 50.0));
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 300; ++x) {
      const double r = std::hypot(out.frame().x(x), out.frame().y(y));
      double z = 0.0;
      if (r < 1500) {
        z = r > 1250 ? 0.01 * (1500 - r) : 2.5 + 0.4 * (1250 - r);
      } else if (r < 4000) {
        z = std::max(lagoon_m, std::max(-0.05 * (r - 1500), crest_m - 0.1 * (4000 - r)));
      } else if (r < 4500) {
        z = crest_m;
      } else {
        z = crest_m - 0.5 * (r - 4500);
      }
      out(x, y) = static_cast<float>(z);
    }
  }
  return out;
}

Region at(const LabelMap& labels, double x, double y) {
  return labels(static_cast<int>(std::lround(labels.frame().column(x))),
                static_cast<int>(std::lround(labels.frame().row(y))));
}

TEST(ClassifyTerrain, FindsTheZonesOfAnIslandInTheirOrder) {
  const LabelMap labels = terrain(atoll(), {}, {}).labels;
  for (const double turn : {0.0, 1.1, 2.6, 4.0, 5.5}) {
    const auto along = [&](double r) { return at(labels, r * std::cos(turn), r * std::sin(turn)); };
    EXPECT_EQ(along(300), Region::mountain);
    EXPECT_EQ(along(1400), Region::beach);
    EXPECT_EQ(along(2000), Region::lagoon);
    EXPECT_EQ(along(3500), Region::lagoon);
    EXPECT_EQ(along(4250), Region::reef);
    EXPECT_EQ(along(4580), Region::reef);  // the fore reef, 40 m down
    EXPECT_EQ(along(5500), Region::abyss);
  }
}

TEST(ClassifyTerrain, WithoutABarTheWaterIsOpen) {
  const LabelMap labels = terrain(atoll(-25.0, -24.0), {}, {}).labels;
  EXPECT_EQ(at(labels, 3000, 0), Region::abyss);
}

TEST(ClassifyTerrain, ExposureIsOneInTheOpenAndNothingBehindWalls) {
  Grid<uint8_t> barrier(GridFrame::centred(101, 101, 100.0), 0);
  EXPECT_EQ(exposure(barrier, 5000, {})(50, 50), 1.0F);
  for (int y = 0; y < 101; ++y) barrier(50, y) = 1;
  const ScalarField half = exposure(barrier, 1e6, {});
  EXPECT_EQ(half(49, 50), 9.0F / 16.0F);  // half the directions, and along the wall
  for (int i = -2; i <= 2; ++i) {
    for (const auto& [x, y] : {std::pair{20 + i, 18}, {20 + i, 22}, {18, 20 + i}, {22, 20 + i}}) barrier(x, y) = 1;
  }
  EXPECT_EQ(exposure(barrier, 1e6, {})(20, 20), 0.0F);
}

TEST(ClassifyTerrain, FlatSeaOfLandModelsIsAbyss) {
  HeightField land = atoll();
  for (float& z : land.cells()) z = std::max(z, 0.0F);
  const LabelMap labels = terrain(land, {}, {}).labels;
  EXPECT_EQ(at(labels, 4250, 0), Region::abyss);
  EXPECT_EQ(at(labels, 1400, 0), Region::beach);
  EXPECT_EQ(at(labels, 0, 0), Region::mountain);
}

TEST(RemovePatches, SpecksGoToTheirSurroundingsOnTheirSideOfTheCoast) {
  LabelMap labels(GridFrame::centred(20, 20, 10.0), Region::lagoon);
  labels(5, 5) = labels(6, 5) = Region::reef;  // a speck in the lagoon
  labels(12, 12) = Region::mountain;           // an islet stays land
  for (int y = 0; y < 20; ++y) labels(0, y) = Region::abyss;
  remove_patches(labels, 5, {});
  EXPECT_EQ(labels(5, 5), Region::lagoon);
  EXPECT_EQ(labels(6, 5), Region::lagoon);
  EXPECT_EQ(labels(12, 12), Region::mountain);
  EXPECT_EQ(labels(0, 7), Region::abyss);
}

TEST(ClassifyTerrain, LeavesNoSpecks) {
  HeightField rough = atoll();
  for (size_t i = 0; i < rough.size(); ++i) rough.cells()[i] += i % 97 == 0 ? 6.0F : 0.0F;
  LabelMap labels = terrain(rough, {.min_patch_m2 = 50000}, {}).labels;
  const LabelMap once = labels;
  remove_patches(labels, 2, {});
  int64_t changed = 0;
  for (size_t i = 0; i < labels.size(); ++i) changed += labels.cells()[i] != once.cells()[i] ? 1 : 0;
  EXPECT_LT(changed, 10);
}

TEST(ClassifyTerrain, OddShapesAndBadInput) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 30}, {30, 1}, {2, 2}}) {
    EXPECT_EQ(terrain(HeightField(GridFrame::centred(width, height, 50.0), -2000.0F), {}, {}).labels,
              LabelMap(GridFrame::centred(width, height, 50.0), Region::abyss));
  }
  EXPECT_THROW(terrain(HeightField(), {}, {}), InvalidArgument);
  EXPECT_THROW(terrain(HeightField(GridFrame::centred(2, 2, 1.0), std::nanf("")), {}, {}), InvalidArgument);
  EXPECT_THROW(terrain(atoll(), {.exposed = 2}, {}), InvalidArgument);
  EXPECT_EQ(terrain(atoll(), {}, {.threads = 1}).labels, terrain(atoll(), {}, {.threads = 3}).labels);
}

}  // namespace
}  // namespace seamount::classify
