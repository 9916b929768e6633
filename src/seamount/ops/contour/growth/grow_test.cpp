#include "seamount/ops/contour/growth/grow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/growth/probability.h"

namespace seamount::contour {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

size_t at(int32_t i) { return static_cast<size_t>(i); }

Ring blob(Vec2 centre, double radius, double wobble = 0.0, double phase = 0.0) {
  Ring ring;
  for (int i = 0; i < 48; ++i) {
    const double angle = std::numbers::pi * i / 24;
    const double r = radius * (1 + wobble * std::sin(5 * angle + phase));
    ring.push_back(centre + r * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

GrowthRegion region(const std::string& name, const Ring& ring, int parent, bool basin = false) {
  return {name, ring, parent, {}, basin};
}

const GridFrame kDomain = GridFrame::centred(100, 100, 10);

GrowParams particles(int count) {
  GrowParams params;
  params.particles = count;
  return params;
}

std::vector<std::vector<int32_t>> adjacency(const Tin& tin) {
  std::vector<std::vector<int32_t>> around(tin.nodes.size());
  for (const auto& t : tin.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      around[at(t[k])].push_back(t[(k + 1) % 3]);
      around[at(t[(k + 1) % 3])].push_back(t[k]);
    }
  }
  return around;
}

/// The regions around a region, from itself outwards.
std::vector<int32_t> chain(const Tin& tin, int32_t r) {
  std::vector<int32_t> regions;
  for (; r >= 0; r = tin.regions[at(r)].parent) regions.push_back(r);
  return regions;
}

/// Is `there` lower ground than `here`? Judged from the lowest region around both, by a way of its own.
bool drains(const Tin& tin, int32_t here, int32_t there) {
  const std::vector<int32_t> up = chain(tin, here), down = chain(tin, there);
  const bool inside = std::find(down.begin(), down.end(), here) != down.end();
  if (inside) {
    const auto next = std::find(down.begin(), down.end(), here) - 1;
    return tin.regions[at(*next)].basin;
  }
  return there < 0 || std::find(up.begin(), up.end(), there) != up.end();
}

/// Nodes of hills in the domain without any lower neighbour. Beyond its edge water may leave.
int endorheic(const Tin& tin) {
  const auto around = adjacency(tin);
  int count = 0;
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    const int32_t here = tin.region[i];
    if (here < 0 || tin.regions[at(here)].basin) continue;
    const Vec2 p = tin.nodes[i];
    if (p.x < tin.frame.west_m || p.x > tin.frame.east_m() || p.y < tin.frame.south_m() || p.y > tin.frame.north_m) {
      continue;
    }
    const bool drained = std::any_of(around[i].begin(), around[i].end(), [&](int32_t n) {
      const int32_t there = tin.region[at(n)];
      return there == here ? tin.rank[at(n)] < tin.rank[i] : drains(tin, here, there);
    });
    if (!drained) ++count;
  }
  return count;
}

void expect_sound(const Tin& tin) {
  ASSERT_EQ(tin.region.size(), tin.nodes.size());
  ASSERT_EQ(tin.rank.size(), tin.nodes.size());
  std::vector<std::vector<float>> ranks(tin.regions.size());
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    if (tin.region[i] >= 0) ranks[at(tin.region[i])].push_back(tin.rank[i]);
  }
  for (std::vector<float>& list : ranks) {
    ASSERT_FALSE(list.empty());
    std::sort(list.begin(), list.end());
    for (size_t k = 0; k < list.size(); ++k) {
      ASSERT_FLOAT_EQ(list[k], (static_cast<float>(k) + 0.5F) / static_cast<float>(list.size()));
      if (k > 0) {
        ASSERT_LT(list[k - 1], list[k]);
      }
    }
  }
}

TEST(Grow, OneRegionGrowsInwards) {
  const RegionTree tree{{region("land", blob({0, 0}, 400), -1)}};
  const Tin tin = grow(tree, kDomain, nullptr, {}, particles(3000), Seed{1}, {});
  expect_sound(tin);
  EXPECT_EQ(endorheic(tin), 0);
  const auto inside = std::count(tin.region.begin(), tin.region.end(), 0);
  EXPECT_NEAR(static_cast<double>(inside), 3000, 150);
  double centre = 0.0, border = 0.0;
  int centres = 0, borders = 0;
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    const double r = std::hypot(tin.nodes[i].x, tin.nodes[i].y);
    ASSERT_EQ(tin.region[i] == 0, geom::contains(tree.regions[0].outline, tin.nodes[i]));
    if (r < 80) centre += static_cast<double>(tin.rank[i]), ++centres;
    if (r > 370 && r < 398) border += static_cast<double>(tin.rank[i]), ++borders;
  }
  EXPECT_GT(centre / centres, 0.7);
  EXPECT_LT(border / borders, 0.3);
}

