#include "seamount/geom/skeleton/skeleton_index.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/base/rng.h"
#include "seamount/geom/scalar/segment.h"

namespace seamount::geom {
namespace {

struct Mix {
  std::vector<Skeleton> skeletons;
  std::vector<int32_t> owners;
};

/// A star-shaped outline, wiggly.
Polyline outline(Rng& rng, Vec2 middle, double radius, int points) {
  Polyline ring;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / points;
    ring.push_back(middle + radius * rng.uniform(0.5, 1.0) * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

Mix random_mix(Seed seed, int points, int curves, int regions, double clustering) {
  Rng rng(seed);
  Mix mix;
  const auto place = [&] {
    const double scale = rng.chance(clustering) ? 1e-3 : 1.0;
    return Vec2{scale * rng.uniform(0.0, 1000.0), scale * rng.uniform(0.0, 1000.0)};
  };
  for (int i = 0; i < points; ++i) mix.skeletons.push_back({SkeletonKind::point, {place()}});
  for (int i = 0; i < curves; ++i) {
    Polyline line = {place()};
    const int n = rng.integer(2, 40);
    for (int k = 1; k < n; ++k) line.push_back(line.back() + Vec2{rng.uniform(-20.0, 30.0), rng.uniform(-20.0, 20.0)});
    mix.skeletons.push_back({SkeletonKind::curve, line});
  }
  for (int i = 0; i < regions; ++i) {
    mix.skeletons.push_back({SkeletonKind::region, outline(rng, place(), rng.uniform(5.0, 200.0), rng.integer(3, 90))});
  }
  for (size_t i = 0; i < mix.skeletons.size(); ++i) mix.owners.push_back(rng.integer(0, static_cast<int>(i)) / 2);
  return mix;
}

/// Every edge of every skeleton, one after the other.
NearestSkeleton oracle(const Mix& mix, Vec2 p, int32_t excluded) {
  NearestSkeleton best;
  for (size_t s = 0; s < mix.skeletons.size(); ++s) {
    const Skeleton& skeleton = mix.skeletons[s];
    const Polyline& points = skeleton.points;
    if (mix.owners[s] == excluded || points.empty()) continue;
    const bool region = skeleton.kind == SkeletonKind::region;
    if (region && points.size() > 2 && contains(points, p)) best.inside = true;
    const size_t edges = points.size() == 1 ? 1 : points.size() - (region ? 0 : 1);
    for (size_t i = 0; i < edges; ++i) {
      const Vec2 at = nearest_on_segment(p, points[i], points[(i + 1) % points.size()]);
      const Vec2 off = p - at;
      const double distance = std::sqrt(dot(off, off));
      if (distance >= best.distance) continue;
      best.distance = distance;
      best.at = at;
      best.owner = mix.owners[s];
      const bool within = region && points.size() > 2 && contains(points, p);
      best.normal = ((within ? -1.0 : 1.0) / distance) * off;
    }
  }
  return best;
}

void expect_same(const NearestSkeleton& a, const NearestSkeleton& b) {
  if (std::isinf(b.distance)) {
    ASSERT_TRUE(std::isinf(a.distance));
    ASSERT_EQ(a.owner, NearestSkeleton::kNobody);
    return;
  }
  ASSERT_NEAR(a.distance, b.distance, 1e-9 * (1.0 + b.distance));
  ASSERT_EQ(a.inside, b.inside);
  if (std::abs(a.at.x - b.at.x) + std::abs(a.at.y - b.at.y) > 1e-6) return;  // as near, elsewhere
  ASSERT_EQ(a.owner, b.owner);
  if (b.distance < 1e-3) return;
  ASSERT_NEAR(a.normal.x, b.normal.x, 1e-6);
  ASSERT_NEAR(a.normal.y, b.normal.y, 1e-6);
}

TEST(SkeletonIndex, AnswersAsLookingAtEveryEdgeDoes) {
  struct Case {
    int points, curves, regions;
    double clustering;
  };
  const Case cases[] = {{700, 0, 0, 0.0}, {0, 60, 0, 0.0}, {0, 0, 25, 0.0}, {300, 30, 15, 0.0}, {400, 20, 10, 0.9}};
  for (uint64_t seed = 0; seed < 5; ++seed) {
    const Case& c = cases[seed];
    const Mix mix = random_mix(Seed{seed}, c.points, c.curves, c.regions, c.clustering);
    const SkeletonIndex index(mix.skeletons, mix.owners);
    Rng rng(Seed{seed}.derive("queries"));
    std::vector<Vec2> places;
    std::vector<int32_t> excluded;
    for (int i = 0; i < 4000; ++i) {
      const double scale = rng.chance(0.3) ? 1e-3 : 1.0;
      places.push_back({scale * rng.uniform(-200.0, 1200.0), scale * rng.uniform(-200.0, 1200.0)});
      excluded.push_back(
          rng.chance(0.5) ? NearestSkeleton::kNobody
                          : mix.owners[static_cast<size_t>(rng.integer(0, static_cast<int>(mix.owners.size()) - 1))]);
    }
    std::vector<NearestSkeleton> nearest(places.size());
    std::vector<double> distances(places.size());
    std::vector<uint8_t> inside(places.size()), within(places.size());
    index.nearest(places, excluded, nearest, {});
    index.distances(places, excluded, distances, {});
    index.inside(places, excluded, inside, {});
    index.any_within(places, excluded, 25.0, within, {});
    for (size_t i = 0; i < places.size(); ++i) {
      ASSERT_NO_FATAL_FAILURE(expect_same(nearest[i], oracle(mix, places[i], excluded[i])));
      ASSERT_EQ(distances[i], nearest[i].distance);
      ASSERT_EQ(inside[i] != 0, nearest[i].inside);
      ASSERT_EQ(within[i] != 0, distances[i] <= 25.0);
    }
    std::vector<NearestSkeleton> one_thread(places.size());
    index.nearest(places, excluded, one_thread, RunContext{.threads = 1});
    EXPECT_EQ(one_thread, nearest);
  }
}

TEST(SkeletonIndex, NothingIsInfinitelyFar) {
  for (const SkeletonIndex& index : {SkeletonIndex(), SkeletonIndex({}, {})}) {
    EXPECT_TRUE(index.empty());
    const NearestSkeleton none = index.nearest({3.0, 4.0});
    EXPECT_TRUE(std::isinf(none.distance));
    EXPECT_FALSE(none.inside);
    EXPECT_EQ(none.owner, NearestSkeleton::kNobody);
  }
  const std::vector<Skeleton> alone = {{SkeletonKind::point, {{1.0, 1.0}}}};
  const SkeletonIndex index(alone, std::vector<int32_t>{7});
  EXPECT_TRUE(std::isinf(index.nearest({1.0, 1.0}, 7).distance));
  EXPECT_EQ(index.nearest({1.0, 1.0}, 6).distance, 0.0);
}

TEST(SkeletonIndex, DegenerateSkeletonsAreWhatTheyLookLike) {
  const std::vector<Skeleton> odd = {{SkeletonKind::curve, {}},
                                     {SkeletonKind::curve, {{10.0, 0.0}}},
                                     {SkeletonKind::curve, {{0.0, 5.0}, {0.0, 5.0}, {0.0, 5.0}}},
                                     {SkeletonKind::region, {{-5.0, 0.0}}},
                                     {SkeletonKind::region, {{0.0, -5.0}, {1.0, -5.0}}},
                                     {SkeletonKind::region, {{20.0, 20.0}, {21.0, 21.0}, {22.0, 22.0}}}};
  const SkeletonIndex index(odd, std::vector<int32_t>{0, 1, 2, 3, 4, 5});
  EXPECT_EQ(index.nearest({9.0, 0.0}).owner, 1);
  EXPECT_EQ(index.nearest({0.0, 4.0}).owner, 2);
  EXPECT_EQ(index.nearest({-4.0, 0.0}).owner, 3);
  EXPECT_EQ(index.nearest({0.5, -4.0}).owner, 4);
  EXPECT_NEAR(index.nearest({21.5, 20.5}).distance, std::sqrt(0.5), 1e-12);
  EXPECT_FALSE(index.inside({21.0, 21.0}));
}

TEST(SkeletonIndex, OfSeveralInOnePlaceTheFirstAnswers) {
  std::vector<Skeleton> same(5000, Skeleton{SkeletonKind::point, {{2.0, 3.0}}});
  std::vector<int32_t> owners(same.size());
  for (size_t i = 0; i < owners.size(); ++i) owners[i] = static_cast<int32_t>(i);
  const SkeletonIndex index(same, owners);
  EXPECT_EQ(index.nearest({0.0, 0.0}).owner, 0);
  EXPECT_EQ(index.nearest({0.0, 0.0}, 0).owner, 1);
}

TEST(SkeletonIndex, CurvatureAndNormalOfACircle) {
  const double radius = 50.0;
  Polyline ring;
  for (int i = 0; i < 200; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 200.0;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const std::vector<Skeleton> circle = {{SkeletonKind::region, ring}};
  const SkeletonIndex index(circle, std::vector<int32_t>{0});
  for (const double distance : {10.0, 49.0, 50.0, 51.0, 300.0}) {
    for (int i = 0; i < 17; ++i) {
      const Vec2 out = {std::cos(i * 0.37), std::sin(i * 0.37)};
      const NearestSkeleton found = index.nearest(distance * out);
      EXPECT_NEAR(found.curvature, 1.0 / radius, 1e-4);
      EXPECT_NEAR(found.distance, std::abs(distance - radius), 0.01);
      EXPECT_EQ(found.inside, distance < 49.9 || (distance < 50.1 && found.inside));
      EXPECT_GT(dot(found.normal, out), distance == 50.0 ? -2.0 : 0.999);
    }
  }
  // On the outline itself the normal still points outwards.
  EXPECT_GT(dot(index.nearest(0.5 * (ring[0] + ring[1])).normal, Vec2{1.0, 0.0}), 0.999);
  // A curve that turns to its right bends negatively.
  const std::vector<Skeleton> arc = {{SkeletonKind::curve, {ring.rbegin(), ring.rbegin() + 50}}};
  EXPECT_NEAR(SkeletonIndex(arc, std::vector<int32_t>{0}).nearest({10.0, -10.0}).curvature, -1.0 / radius, 1e-4);
}

TEST(SkeletonIndex, AnswersForPlacesThatLieTogetherAsForEachAlone) {
  for (const uint64_t seed : {1, 2, 3}) {
    Rng rng(Seed{seed});
    std::vector<Skeleton> skeletons;
    std::vector<int32_t> owners;
    for (int i = 0; i < 300; ++i) {  // on a raster, so that several are often equally near; owners of two each
      const Vec2 p{4.0 * static_cast<double>(rng.integer(0, 24)), 4.0 * static_cast<double>(rng.integer(0, 24))};
      skeletons.push_back({SkeletonKind::point, {p}});
      owners.push_back(i / 2);
    }
    const SkeletonIndex index(skeletons, owners);
    std::vector<Vec2> places;
    std::vector<int32_t> excluded;
    for (int i = 0; i < 400; ++i) {
      const size_t k = static_cast<size_t>(rng.integer(0, 299));
      const double reach = std::pow(10.0, rng.uniform(-6.0, 1.0));
      const Vec2 at =
          rng.uniform() < 0.5 ? skeletons[k].points[0] : Vec2{rng.uniform(-5.0, 105.0), rng.uniform(-5.0, 105.0)};
      for (const Vec2 step : {Vec2{0, 0}, {-reach, 0}, {reach, 0}, {0, -reach}, {0, reach}}) {
        places.push_back(at + step);
        excluded.push_back(i % 3 == 0 ? NearestSkeleton::kNobody : owners[k]);
      }
    }
    std::vector<NearestSkeleton> together(places.size());
    index.nearest(places, excluded, together, {});
    std::vector<double> distances(places.size());
    index.distances(places, excluded, distances, {});
    for (size_t i = 0; i < places.size(); ++i) {
      ASSERT_EQ(together[i], index.nearest(places[i], excluded[i])) << i;
      ASSERT_EQ(distances[i], together[i].distance);
    }
  }
}

}  // namespace
}  // namespace seamount::geom
