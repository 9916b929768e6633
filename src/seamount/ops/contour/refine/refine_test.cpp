#include "seamount/ops/contour/refine/refine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <utility>

#include "seamount/geom/contour/marching_triangles.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/poisson_disc.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/tin/test_tin.h"
#include "seamount/ops/contour/convert/extract.h"
#include "seamount/ops/contour/convert/reconstruct.h"
#include "seamount/ops/contour/growth/grow.h"
#include "seamount/ops/contour/growth/regions.h"
#include "seamount/ops/contour/growth/test_network.h"
#include "seamount/ops/contour/heights/heights.h"
#include "seamount/ops/contour/move/test_contours.h"

namespace seamount::contour {
namespace {

using ::testing::HasSubstr;

const GridFrame kDomain = GridFrame::centred(128, 100, 10);

Ring blob(double radius, Vec2 centre = {}, int points = 90) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double a = 2.0 * std::numbers::pi * i / points;
    ring.push_back(centre + radius * (1.0 + 0.1 * std::sin(3.0 * a)) * Vec2{std::cos(a), std::sin(a)});
  }
  return ring;
}

Tin network(const std::vector<RegionOutline>& outlines, int particles = 900, uint64_t seed = 3) {
  GrowParams params;
  params.particles = particles;
  const RegionTree tree = regions_from_outlines(outlines, kDomain, "outlines");
  HeightsParams heights_params;
  heights_params.max_m = 300;
  return heights(grow(tree, kDomain, nullptr, {}, params, Seed{seed}, {}), nullptr, heights_params, {});
}

Tin isle() { return network({{"isle", blob(420), 0.0, false, {}}}); }

/// Two hills, a crater in the land between them.
Tin two_hills() {
  return network({{"land", blob(440), 0.0, false, {}},
                  {"west", blob(120, {-220, 0}), 120.0, false, {}},
                  {"east", blob(110, {210, 60}), 120.0, false, {}},
                  {"crater", blob(50, {0, -150}), 40.0, true, {}}},
                 1500);
}

/// Of the nodes of the land.
double spacing(const Tin& tin) {
  double twice = 0.0, corners = 0.0;
  for (const auto& [a, b, c] : tin.triangles) {
    const auto is_sea = [&](int32_t node) { return !tin.region.empty() && tin.region[at(node)] < 0; };
    if (is_sea(a) || is_sea(b) || is_sea(c)) continue;
    twice += cross(tin.nodes[at(b)] - tin.nodes[at(a)], tin.nodes[at(c)] - tin.nodes[at(a)]);
    corners += 3.0;
  }
  return std::sqrt(geom::kDiscDensity * 0.5 * twice / (corners / 6.0));
}

template <class From>
std::string message(const From& from, const RefineParams& params, const ScalarField* probability = nullptr) {
  try {
    refine(from, {probability, {}}, params, Seed{1}, {});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Mean distance, in metres of height, of the ground on the outlines from their heights, and how often it is above 10
/// m.
std::pair<double, double> off_outlines(const Tin& tin) {
  const HeightField ground = reconstruct(tin, {.cell_m = spacing(tin) / 3}, {});
  const GridFrame& f = ground.frame();
  double sum = 0.0, far = 0.0, count = 0.0;
  for (const TinRegion& region : tin.regions) {
    for (const Vec2 p : geom::densify(region.outline, 0.5 * spacing(tin))) {
      const double x = f.column(p.x), y = f.row(p.y);
      if (x < 0 || y < 0 || x > f.width - 1 || y > f.height - 1) continue;
      const double off =
          std::abs(static_cast<double>(ground(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)))) -
                   *region.height_m);
      sum += off;
      far += off > 10.0 ? 1.0 : 0.0;
      count += 1.0;
    }
  }
  return {sum / count, far / count};
}