/// A scene of up to five nested regions, some of them basins, some beyond the domain's edge.
RegionTree random_scene(Rng& rng) {
  RegionTree tree;
  const Vec2 centre = {rng.uniform(-450, 450), rng.uniform(-450, 450)};
  const double radius = rng.uniform(250, 500);
  const double wobble = rng.uniform(0, 0.2), phase = rng.uniform(0, 6);
  tree.regions.push_back(region("land", blob(centre, radius, wobble, phase), -1));
  const double inner = radius * (1 - wobble) * 0.85;
  if (rng.chance(0.3)) {  // one hill in the middle, perhaps one more in it
    tree.regions.push_back(region("hill", blob(centre, inner * 0.6, wobble, phase), 0, rng.chance(0.2)));
    if (rng.chance(0.6)) tree.regions.push_back(region("peak", blob(centre, inner * 0.25), 1, rng.chance(0.3)));
    return tree;
  }
  for (const double side : {-1.0, 1.0}) {  // two beside each other
    if (rng.chance(0.25)) continue;
    const int hill = static_cast<int>(tree.regions.size());
    const Vec2 there = centre + side * Vec2{inner * 0.5, rng.uniform(-0.2, 0.2) * inner};
    tree.regions.push_back(region("hill", blob(there, inner * 0.33, rng.uniform(0, 0.15)), 0, rng.chance(0.25)));
    if (rng.chance(0.5)) tree.regions.push_back(region("peak", blob(there, inner * 0.14), hill, rng.chance(0.3)));
  }
  return tree;
}

bool meets(const GrowthRegion& region, const GridFrame& domain) {
  const geom::Box box = geom::bounding_box(region.outline);
  return box.low.x < domain.east_m() - 60 && box.high.x > domain.west_m + 60 && box.low.y < domain.north_m - 60 &&
         box.high.y > domain.south_m() + 60;
}

TEST(Grow, NoNodeIsEndorheicInAThousandScenes) {
  int grown = 0;
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    Rng rng(Seed{seed}.derive("scene"));
    const RegionTree tree = random_scene(rng);
    const bool all_meet =
        std::all_of(tree.regions.begin(), tree.regions.end(), [](const auto& r) { return meets(r, kDomain); });
    if (!all_meet) continue;
    GrowParams params;
    params.spacing_m = rng.uniform(14, 22);
    params.exponent = rng.uniform(0.5, 4);
    params.octaves = 3;
    const Tin tin = grow(tree, kDomain, nullptr, {}, params, Seed{seed}, {.threads = 1});
    expect_sound(tin);
    ASSERT_EQ(endorheic(tin), 0) << "scene " << seed;
    ++grown;
  }
  EXPECT_GT(grown, 700);
}

TEST(Grow, BasinsHaveOneLowestNode) {
  const RegionTree tree{{region("land", blob({0, 0}, 450), -1), region("crater", blob({100, 0}, 180), 0, true)}};
  const Tin tin = grow(tree, kDomain, nullptr, {}, particles(4000), Seed{2}, {});
  const auto around = adjacency(tin);
  int lowest = 0;
  double rim = 0.0;
  int rims = 0;
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    if (tin.region[i] != 1) continue;
    lowest += std::none_of(around[i].begin(), around[i].end(),
                           [&](int32_t n) { return tin.region[at(n)] == 1 && tin.rank[at(n)] < tin.rank[i]; });
    if (std::hypot(tin.nodes[i].x - 100, tin.nodes[i].y) < 165) continue;
    rim += static_cast<double>(tin.rank[i]);
    ++rims;
  }
  EXPECT_EQ(lowest, 1);
  EXPECT_GT(rim / rims, 0.8);
  EXPECT_EQ(endorheic(tin), 0);
}

