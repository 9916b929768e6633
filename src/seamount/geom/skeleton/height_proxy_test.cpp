#include "seamount/geom/skeleton/height_proxy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/scalar/segment.h"
#include "seamount/geom/skeleton/test_fields.h"

namespace seamount::geom {
namespace {

struct Scene {
  std::vector<Skeleton> skeletons;
  std::vector<HeightEffect> effects;
};

Skeleton random_skeleton(Rng& rng, SkeletonKind kind) {
  const Vec2 at = {rng.uniform(0.0, 400.0), rng.uniform(0.0, 300.0)};
  Skeleton skeleton = {kind, {at}};
  if (kind == SkeletonKind::curve) {
    const int n = rng.integer(2, 40);
    for (int i = 1; i < n; ++i) {
      skeleton.points.push_back(skeleton.points.back() + Vec2{rng.uniform(0.0, 10.0), rng.uniform(-6.0, 6.0)});
    }
  } else if (kind == SkeletonKind::region) {
    skeleton.points.clear();
    const int n = rng.integer(3, 40);
    const double radius = rng.uniform(10.0, 80.0);
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / n;
      skeleton.points.push_back(at + radius * rng.uniform(0.6, 1.0) * Vec2{std::cos(angle), std::sin(angle)});
    }
  }
  return skeleton;
}

Scene random_scene(Seed seed, int count) {
  Rng rng(seed);
  Scene scene;
  for (int i = 0; i < count; ++i) {
    scene.skeletons.push_back(random_skeleton(rng, static_cast<SkeletonKind>(rng.integer(0, 2))));
    scene.effects.push_back({static_cast<HeightShape>(rng.integer(0, 8)), static_cast<HeightGroup>(rng.integer(0, 3)),
                             rng.uniform(-10.0, 30.0), rng.uniform(5.0, 60.0), rng.uniform(0.3, 3.0),
                             rng.chance(0.3) ? rng.uniform(0.5, 15.0) : 0.0});
  }
  return scene;
}

HeightField random_ground(Seed seed, const GridFrame& frame) {
  HeightField ground(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      ground(x, y) =
          static_cast<float>(-20.0 + 30.0 * fbm(seed, {.wavelength_m = 100.0, .octaves = 3}, frame.x(x), frame.y(y)));
    }
  }
  return ground;
}

const ProxyGround kGround = {-45.0, 3.0, 1.0};

/// Object by object and cell by cell, with every edge, in double.
double oracle(const Scene& scene, Vec2 p, double ground) {
  double grounded = ground, altitude = 0.0, blend = 0.0, weight = 0.0, surface = 0.0;
  for (size_t i = 0; i < scene.skeletons.size(); ++i) {
    const Polyline& points = scene.skeletons[i].points;
    const SkeletonKind kind = scene.skeletons[i].kind;
    const ProxyProfile profile(scene.effects[i], kind, kGround);
    double d = INFINITY;
    const bool region = kind == SkeletonKind::region;
    for (size_t k = 0; k < points.size(); ++k) {
      const bool last = k + 1 == points.size();
      if (last && !region && k > 0) continue;
      d = std::min(d, squared_distance_to_segment(p, points[k], points[(k + 1) % points.size()]));
    }
    d = std::sqrt(d);
    if (region && contains(points, p)) {
      d = scene.effects[i].shape == HeightShape::island     ? -d
          : scene.effects[i].shape == HeightShape::cylinder ? d
                                                            : 0.0;
    }
    d = profile.roughened(d, p);
    const double w = profile.weight(d);
    if (profile.is_nothing() || w <= 0.0) continue;
    const double k = 0.5 / profile.blend();
    if (profile.group() == HeightGroup::surface) {
      surface += profile.height(d);
    } else if (profile.group() != HeightGroup::altitude) {
      grounded = smax(grounded, ground + w * (profile.height(d) - ground) - (1.0 / w - 1.0) / (2.0 * k), k);
    } else {
      const double own = profile.height(d), gap = altitude - own, b = profile.blend();
      const double both = weight * w, before = weight * (1.0 - w), alone = (1.0 - weight) * w;
      const double share = 0.5 + 0.5 * gap / (std::abs(gap) + blend + b);
      const double sum = both + before + alone;
      altitude = (both * smin(altitude, own, k) + before * altitude + alone * own) / sum;
      blend = (both * ((1.0 - share) * blend + share * b) + before * blend + alone * b) / sum;
      weight = 1.0 - (1.0 - weight) * (1.0 - w);
    }
  }
  if (weight == 0.0) return grounded + surface;
  return grounded + weight * (smax(grounded, altitude, 0.5 / blend) - grounded) + surface;
}

