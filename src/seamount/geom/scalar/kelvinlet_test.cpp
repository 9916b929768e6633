#include "seamount/geom/scalar/kelvinlet.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace seamount::geom {
namespace {

TEST(Kelvinlet, ClosedFormsHaveTheirHandValues) {
  // shear modulus 1 / (4 pi): a = 1; Poisson ratio 0.5: b = 0.5; at 0.25: b = 1/3.
  const double mu = 1.0 / (4.0 * std::numbers::pi);
  const ElasticMedium hard = ElasticMedium::of(mu, 0.5), soft = ElasticMedium::of(mu, 0.25);
  EXPECT_NEAR(hard.a, 1.0, 1e-15);
  EXPECT_NEAR(hard.b, 0.5, 1e-15);
  EXPECT_NEAR(soft.b, 1.0 / 3.0, 1e-15);
  // r = (3, 0), eps = 4: r_eps = 5; 1/125 + 24 / 3125 = 0.01568.
  EXPECT_NEAR(kelvinlet_falloff(9.0, 4.0), 0.01568, 1e-15);
  EXPECT_NEAR(scale_kelvinlet({3, 0}, 4.0, soft, 2.0).x, (2.0 / 3.0 - 1.0) * 0.01568 * 6.0, 1e-15);
  EXPECT_EQ(scale_kelvinlet({3, 0}, 4.0, hard, 2.0).x, 0.0);  // what cannot be compressed has no scale
  EXPECT_NEAR(twist_kelvinlet({3, 0}, 4.0, soft, 2.0).y, -0.01568 * 6.0, 1e-15);
  // grab: (a - b) / 5 + 16 a / 250 across, and 9 b / 125 more along r.
  EXPECT_NEAR(grab_kelvinlet({3, 0}, 4.0, soft, {0, 1}).y, (2.0 / 3.0) / 5.0 + 0.064, 1e-15);
  EXPECT_NEAR(grab_kelvinlet({3, 0}, 4.0, soft, {1, 0}).x, (2.0 / 3.0) / 5.0 + 0.064 + 9.0 / 375.0, 1e-15);
}

TEST(Kelvinlet, ScaleWithoutThePrintedMistakeIsAGradient) {
  // The right scale Kelvinlet is the divergence of grabs along the axes, the printed one (1/r^3 + 1/(2 r^5)) is not:
  // here div over three axes by differences.
  const ElasticMedium medium = ElasticMedium::of(0.3, 0.2);
  const double eps = 2.0, h = 1e-4;
  const auto grab_from = [&](double ox, double oy, double oz, int axis) {  // u_x at (1.5, -0.7, 0) from a grab at o
    const double x = 1.5 - ox, y = -0.7 - oy, z = -oz;
    const double inverse = 1.0 / std::sqrt(x * x + y * y + z * z + eps * eps), cube = inverse * inverse * inverse;
    const double along[3] = {x, y, z};
    return (axis == 0 ? (medium.a - medium.b) * inverse + 0.5 * medium.a * eps * eps * cube : 0.0) +
           medium.b * cube * x * along[axis];
  };
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double o[3] = {axis == 0 ? h : 0.0, axis == 1 ? h : 0.0, axis == 2 ? h : 0.0};
    sum += (grab_from(-o[0], -o[1], -o[2], axis) - grab_from(o[0], o[1], o[2], axis)) / (2 * h);
  }
  EXPECT_NEAR(scale_kelvinlet({1.5, -0.7}, eps, medium, 1.0).x, sum, 1e-6 * std::abs(sum));
}

TEST(Kelvinlet, NormalisedStrengthsAreSpeeds) {
  for (const double eps : {0.3, 7.0, 400.0}) {
    const Kelvinlet grab{KelvinletKind::grab, {5, 6}, eps, {1.5, -0.5}, 0.3};
    EXPECT_NEAR(flow_of(grab, {5, 6}).x, 1.5, 1e-12);
    EXPECT_NEAR(flow_of(grab, {5, 6}).y, -0.5, 1e-12);
    for (const KelvinletKind kind : {KelvinletKind::scale, KelvinletKind::twist}) {
      const Kelvinlet round{kind, {5, 6}, eps, {2.0, 0}, 0.5};
      double most = 0.0, at = 0.0;
      for (double r = 0.0; r < 5 * eps; r += 0.001 * eps) {
        const Vec2 v = flow_of(round, {5 + r, 6});
        if (std::hypot(v.x, v.y) > most) most = std::hypot(v.x, v.y), at = r / eps;
      }
      EXPECT_NEAR(most, 2.0, 2e-5);
      EXPECT_NEAR(at, 0.5715, 1e-3);
    }
    EXPECT_GT(flow_of({KelvinletKind::scale, {0, 0}, eps, {1, 0}}, {eps, 0}).x, 0.0);  // outwards
    EXPECT_GT(flow_of({KelvinletKind::twist, {0, 0}, eps, {1, 0}}, {eps, 0}).y, 0.0);  // counter-clockwise
  }
}

}  // namespace
}  // namespace seamount::geom