TEST(Grow, GroundAtTheDomainsEdgeHasNoCoastThere) {
  // The western half of the domain and far beyond it: growth comes from the coast in the middle alone.
  const RegionTree tree{{region("land", {{-900, -900}, {0, -900}, {0, 900}, {-900, 900}}, -1)}};
  GrowParams params = particles(4000);
  params.probability = ProbabilityKind::uniform;
  const Tin tin = grow(tree, kDomain, nullptr, {}, params, Seed{3}, {});
  EXPECT_EQ(endorheic(tin), 0);
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    const Vec2 p = tin.nodes[i];
    ASSERT_EQ(tin.region[i], p.x < 0 ? 0 : -1);
    ASSERT_GT(p.x, -500 - 80);
    if (p.x < -450) {
      EXPECT_GT(tin.rank[i], 0.7F);
    }
    if (p.x > -20 && p.x < 0) {
      EXPECT_LT(tin.rank[i], 0.15F);
    }
  }
}

TEST(Grow, AllOfTheDomainCanBeLand) {
  const RegionTree tree{{region("land", {{-900, -900}, {900, -900}, {900, 900}, {-900, 900}}, -1)}};
  const Tin tin = grow(tree, kDomain, nullptr, {}, particles(2000), Seed{3}, {});
  expect_sound(tin);
  EXPECT_EQ(std::count(tin.region.begin(), tin.region.end(), -1), 0);
}

TEST(Grow, LandWithoutCoastStartsAtTheRiversThatLeaveIt) {
  const RegionTree tree{{region("land", {{-900, -900}, {900, -900}, {900, 900}, {-900, 900}}, -1)}};
  GrowParams params = particles(4000);
  params.probability = ProbabilityKind::uniform;
  params.rivers = {{{{300, 0}, {-900, 0}}, {}, 0.0, 0.0}};
  const Tin tin = grow(tree, kDomain, nullptr, {}, params, Seed{3}, {});
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    if (tin.region[i] == 0 && std::abs(tin.nodes[i].y) > 450) {
      EXPECT_GT(tin.rank[i], 0.5F) << "at the edges that no river crosses the ground is high";
    }
  }
}

TEST(Grow, ProbableGroundIsLow) {
  // A band of high probability across a disc is reached earlier than its surroundings: a valley.
  ScalarField field(kDomain, 0.05F);
  for (int y = 47; y < 53; ++y) {
    for (int x = 0; x < 100; ++x) field(x, y) = 0.95F;
  }
  const RegionTree tree{{region("land", blob({0, 0}, 450), -1)}};
  GrowParams params = particles(5000);
  params.exponent = 1.0;
  const Tin tin = grow(tree, kDomain, &field, {}, params, Seed{3}, {});
  double valley = 0.0, hills = 0.0;
  int valleys = 0, others = 0;
  for (size_t i = 0; i < tin.nodes.size(); ++i) {
    if (std::abs(tin.nodes[i].x) > 200) continue;
    const double y = std::abs(tin.nodes[i].y);
    if (y < 25) valley += static_cast<double>(tin.rank[i]), ++valleys;
    if (y > 90 && y < 140) hills += static_cast<double>(tin.rank[i]), ++others;
  }
  EXPECT_LT(valley / valleys, hills / others - 0.2);
}

TEST(Grow, IsTheSameOnAnyNumberOfThreadsAndDiffersBySeed) {
  const RegionTree tree{{region("land", blob({0, 0}, 450), -1), region("hill", blob({-150, 0}, 120), 0),
                         region("pit", blob({200, 0}, 100), 0, true)}};
  const Tin one = grow(tree, kDomain, nullptr, {}, particles(6000), Seed{4}, {.threads = 1});
  EXPECT_EQ(one, grow(tree, kDomain, nullptr, {}, particles(6000), Seed{4}, {.threads = 3}));
  EXPECT_NE(one.rank, grow(tree, kDomain, nullptr, {}, particles(6000), Seed{5}, {}).rank);
}