TEST(HeightProxy, AgreesWithAskingEveryObjectAtEveryCell) {
  for (uint64_t seed = 0; seed < 6; ++seed) {
    const GridFrame frame = {133, 97, 3.0, -5.0, 290.0, {}};
    const HeightField ground = random_ground(Seed{seed}, frame);
    const Scene scene = random_scene(Seed{seed}.derive("scene"), 40);
    const HeightProxies proxies(scene.skeletons, scene.effects, kGround);
    const HeightField result = proxies.over(ground, {});
    std::vector<Vec2> places;
    std::vector<double> heights;
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        places.push_back({frame.x(x), frame.y(y)});
        heights.push_back(static_cast<double>(ground(x, y)));
        ASSERT_NEAR(result(x, y), oracle(scene, places.back(), heights.back()), 2e-4) << x << " " << y;
      }
    }
    proxies.over(places, heights, {});
    for (size_t i = 0; i < places.size(); ++i) ASSERT_EQ(static_cast<float>(heights[i]), result.cells()[i]);
    EXPECT_EQ(proxies.over(ground, RunContext{.threads = 1}), result);
  }
}

double single(const Skeleton& skeleton, const HeightEffect& effect, Vec2 p, double ground,
              ProxyGround shared = kGround) {
  double height = ground;
  HeightProxies(std::span(&skeleton, 1), std::span(&effect, 1), shared)
      .over(std::span(&p, 1), std::span(&height, 1), {});
  return height;
}

TEST(HeightProxy, OneObjectIsItsClosedForm) {
  const Skeleton point = {SkeletonKind::point, {{0.0, 0.0}}};
  const Skeleton line = {SkeletonKind::curve, {{-100.0, 0.0}, {100.0, 0.0}}};
  const Skeleton square = {SkeletonKind::region, {{-50.0, -50.0}, {50.0, -50.0}, {50.0, 50.0}, {-50.0, 50.0}}};
  const auto of = [](HeightShape shape, double height) {
    return HeightEffect{shape, HeightGroup::surface, height, 20.0, 0.5};
  };
  for (const double d : {0.0, 2.5, 5.0, 9.0, 10.0, 15.0}) {
    const double x = std::min(d / 10.0, 1.0);
    EXPECT_NEAR(single(point, of(HeightShape::cone, 4.0), {0.6 * d, 0.8 * d}, 7.0), 7.0 + 4.0 * (1.0 - x), 1e-9);
    EXPECT_NEAR(single(line, of(HeightShape::ridge, 4.0), {3.0, -d}, 7.0), 7.0 + 4.0 * (1.0 - x), 1e-9);
    EXPECT_NEAR(single(point, of(HeightShape::dome, 4.0), {d, 0.0}, 7.0), 7.0 + 4.0 * std::sqrt(1.0 - x * x), 1e-9);
    EXPECT_NEAR(single(square, of(HeightShape::cylinder, 4.0), {50.0 - d, 0.0}, 0.0), 4.0 * std::sqrt(1.0 - x * x),
                1e-9);
    EXPECT_NEAR(single(square, of(HeightShape::island, 4.0), {50.0 - d, 0.0}, 0.0), 4.0 * x * (2.0 - x), 1e-9);
    EXPECT_NEAR(single(square, of(HeightShape::plateau, 4.0), {50.0 + d, 0.0}, 0.0),
                std::min(4.0, 0.5 * (10.0 - 10.0 * x)), 1e-9);
    EXPECT_NEAR(single(line, of(HeightShape::carve, 4.0), {0.0, d}, 0.0), -std::min(4.0, 5.0 - 5.0 * x), 1e-9);
  }
  EXPECT_NEAR(single(point, of(HeightShape::bump, 3.0), {0.0, 0.0}, 1.0), 4.0, 1e-9);
  EXPECT_NEAR(single(point, of(HeightShape::bump, 3.0), {10.0 / 3.0, 0.0}, 0.0), 3.0 * std::exp(-0.5), 0.02);
  EXPECT_EQ(single(square, of(HeightShape::cone, 3.0), {10.0, 20.0}, 0.0), 3.0);
  EXPECT_EQ(single(point, of(HeightShape::none, 3.0), {0.0, 0.0}, 1.0), 1.0);
}