double rms_difference(const Tin& a, const Tin& b, double from_m) {
  const HeightField first = reconstruct(a, {}, {}), second = reconstruct(b, {}, {});
  double sum = 0.0, count = 0.0;
  for (size_t i = 0; i < first.cells().size(); ++i) {
    const double z = first.cells()[i], d = z - static_cast<double>(second.cells()[i]);
    if (z < from_m) continue;
    sum += d * d;
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

double highest(const Tin& tin) { return *std::max_element(tin.height_m.begin(), tin.height_m.end()); }

TEST(Refine, KeepsHeightsAtHeldContoursAndDrains) {
  for (const Tin& coarse : {isle(), two_hills()}) {
    for (uint64_t seed = 0; seed < 6; ++seed) {
      const Tin fine = refine(coarse, {}, {.passes = 2}, Seed{seed}, {});
      ASSERT_FALSE(geom::find_tin_defect(fine).has_value()) << *geom::find_tin_defect(fine);
      EXPECT_NEAR(spacing(fine), spacing(coarse) / 4, 0.06 * spacing(coarse));
      EXPECT_GE(fine.regions.size(), coarse.regions.size() + 3);
      EXPECT_EQ(endorheic(fine), 0) << seed;
      EXPECT_EQ(dishonoured(fine), 0) << seed;
      EXPECT_EQ(nest_regions(regions_of(fine).regions, fine.frame, "held").regions.size(), fine.regions.size());
      const auto [mean, far] = off_outlines(fine);
      EXPECT_LT(mean, 2.0) << seed;  // of 300 m
      EXPECT_LT(far, 0.04) << seed;  // where contours lie closer than nodes
    }
  }
}

TEST(Refine, StaysWithinAStepOfTheCoarseGround) {
  for (const Tin& coarse : {isle(), two_hills()}) {
    const double step = 300.0 / 9;
    for (const int passes : {1, 2, 3}) {
      const Tin fine = refine(coarse, {}, {.passes = passes, .contours = 8}, Seed{2}, {});
      EXPECT_LT(rms_difference(coarse, fine, 0.0), 0.5 * step) << passes;
      EXPECT_NEAR(highest(fine), highest(coarse), 0.5 * step) << passes;
    }
  }
}

TEST(Refine, MoreContoursKeepMore) {
  const Tin coarse = isle();
  const auto difference = [&](int contours) {
    return rms_difference(coarse, refine(coarse, {}, {.passes = 2, .contours = contours}, Seed{5}, {}), 0.0);
  };
  EXPECT_LT(difference(12), 0.7 * difference(1));
}

TEST(Refine, FineOutlinesStayAsTheyAreAndCoarseOnesGetDetail) {
  const Tin fine = refine(network({{"isle", blob(420, {}, 4000), 0.0, false, {}}}), {}, {}, Seed{1}, {});
  EXPECT_EQ(fine.regions[0].name, "isle");
  EXPECT_EQ(fine.regions[0].outline, blob(420, {}, 4000));
  const Ring box = {{-400, -300}, {400, -300}, {400, 300}, {-400, 300}};
  const Tin rough = refine(network({{"box", box, 0.0, false, {}}}), {}, {}, Seed{1}, {});
  EXPECT_GT(rough.regions[0].outline.size(), 200U);
  EXPECT_NEAR(geom::signed_area(rough.regions[0].outline), 480000, 15000);
  EXPECT_GT(geom::ring_length(rough.regions[0].outline), 2840);
}

TEST(Refine, BasinsStayBasins) {
  const Tin coarse = two_hills();
  const Tin fine = refine(coarse, {}, {}, Seed{9}, {});
  const auto floor = [](const Tin& tin) {
    float low = 1e9F;
    for (size_t i = 0; i < tin.nodes.size(); ++i) {
      if (tin.region[i] >= 0 && tin.regions[at(tin.region[i])].basin) low = std::min(low, tin.height_m[i]);
    }
    return static_cast<double>(low);
  };
  EXPECT_LT(floor(fine), 40.0);
  EXPECT_NEAR(floor(fine), floor(coarse), 4.0);
}

/// Over which height a crater's water would leave a raster, and its deepest place.
std::pair<double, double> spill_and_floor(const HeightField& ground, double radius) {
  using Open = std::pair<float, int64_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  std::vector<char> seen(ground.size(), 0);
  const GridFrame& f = ground.frame();
  int64_t first = -1;
  for (int64_t i = 0; i < static_cast<int64_t>(ground.size()); ++i) {
    const double r = std::hypot(f.x(static_cast<int>(i % f.width)), f.y(static_cast<int>(i / f.width)));
    const auto z = [&](int64_t cell) { return ground.cells()[static_cast<size_t>(cell)]; };
    if (r < radius && (first < 0 || z(i) < z(first))) first = i;
  }
  open.emplace(ground.cells()[static_cast<size_t>(first)], first);
  float spill = open.top().first;
  const double floor = static_cast<double>(spill);
  for (;;) {
    const auto [z, cell] = open.top();
    open.pop();
    spill = std::max(spill, z);
    const auto x = static_cast<int>(cell % f.width), y = static_cast<int>(cell / f.width);
    if (x == 0 || y == 0 || x == f.width - 1 || y == f.height - 1) return {static_cast<double>(spill), floor};
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int64_t next = cell + static_cast<int64_t>(dy) * f.width + dx;
        if (std::exchange(seen[static_cast<size_t>(next)], 1) == 0)
          open.emplace(ground.cells()[static_cast<size_t>(next)], next);
      }
    }
  }
}

