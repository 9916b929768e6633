// The maps of the plane behind warp, slope and fractalize: laws that make contours keep their order.
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/ops/contour/move/drag.h"
#include "seamount/ops/contour/move/roughen.h"
#include "seamount/ops/contour/move/squeeze.h"

namespace seamount::contour {
namespace {

Polyline random_stroke(Rng& rng, int points) {
  Polyline stroke;
  for (int i = 0; i < points; ++i) stroke.push_back({rng.uniform(-3000, 3000), rng.uniform(-3000, 3000)});
  return stroke;
}

/// Least Jacobian determinant over a lattice, by differences.
template <class Map>
double min_jacobian(const Map& map) {
  double least = 1.0;
  constexpr double h = 1e-4;
  for (double y = -4500; y <= 4500; y += 187.3) {
    for (double x = -4500; x <= 4500; x += 181.1) {
      const Vec2 dx = (0.5 / h) * (map({x + h, y}) - map({x - h, y}));
      const Vec2 dy = (0.5 / h) * (map({x, y + h}) - map({x, y - h}));
      least = std::min(least, cross(dx, dy));
    }
  }
  return least;
}

TEST(Drag, CarriesEachCentreToTheNext) {
  Rng rng(Seed{1});
  for (int k = 1; k <= 4; ++k) {
    const Drag drag(random_stroke(rng, 4), 400, 0.9 * longest_segment(400, k), Displacement(k));
    ASSERT_GT(drag.steps().size(), 3U);
    for (size_t i = 0; i + 1 < drag.steps().size(); ++i) {
      const DragStep& step = drag.steps()[i];
      const Drag one({step.centre, drag.steps()[i + 1].centre}, 400, 1e9, Displacement(k));
      const Vec2 there = one.moved(1.0, step.centre);
      EXPECT_NEAR(there.x, drag.steps()[i + 1].centre.x, 1e-9);
      EXPECT_NEAR(there.y, drag.steps()[i + 1].centre.y, 1e-9);
    }
  }
}

TEST(Drag, CarriesTheBeginningOfAStrokeToItsEnd) {
  const Polyline stroke = {{-2000, -500}, {-300, 800}, {900, -200}, {2200, 300}};
  for (int k = 1; k <= 3; ++k) {
    const Drag drag(stroke, 500, 0.5 * longest_segment(500, k), Displacement(k));
    const Vec2 end = drag.moved(1.0, stroke.front());
    EXPECT_NEAR(end.x, stroke.back().x, 1e-6);
    EXPECT_NEAR(end.y, stroke.back().y, 1e-6);
  }
}

/// Least Jacobian determinant of a drag along the ways of lattice points: that of p + g(p) d is 1 + dg / dd, and those
/// of the steps multiply.
double min_jacobian_on_the_way(const Drag& drag, int k) {
  constexpr double h = 1e-3;
  std::vector<Drag> steps;
  for (const DragStep& s : drag.steps())
    steps.emplace_back(Polyline{s.centre, s.centre + s.step_m * s.direction}, drag.radius_m(), 1e9, Displacement(k));
  double least = 1.0;
  for (double y = -4500; y <= 4500; y += 193.7) {
    for (double x = -4500; x <= 4500; x += 191.3) {
      Vec2 p = {x, y};
      for (size_t i = 0; i < steps.size(); ++i) {
        const Vec2 d = drag.steps()[i].direction;
        const Vec2 ahead = steps[i].moved(1.0, p + h * d);
        const Vec2 behind = steps[i].moved(1.0, p - h * d);
        least = std::min(least, dot(ahead - behind, d) / (2 * h));
        p = steps[i].moved(1.0, p);
      }
    }
  }
  return least;
}

TEST(Drag, IsOneToOneUpToTheBoundOnRandomStrokes) {
  Rng rng(Seed{2});
  double least = 1.0;
  for (int trial = 0; trial < 24; ++trial) {
    const int k = 1 + trial % 4;
    const double radius = rng.uniform(200, 900);
    const Drag drag(random_stroke(rng, 2 + trial % 4), radius, longest_segment(radius, k), Displacement(k));
    least = std::min(least, min_jacobian_on_the_way(drag, k));
  }
  EXPECT_GE(least, -1e-9);
  EXPECT_LT(least, 0.1);  // the bound is met, not merely kept far from
}

TEST(Drag, HasAPositiveJacobianAsAWhole) {
  Rng rng(Seed{4});
  for (int trial = 0; trial < 8; ++trial) {
    const double radius = rng.uniform(400, 1200);
    const Drag drag(random_stroke(rng, 2 + trial % 4), radius, 0.5 * longest_segment(radius, 2), Displacement(2));
    EXPECT_GT(min_jacobian([&](Vec2 p) { return drag.moved(1.0, p); }), -1e-6) << trial;
  }
}

TEST(Drag, FoldsSpaceBeyondTheBound) {
  const Drag drag({{-100, 0}, {100, 0}}, 100, 2.0 * longest_segment(100, 1), Displacement(1));
  double least = 1.0;
  for (double x = -250; x < 250; x += 1.0)
    least = std::min(least, drag.moved(1, {x + 0.5, 0}).x - drag.moved(1, {x, 0}).x);
  EXPECT_LT(least, -1e-3);
}

TEST(Drag, MovesNothingOutsideItsReachAndBlocksAgreeWithPlaces) {
  Rng rng(Seed{3});
  const Drag drag(random_stroke(rng, 4), 500, 150, Displacement(2));
  Polyline places;
  for (int i = 0; i < 3000; ++i) places.push_back({rng.uniform(-6000, 6000), rng.uniform(-6000, 6000)});
  Polyline moved = places;
  drag.move(0.8, moved, {});
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(moved[i], drag.moved(0.8, places[i]));
    if (!drag.touches({places[i], places[i]})) {
      EXPECT_EQ(moved[i], places[i]);
    }
  }
}

TEST(Squeeze, IsThePapersForKOne) {
  const Squeeze squeeze({{0, 0}}, 100, 1);
  for (const double u : {0.1, 0.25, 0.5, 0.8}) EXPECT_NEAR(squeeze.share(u), u * (1 - u), 1e-12);
}

TEST(Squeeze, KeepsTheOrderAlongEveryRayAtFullStrength) {
  for (int k = 1; k <= 6; ++k) {
    const Squeeze squeeze({{0, 0}}, 100, k);
    for (const double strength : {-1.0, 1.0}) {
      double before = 0.0;
      for (double x = 0.25; x < 130; x += 0.25) {
        Polyline place = {{x, 0}};
        squeeze.move(strength, place, {});
        EXPECT_GE(place[0].x, before) << k << " at " << x;
        before = place[0].x;
      }
    }
  }
}

TEST(Squeeze, IsOneToOneAlongAStraightCurve) {
  const Squeeze squeeze({{-2000, -700}, {1800, 900}}, 600, 2);
  for (const double strength : {-0.95, 0.95}) {
    EXPECT_GT(min_jacobian([&](Vec2 p) {
                Polyline place = {p};
                squeeze.move(strength, place, {});
                return place[0];
              }),
              0.0);
  }
}

TEST(Roughen, IsOneToOneAndFadesWithItsWeight) {
  const GridFrame frame = GridFrame::centred(90, 90, 100);
  ScalarField weight(frame, 0.0F);
  for (int y = 1; y < 89; ++y)
    for (int x = 1; x < 89; ++x)
      weight(x, y) = std::min(1.0F, 0.1F * static_cast<float>(std::min({x, y, 89 - x, 89 - y})));
  for (uint64_t seed = 0; seed < 3; ++seed) {
    const Roughen roughen({300, 800, 5, 0.5}, weight, 0.001, Seed{seed});
    const auto map = [&](Vec2 p) {
      Polyline place = {p};
      roughen.move(1.0, place, {});
      return place[0];
    };
    EXPECT_GT(min_jacobian(map), 0.0) << seed;
    const Vec2 outside = {4600, 10};
    EXPECT_EQ(map(outside), outside);
    const Vec2 off = map({10, 20}) - Vec2{10, 20};
    EXPECT_GT(std::hypot(off.x, off.y), 1.0);
  }
}

}  // namespace
}  // namespace seamount::contour
