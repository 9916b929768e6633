// The law of the sea floor: land with sea around it has no hollow but in drawn basins, neither the network nor any
// raster made of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/tin/tin_border.h"
#include "seamount/geom/tin/tin_raster.h"
#include "seamount/ops/contour/convert/extract.h"
#include "seamount/ops/contour/convert/reconstruct.h"
#include "seamount/ops/contour/growth/grow.h"
#include "seamount/ops/contour/growth/test_network.h"
#include "seamount/ops/contour/heights/heights.h"

namespace seamount::contour {
namespace {

const GridFrame kDomain = GridFrame::centred(120, 100, 80);

Ring blob(double radius, Vec2 centre = {}, double wobble = 0.15, double phase = 0.0) {
  Ring ring;
  for (int i = 0; i < 120; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 120;
    const double r = radius * (1.0 + wobble * (std::sin(3.0 * a + phase) + 0.4 * std::sin(8.0 * a)));
    ring.push_back(centre + Vec2{r * std::cos(a), r * std::sin(a)});
  }
  return ring;
}

struct Scene {
  const char* name;
  std::vector<RegionOutline> outlines;
};

std::vector<Scene> scenes() {
  const RegionOutline isle = {"isle", blob(2600, {-300, 100}), 0.0, false, {}};
  const Ring hook = {{-2500, -2000}, {2500, -2000}, {2500, 2000},  {-2500, 2000},  {-2500, 300}, {-2100, 300},
                     {-2100, 1500},  {2000, 1500},  {2000, -1500}, {-2100, -1500}, {-2100, 250}, {-2500, 250}};
  return {
      {"one island", {isle}},
      {"one of unknown height", {{"isle", blob(2600, {200, 0}, 0.3), {}, false, {}}}},
      {"with a hill by the sea", {isle, {"hill", blob(500, {-2100, 0}), 500.0, false, {}}}},
      {"with lagoon and crater",
       {isle,
        {"lagoon", blob(500, {900, -800}), 0.0, true, -40.0},
        {"rim", blob(600, {-900, 500}), 400.0, false, {}},
        {"crater", blob(450, {-900, 500}), 400.5, true, 200.0}}},
      {"three islands around a hollow",
       {{"a", blob(1200, {-1800, -1300}), 0.0, false, {}},
        {"b", blob(1300, {1700, -1200}), 0.0, false, {}},
        {"c", blob(1250, {0, 1900}), 0.0, false, {}}}},
      {"of different heights",
       {{"a", blob(1200, {-1500, 0}), 0.0, false, {}}, {"b", blob(1100, {1500, 0}), 120.0, false, {}}}},
      {"a shelf around the coast", {{"shelf", blob(3000), -200.0, false, {}}, {"coast", blob(2000), 0.0, false, {}}}},
      {"over the edge", {{"isle", blob(3500, {-3500, 1500}), 0.0, false, {}}}},
      {"half of the domain",
       {{"land", {{-9000, -9000}, {500, -9000}, {-400, 0}, {500, 9000}, {-9000, 9000}}, 0.0, false, {}}}},
      {"a bay with a narrow mouth", {{"hook", hook, 0.0, false, {}}}}};
}

Tin network(const Scene& scene, int particles, uint64_t seed) {
  GrowParams params;
  params.particles = particles;
  const Tin tin =
      grow(regions_from_outlines(scene.outlines, kDomain, "outlines"), kDomain, nullptr, {}, params, Seed{seed}, {});
  return heights(tin, nullptr, {.max_m = 900.0}, {});
}

/// Where water would stand, and how deep: from the border inwards, each cell at least as high as where its water goes.
HeightField hollows(const HeightField& ground) {
  using Open = std::pair<float, int64_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  HeightField level(ground.frame(), NAN);
  const int w = ground.width(), h = ground.height();
  const auto enter = [&](int x, int y, float least) {
    if (x < 0 || y < 0 || x >= w || y >= h || !std::isnan(level(x, y))) return;
    level(x, y) = std::max(ground(x, y), least);
    open.emplace(level(x, y), static_cast<int64_t>(y) * w + x);
  };
  for (int x = 0; x < w; ++x) enter(x, 0, -1e9F), enter(x, h - 1, -1e9F);
  for (int y = 0; y < h; ++y) enter(0, y, -1e9F), enter(w - 1, y, -1e9F);
  while (!open.empty()) {
    const auto [z, cell] = open.top();
    open.pop();
    const auto x = static_cast<int>(cell % w), y = static_cast<int>(cell / w);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) enter(x + dx, y + dy, z);
    }
  }
  for (size_t i = 0; i < level.size(); ++i) level.cells()[i] -= ground.cells()[i];
  return level;
}

bool in_basin(const Scene& scene, Vec2 p) {
  return std::any_of(scene.outlines.begin(), scene.outlines.end(), [&](const RegionOutline& outline) {
    const geom::Box box = geom::bounding_box(outline.ring);  // with a margin for cells that cross the outline
    constexpr double kMargin = 160.0;
    return outline.basin && p.x > box.low.x - kMargin && p.x < box.high.x + kMargin && p.y > box.low.y - kMargin &&
           p.y < box.high.y + kMargin;
  });
}