TEST(Refine, DrawnCratersKeepTheirRimsAndFloors) {
  const std::vector<std::vector<RegionOutline>> drawn = {
      {{"isle", blob(420), 0.0, false, {}}, {"rim", blob(120), 200.0, false, {}}, {"crater", blob(70), {}, true, {}}},
      {{"isle", blob(420), 0.0, false, {}},
       {"rim", blob(100, {}, 12), 200.0, false, {}},
       {"crater", blob(75, {}, 12), 200.5, true, 100.0}},
      {{"isle", blob(420), {}, false, {}}, {"rim", blob(130), {}, false, {}}, {"crater", blob(80), {}, true, {}}}};
  for (size_t i = 0; i < drawn.size(); ++i) {
    for (uint64_t seed = 1; seed <= 2; ++seed) {
      const Tin coarse = network(drawn[i], 800, seed);
      for (const int passes : {1, 2}) {
        const Tin fine = refine(coarse, {}, {.passes = passes}, Seed{seed}, {});
        const auto [was, deep] = spill_and_floor(reconstruct(coarse, {}, {}), 80);
        for (const double cell : {4.0, 10.0}) {
          const auto [spill, floor] = spill_and_floor(reconstruct(fine, {.cell_m = cell}, {}), 80);
          EXPECT_GT(spill, was - 12) << i << " seed " << seed << " passes " << passes << " cell " << cell;
          EXPECT_NEAR(floor, deep, 6) << i << " seed " << seed << " passes " << passes << " cell " << cell;
        }
      }
    }
  }
}

TEST(Refine, RiversStayInTheirBeds) {
  const std::vector<RiverLine> rivers = {{{{30, 60}, {-60, -120}, {40, -440}}, {120, 0}, 0, 20}};
  GrowParams params;
  params.particles = 1200;
  const RegionTree tree = regions_from_outlines({{"isle", blob(420), 0.0, false, {}}}, kDomain, "outlines");
  HeightsParams heights_params;
  heights_params.max_m = 300;
  const Tin coarse = heights(grow(tree, kDomain, nullptr, rivers, params, Seed{3}, {}), nullptr, heights_params, {});
  const Tin fine = refine(coarse, {nullptr, rivers}, {}, Seed{3}, {});
  EXPECT_EQ(endorheic(fine), 0);
  int beds = 0;
  for (size_t i = 0; i < fine.nodes.size(); ++i) {
    if (fine.region[i] < 0 || fine.bed_m[i] == Tin::kNoBed) continue;
    ++beds;
    EXPECT_NEAR(fine.height_m[i], fine.bed_m[i], 1.5);
  }
  EXPECT_GT(beds, 60);
}