TEST(HeightProxy, GroupsJoinAsInThePaper) {
  const Skeleton point = {SkeletonKind::point, {{0.0, 0.0}}};
  const HeightEffect mountain = {HeightShape::cone, HeightGroup::grounded, 100.0, 200.0, 0.5};
  const HeightEffect reef = {HeightShape::plateau, HeightGroup::altitude, -2.0, 40.0, 1.0};
  const ProxyGround deep = {-50.0, 5.0, 1.0};
  // A mountain stands on z = 0 whatever lies below it, and its foot goes on down to the floor.
  EXPECT_NEAR(single(point, mountain, {30.0, 40.0}, -50.0, deep), 50.0, 1e-3);
  EXPECT_NEAR(single(point, mountain, {140.0, 0.0}, -50.0, deep), -20.0, 1e-3);
  EXPECT_EQ(single(point, mountain, {260.0, 0.0}, -50.0, deep), -50.0);
  EXPECT_NEAR(single(point, mountain, {30.0, 40.0}, 50.0, deep), 51.0, 1e-6);  // 1 / (2 k) where both are equal
  EXPECT_NEAR(single(point, mountain, {30.0, 40.0}, 200.0, deep), 200.0, 1e-3);
  // A reef keeps under the water, wherever that is.
  EXPECT_NEAR(single(point, reef, {3.0, 4.0}, -50.0, deep), 3.0, 1e-3);
  EXPECT_NEAR(single(point, reef, {30.0, 0.0}, -50.0, deep), -7.0, 1e-3);
  EXPECT_NEAR(single(point, reef, {3.0, 4.0}, -50.0, {-50.0, -7.0, 1.0}), -9.0, 1e-3);
  // Of two reefs the lower one decides.
  std::vector<Skeleton> two(2, point);
  std::vector<HeightEffect> effects = {reef, reef};
  effects[1].height_m = -12.0;
  Vec2 p = {1.0, 1.0};
  double height = -50.0;
  HeightProxies(two, effects, deep).over(std::span(&p, 1), std::span(&height, 1), {});
  EXPECT_NEAR(height, -7.0, 1e-2);
  // A small stone does not lift the ground by a metre.
  const HeightEffect stone = {HeightShape::dome, HeightGroup::grounded, 0.3, 0.6, 1.0};
  EXPECT_LT(single(point, stone, {0.0, 0.0}, 0.3, {0.0, 0.0, 1.0}), 0.34);
}

TEST(HeightProxy, NothingIsLostInASmoothMaximumAndOrderHardlyMatters) {
  for (uint64_t seed = 20; seed < 26; ++seed) {
    const GridFrame frame = {60, 50, 7.0, 0.0, 320.0, {}};
    const HeightField ground = random_ground(Seed{seed}, frame);
    Scene scene = random_scene(Seed{seed}, 30);
    for (HeightEffect& effect : scene.effects) effect.group = HeightGroup::grounded;
    const HeightField all = HeightProxies(scene.skeletons, scene.effects, kGround).over(ground, {});
    for (size_t i = 0; i < scene.skeletons.size(); i += 5) {
      const bool carve = scene.effects[i].shape == HeightShape::carve;  // surface, whatever it says
      if (carve) continue;
      const ProxyProfile profile(scene.effects[i], scene.skeletons[i].kind, kGround);
      const double end = profile.end();
      double lowest_carve = 0.0;
      for (const HeightEffect& effect : scene.effects) {
        if (effect.shape == HeightShape::carve) lowest_carve -= std::abs(effect.height_m);
      }
      const HeightProxies alone(std::span(scene.skeletons).subspan(i, 1), std::span(scene.effects).subspan(i, 1),
                                kGround);
      const HeightField one = alone.over(ground, {});
      EXPECT_GT(end, 0.0);
      for (size_t c = 0; c < one.size(); ++c) {
        ASSERT_GE(all.cells()[c], one.cells()[c] - profile.blend() + lowest_carve - 1e-3);
        ASSERT_GE(one.cells()[c], ground.cells()[c]);
      }
    }
    Scene turned = scene;
    std::reverse(turned.skeletons.begin(), turned.skeletons.end());
    std::reverse(turned.effects.begin(), turned.effects.end());
    const HeightField other = HeightProxies(turned.skeletons, turned.effects, kGround).over(ground, {});
    for (size_t c = 0; c < all.size(); ++c) ASSERT_NEAR(all.cells()[c], other.cells()[c], 1.0);
  }
}