void expect_no_hollows(const HeightField& ground, const Scene& scene, const std::string& what) {
  const HeightField depth = hollows(ground);
  float deepest = 0.0F;
  Vec2 where;
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      const Vec2 p = {depth.frame().x(x), depth.frame().y(y)};
      if (depth(x, y) <= deepest || in_basin(scene, p)) continue;
      deepest = depth(x, y);
      where = p;
    }
  }
  EXPECT_LE(deepest, 0.0F) << scene.name << ", " << what << " at (" << where.x << ", " << where.y << ")";
}

TEST(GroundOutside, NothingIsLowerThanItsWayToTheEdge) {
  for (const Scene& scene : scenes()) {
    for (const int particles : {300, 2000, 6000}) {
      for (uint64_t seed = 1; seed <= 4; ++seed) {
        const Tin tin = network(scene, particles, seed);
        const std::string what = std::to_string(particles) + " particles, seed " + std::to_string(seed);
        EXPECT_EQ(geom::border_rings(tin).size(), 1U) << scene.name << ", " << what << ": a hole in the network";
        for (const int32_t low : geom::find_low_nodes(tin)) {
          const int32_t region = tin.region[at(low)];
          EXPECT_TRUE(region >= 0 && tin.regions[at(region)].basin)
              << scene.name << ", " << what << " at (" << tin.nodes[at(low)].x << ", " << tin.nodes[at(low)].y << ")";
        }
      }
    }
  }
}

TEST(GroundOutside, NoRasterHasAHollow) {
  for (const Scene& scene : scenes()) {
    for (const int particles : {600, 4000}) {
      const uint64_t seed = particles == 600 ? 11 : 12;
      const Tin tin = network(scene, particles, seed);
      const std::string what = std::to_string(particles) + " particles, ";
      expect_no_hollows(reconstruct(tin, {}, {}), scene, what + "the network");
      const ContourSet set = extract(tin, {.interval_m = 40.0}, {});
      for (const Method method : {Method::smooth, Method::interpolated}) {
        expect_no_hollows(reconstruct(set, {.method = method}, {}), scene,
                          what + std::string(Choices<Method>::names[static_cast<size_t>(method)]));
      }
    }
  }
}

TEST(GroundOutside, CoversTheDomainAndLiesBelowTheCoast) {
  for (const Scene& scene : scenes()) {
    const Tin tin = network(scene, 1500, 5);
    const HeightField ground = geom::rasterise_tin(tin, kDomain, {});
    double highest = -1e9;
    for (const RegionOutline& outline : scene.outlines) highest = std::max(highest, outline.height_m.value_or(0.0));
    for (size_t i = 0; i < tin.nodes.size(); ++i) {
      if (tin.region[i] < 0) {
        EXPECT_LT(tin.height_m[i], highest) << scene.name;
      }
    }
    for (const Vec2 corner : {Vec2{-4700, -3900}, Vec2{4700, -3900}, Vec2{4700, 3900}, Vec2{-4700, 3900}}) {
      bool near = false;
      for (const Vec2 p : tin.nodes) near = near || std::hypot(p.x - corner.x, p.y - corner.y) < 1000;
      EXPECT_TRUE(near) << scene.name;
    }
  }
}

/// The median of the slopes (degrees) of the ground between two depths.
double slope_between(const HeightField& ground, float low, float high) {
  std::vector<double> slopes;
  const double cell = ground.frame().cell_m;
  for (int y = 1; y + 1 < ground.height(); ++y) {
    for (int x = 1; x + 1 < ground.width(); ++x) {
      if (ground(x, y) < low || ground(x, y) > high) continue;
      const double dx = static_cast<double>(ground(x + 1, y) - ground(x - 1, y)) / (2 * cell);
      const double dy = static_cast<double>(ground(x, y + 1) - ground(x, y - 1)) / (2 * cell);
      slopes.push_back(std::atan(std::hypot(dx, dy)) * 180 / std::numbers::pi);
    }
  }
  EXPECT_GT(slopes.size(), 100U);
  std::nth_element(slopes.begin(), slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2), slopes.end());
  return slopes[slopes.size() / 2];
}

TEST(GroundOutside, FallsAsFlanksOfIslandsDo) {
  const GridFrame sea = GridFrame::centred(200, 200, 400);
  GrowParams params;
  params.particles = 3000;
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const RegionTree tree = regions_from_outlines({{"isle", blob(12000), 0.0, false, {}}}, sea, "outlines");
    const Tin tin = heights(grow(tree, sea, nullptr, {}, params, Seed{seed}, {}), nullptr, {.max_m = 2500.0}, {});
    const HeightField ground = reconstruct(tin, {}, {});
    const double upper = slope_between(ground, -1200, -300), lower = slope_between(ground, -4200, -2200);
    EXPECT_GT(upper, 9.0) << seed;
    EXPECT_LT(upper, 20.0) << seed;
    EXPECT_GT(lower, 3.0) << seed;
    EXPECT_LT(lower, 8.0) << seed;
  }
}

}  // namespace
}  // namespace seamount::contour