TEST(Refine, WaterLeavesAllButBasinsInManyScenes) {
  constexpr int kScenes = 12;
  for (int i = 0; i < kScenes; ++i) {
    Rng rng(Seed{static_cast<uint64_t>(i)});
    const double radius = rng.uniform(250, 480);
    std::vector<RegionOutline> outlines = {{"land", blob(radius), 0.0, false, {}}};
    if (rng.chance(0.5)) outlines.push_back({"hill", blob(0.3 * radius, {0.4 * radius, 0}), 100.0, false, {}});
    if (rng.chance(0.4)) outlines.push_back({"pit", blob(0.2 * radius, {-0.4 * radius, 0}), 60.0, true, {}});
    const Tin coarse = network(outlines, rng.integer(300, 1500), static_cast<uint64_t>(i));
    const RefineParams params{
        .passes = rng.integer(1, 3), .contours = rng.integer(0, 20), .roughness = rng.uniform(0, 2)};
    const Tin fine = refine(coarse, {}, params, Seed{static_cast<uint64_t>(i)}, {});
    ASSERT_FALSE(geom::find_tin_defect(fine).has_value()) << i;
    EXPECT_EQ(endorheic(fine), 0) << i;
    EXPECT_EQ(dishonoured(fine), 0) << i;
    EXPECT_LT(rms_difference(coarse, fine, 0.0), 15.0 + 300.0 / (params.contours + 1)) << i;
  }
}

TEST(Refine, ContoursThatReachTheEdgeOfTheFrame) {
  const HeightField slope = [] {
    HeightField field(kDomain);
    for (int y = 0; y < kDomain.height; ++y) {
      for (int x = 0; x < kDomain.width; ++x)
        field(x, y) = static_cast<float>(200 + 0.12 * kDomain.x(x) +
                                         60 * std::sin(kDomain.y(y) / 110) * std::cos(kDomain.x(x) / 140));
    }
    return field;
  }();
  const ContourSet set = extract(slope, {.interval_m = 25.0}, {});
  for (const int passes : {1, 2}) {
    const Tin fine = refine(set, {}, {.passes = passes}, Seed{4}, {});
    ASSERT_FALSE(geom::find_tin_defect(fine).has_value()) << *geom::find_tin_defect(fine);
    EXPECT_EQ(dishonoured(fine), 0);
    const HeightField back = reconstruct(fine, {}, {});
    double sum = 0.0;
    for (size_t i = 0; i < slope.cells().size(); ++i)
      sum += std::pow(static_cast<double>(slope.cells()[i]) - static_cast<double>(back.cells()[i]), 2);
    EXPECT_LT(std::sqrt(sum / static_cast<double>(slope.cells().size())), 12.5);
  }
}

TEST(Refine, ContoursOfAnIslandAndASurveyedNetwork) {
  const Tin fine = refine(noise_contours(3, 200, 100), {}, {}, Seed{1}, {});
  EXPECT_EQ(endorheic(fine), 0);
  EXPECT_EQ(dishonoured(fine), 0);
  const Tin surveyed = geom::lattice_tin(
      41, 31, 25.0, Seed{1}, [](Vec2 p) { return 300 * std::exp(-dot(p, p) / (2 * 200 * 200)) + 0.05 * p.x; });
  const Tin finer = refine(surveyed, {}, {.passes = 1}, Seed{1}, {});
  EXPECT_EQ(dishonoured(finer), 0);
  EXPECT_LT(rms_difference(surveyed, finer, -1e9), 20.0);
}

TEST(Refine, MessagesSayWhatToDo) {
  Tin flat = isle();
  std::fill(flat.height_m.begin(), flat.height_m.end(), 5.0F);
  EXPECT_THAT(message(flat, {}), HasSubstr("has one height only"));
  flat.height_m.clear();
  EXPECT_THAT(message(flat, {}), HasSubstr("contour.heights"));
  EXPECT_THAT(message(Tin{}, {}), HasSubstr("no triangles"));
  EXPECT_THAT(message(isle(), {.spacing_m = 500.0}), HasSubstr("spacing_m: 500 is not finer than what there is"));
  EXPECT_THAT(message(isle(), {.spacing_m = 0.001}), HasSubstr("GB"));
  EXPECT_THAT(message(ContourSet{kDomain, {}}, {}), HasSubstr("holds no contours"));
  const ScalarField odd(kDomain, 3.0F);
  EXPECT_THAT(message(isle(), {}, &odd), HasSubstr("[0, 1]"));
}

}  // namespace
}  // namespace seamount::contour