std::string message(const RegionTree& tree, const GrowParams& params, const ScalarField* field = nullptr) {
  try {
    grow(tree, kDomain, field, {}, params, Seed{1}, {});
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(Grow, RefusesWhatCannotBeGrown) {
  const RegionTree tree{{region("land", blob({0, 0}, 400), -1), region("peak", blob({50, 0}, 3), 0)}};
  GrowParams params;
  params.spacing_m = 60;
  EXPECT_THAT(message(tree, params), AllOf(HasSubstr("'peak'"), HasSubstr("60 m"), HasSubstr("would do")));
  params.spacing_m = 0.01;
  EXPECT_THAT(message(tree, params), AllOf(HasSubstr("million nodes"), HasSubstr("GB"), HasSubstr("m needs")));
  params.spacing_m = 1e-3;
  EXPECT_THAT(message({{tree.regions[0]}}, params), HasSubstr("million nodes"));
  params.spacing_m = -1;
  EXPECT_THAT(message(tree, params), HasSubstr("spacing_m: -1 is outside"));
  EXPECT_THAT(message({{region("far", blob({9000, 0}, 400), -1)}}, {}), HasSubstr("inside the domain"));
  ScalarField field(kDomain, 0.5F);
  field(30, 20) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(message(tree, particles(90000), &field), AllOf(HasSubstr("no value at (-195, 295) m")));
  field(30, 20) = -0.25F;
  EXPECT_THAT(message(tree, particles(90000), &field), AllOf(HasSubstr("-0.25 at"), HasSubstr("[0, 1]")));
}

/// What the message about a small region advises works.
TEST(Grow, TheSpacingThatIsAdvisedWillDo) {
  const RegionTree tree{{region("land", blob({0, 0}, 400), -1), region("ridge", blob({50, 0}, 30, 0.15), 0),
                         region("peak", {{40, -1}, {60, -1}, {60, 1}, {40, 1}}, 1)}};
  GrowParams params;
  params.spacing_m = 200;
  for (int i = 0; i < 10; ++i) {
    const std::string text = message(tree, params);
    if (text == "none") break;
    const size_t from = text.find("spacing_m of ") + 13;
    ASSERT_LT(std::stod(text.substr(from)), *params.spacing_m);
    params.spacing_m = std::stod(text.substr(from));
  }
  EXPECT_EQ(message(tree, params), "none");
}

TEST(Grow, ProbabilitiesOfNoughtAndOneAreClamped) {
  ScalarField field(kDomain, 0.0F);
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 100; ++x) field(x, y) = 1.0F;
  }
  const RegionTree tree{{region("land", blob({0, 0}, 400), -1), region("hill", blob({0, 0}, 100), 0)}};
  const Tin tin = grow(tree, kDomain, &field, {}, particles(2000), Seed{1}, {});
  expect_sound(tin);
  EXPECT_EQ(endorheic(tin), 0);
}

TEST(Grow, AFewNodesAreEnough) {
  const RegionTree tree{{region("land", blob({0, 0}, 400), -1)}};
  for (const int count : {1, 2, 3, 5, 10, 30}) {
    const Tin tin = grow(tree, kDomain, nullptr, {}, particles(count), Seed{1}, {});
    EXPECT_FALSE(tin.triangles.empty());
    if (count >= 10) {
      EXPECT_EQ(endorheic(tin), 0);
    }
  }
}

TEST(NoiseProbability, KeepsAQuarterAsItsLeast) {
  std::vector<Vec2> places;
  places.reserve(10000);
  for (int i = 0; i < 10000; ++i) places.push_back({37.0 * i, 11.0 * (i % 97)});
  geom::Fbm shape;
  shape.wavelength_m = 500;
  for (const double exponent : {1.0, 2.0}) {
    const std::vector<float> p = noise_probability(places, shape, exponent, Seed{1}, {});
    EXPECT_NEAR(*std::min_element(p.begin(), p.end()), std::pow(0.25, exponent), 1e-3);
    EXPECT_NEAR(*std::max_element(p.begin(), p.end()), 1.0, 1e-3);
  }
}

TEST(PaintedProbability, IsStretchedOverTheDomain) {
  Image picture(4, 2, {0, 0, 0});
  for (int x = 0; x < 4; ++x) picture.pixel(x, 1)[0] = picture.pixel(x, 1)[1] = picture.pixel(x, 1)[2] = 255;
  for (const GridFrame& domain : {GridFrame::centred(100, 100, 10), GridFrame::centred(300, 20, 7)}) {
    const ScalarField field = painted_probability(picture, domain);
    EXPECT_NEAR(field.frame().width_m(), domain.width_m(), 1e-9);
    EXPECT_EQ(field(0, 0), 0.0F);
    EXPECT_EQ(field(field.width() - 1, field.height() - 1), 1.0F);
    EXPECT_EQ(field(0, field.height() / 2), 1.0F);
  }
}

TEST(RandomRegion, LiesInTheDomain) {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    const RegionTree tree = random_region(GridFrame::centred(30, 70, 5), Seed{seed});
    const geom::Box box = geom::bounding_box(tree.regions[0].outline);
    EXPECT_TRUE(box.low.x > -75 && box.high.x < 75 && box.low.y > -175 && box.high.y < 175);
    EXPECT_FALSE(geom::find_defect({tree.regions[0].outline, {}}));
  }
}

}  // namespace
}  // namespace seamount::contour
