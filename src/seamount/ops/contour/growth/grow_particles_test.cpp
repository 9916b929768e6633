// How many nodes contour.grow takes where regions are small (grow.h).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/ops/contour/growth/grow.h"

namespace seamount::contour {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const GridFrame kDomain = GridFrame::centred(100, 100, 10);

GrowParams particles(int count) {
  GrowParams params;
  params.particles = count;
  return params;
}

GrowthRegion square(const std::string& name, Vec2 centre, double half, int parent) {
  const Ring ring = {centre + Vec2{-half, -half}, centre + Vec2{half, -half}, centre + Vec2{half, half},
                     centre + Vec2{-half, half}};
  return {name, ring, parent, {}, false, {}};
}

std::vector<int64_t> nodes_in(const Tin& tin) {
  std::vector<int64_t> nodes(tin.regions.size(), 0);
  for (const int32_t r : tin.region) {
    if (r >= 0) ++nodes[static_cast<size_t>(r)];
  }
  return nodes;
}

/// Terraces of sixteen greys with crinkled edges, here and there as near each other as pixels.
Image terraces(int size, double phase) {
  Image picture(size, size, {0, 0, 0});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double u = (x + 0.5) / size - 0.5, v = (y + 0.5) / size - 0.5;
      const double crinkles = 0.06 * std::sin(31 * u + phase) * std::cos(27 * v) + 0.03 * std::sin(70 * u * v + 50 * v);
      const int level = static_cast<int>(std::clamp(16 * (1.15 - 2.5 * std::hypot(u, 1.3 * v) + crinkles), 0.0, 15.0));
      for (int c = 0; c < 3; ++c) picture.pixel(x, y)[c] = static_cast<uint8_t>(17 * level);
    }
  }
  return picture;
}

TEST(GrowParticles, PicturesOfManyLevelsGetTheNodesThatTheyNeed) {
  for (const double phase : {0.0, 1.7}) {
    const RegionTree tree = regions_from_image(terraces(220, phase), kDomain, {}, "regions", {});
    ASSERT_GT(tree.regions.size(), 14U);
    for (const int count : {60, 400, 5000}) {
      std::vector<std::string> notes;
      RunContext run;
      run.note = [&](const std::string& line) { notes.push_back(line); };
      const Tin tin = grow(tree, kDomain, nullptr, {}, particles(count), Seed{1}, run);
      const std::vector<int64_t> nodes = nodes_in(tin);
      EXPECT_GT(*std::min_element(nodes.begin(), nodes.end()), 0) << count;
      EXPECT_EQ(tin.regions.size(), tree.regions.size()) << count;
      const auto land = tin.region.size() - static_cast<size_t>(std::count(tin.region.begin(), tin.region.end(), -1));
      EXPECT_EQ(notes.empty(), land < 1.2 * count) << count << ", " << land;
      if (!notes.empty()) {
        EXPECT_THAT(notes[0],
                    AllOf(HasSubstr("are too few for the smallest regions"), HasSubstr(std::to_string(land))));
      }
    }
  }
}

TEST(GrowParticles, RegionsSmallerThanAnyNodesAreLeftOutAndSaid) {
  const RegionTree tree{
      {square("land", {0, 0}, 400, -1), square("speck", {50, 0}, 0.05, 0), square("hill", {-200, 0}, 60, 0)}};
  std::vector<std::string> notes;
  RunContext run;
  run.note = [&](const std::string& line) { notes.push_back(line); };
  const Tin tin = grow(tree, kDomain, nullptr, {}, particles(200000), Seed{1}, run);
  ASSERT_EQ(tin.regions.size(), 2U);
  EXPECT_EQ(tin.regions[1].name, "hill");
  ASSERT_EQ(notes.size(), 1U);  // no node more for a speck
  EXPECT_THAT(notes[0], AllOf(HasSubstr("the region 'speck' is smaller than nodes"), HasSubstr("left out")));
}

TEST(GrowParticles, ATinyRegionDoesNotMultiplyTheNodes) {
  for (const double half : {0.4, 1.5, 3.0}) {
    const RegionTree tree{{square("land", {0, 0}, 400, -1), square("speck", {50, 0}, half, 0)}};
    std::vector<std::string> notes;
    RunContext run;
    run.note = [&](const std::string& line) { notes.push_back(line); };
    const Tin tin = grow(tree, kDomain, nullptr, {}, particles(500), Seed{1}, run);
    const auto land = tin.region.size() - static_cast<size_t>(std::count(tin.region.begin(), tin.region.end(), -1));
    EXPECT_LT(land, 1000U) << half;
    ASSERT_EQ(notes.size(), 1U) << half;
    EXPECT_THAT(notes[0], HasSubstr("'speck' is smaller than nodes")) << half;
  }
}

}  // namespace
}  // namespace seamount::contour