TEST(HeightProxy, IsContinuousAcrossTheEndsOfFootprints) {
  for (uint64_t seed = 0; seed < 8; ++seed) {
    const Scene scene = random_scene(Seed{seed}.derive("lines"), 25);
    const HeightProxies proxies(scene.skeletons, scene.effects, kGround);
    Rng rng(Seed{seed}.derive("ends"));
    for (int line = 0; line < 20; ++line) {
      const Vec2 from = {rng.uniform(-100.0, 500.0), rng.uniform(-100.0, 400.0)};
      const Vec2 to = {rng.uniform(-100.0, 500.0), rng.uniform(-100.0, 400.0)};
      const auto at = [&](double t) {
        const Vec2 p = from + t * (to - from);
        double height = -30.0 + 10.0 * std::sin(0.02 * p.x);
        proxies.over(std::span(&p, 1), std::span(&height, 1), RunContext{.threads = 1});
        return height;
      };
      const int steps = 300;
      double before = at(0.0);
      for (int i = 1; i <= steps; ++i) {
        double low = (i - 1.0) / steps, high = static_cast<double>(i) / steps, a = before, b = at(high);
        before = b;
        for (int halving = 0; halving < 30 && std::abs(b - a) > 0.05; ++halving) {
          const double middle = 0.5 * (low + high), m = at(middle);
          const bool left = std::abs(m - a) > std::abs(b - m);
          (left ? high : low) = middle;
          (left ? b : a) = m;
        }
        ASSERT_LT(std::abs(b - a), 0.06) << seed << " " << from.x + low * (to.x - from.x);
      }
    }
  }
}

TEST(HeightProxy, AWindowShowsTheSameSurface) {
  const Scene scene = random_scene(Seed{77}, 30);
  const HeightProxies proxies(scene.skeletons, scene.effects, kGround);
  const HeightField coarse = proxies.over(HeightField({40, 30, 9.0, 0.0, 270.0, {}}, -30.0F), {});
  const HeightField fine = proxies.over(HeightField({90, 90, 1.0, 90.0, 180.0, {}}, -30.0F), {});
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) EXPECT_EQ(coarse(10 + x, 10 + y), fine(9 * x + 4, 9 * y + 4));
  }
}

TEST(HeightProxy, BadInput) {
  const Skeleton point = {SkeletonKind::point, {{0.0, 0.0}}};
  for (const HeightEffect& effect : {HeightEffect{HeightShape::cone, HeightGroup::surface, NAN, 1.0, 1.0},
                                     HeightEffect{HeightShape::cone, HeightGroup::surface, 1.0, 0.0, 1.0},
                                     HeightEffect{HeightShape::cone, HeightGroup::surface, 1.0, 1.0, 0.0}}) {
    EXPECT_THROW(HeightProxies(std::span(&point, 1), std::span(&effect, 1), kGround), InvalidArgument);
  }
  const HeightProxies nothing({}, {}, kGround);
  HeightField ground({3, 1, 1.0, 0.0, 0.0, {}}, 2.0F);
  ground(1, 0) = NAN;
  const HeightField same = nothing.over(ground, {});
  EXPECT_EQ(same(0, 0), 2.0F);
  EXPECT_TRUE(std::isnan(same(1, 0)));
}

}  // namespace
}  // namespace seamount::geom
