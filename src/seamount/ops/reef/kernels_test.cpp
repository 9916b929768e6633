#include "seamount/ops/reef/kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace seamount::reef {
namespace {

TEST(Kernels, NormalIsADiscWithASoftRim) {
  EXPECT_DOUBLE_EQ(normal_kernel(0.0, 10), 1.0);
  EXPECT_NEAR(normal_kernel(0.5, 10), 0.9990239, 1e-7);  // exp(-2^-10)
  EXPECT_NEAR(normal_kernel(1.0, 10), std::exp(-1.0), 1e-12);
  EXPECT_NEAR(normal_kernel(1.2, 10), 0.00205, 1e-4);
  EXPECT_NEAR(normal_kernel(normal_reach(10), 10), 1e-6, 1e-9);
}

TEST(Kernels, EdgeIsARingInsideTheRim) {
  EXPECT_NEAR(edge_kernel(0.0, 5, 10), 0.0, 1e-40);
  EXPECT_NEAR(edge_kernel(0.8, 5, 10), 1.0, 1e-12);  // 1 - 1 / k1
  EXPECT_DOUBLE_EQ(edge_kernel(1.0, 5, 10), 0.0);
  EXPECT_DOUBLE_EQ(edge_kernel(1.5, 5, 10), 0.0);
  EXPECT_NEAR(edge_kernel(0.75, 4, 7), 1.0, 1e-12);
  EXPECT_NEAR(edge_kernel(0.95, 5, 9), std::exp(-std::pow(std::log(4.0), 9)), 1e-12) << "odd exponents stay bounded";
}

/// The steps of P4 sec. 3.3 as they stand: an angle between 0 and 360 degrees, eight directions.
int direction_by_angle(Vec2 v) {
  double deg = std::atan2(v.x, v.y) * 180.0 / std::numbers::pi;
  if (deg < 0) deg += 360.0;
  return static_cast<int>(std::floor((deg + 22.5) / 45.0)) % 8;
}

TEST(Kernels, DirectionsAreEighthsOfTheCompass) {
  for (int i = 0; i < 720; ++i) {
    const double angle = (i + 0.3) * std::numbers::pi / 360.0;
    const Vec2 v{7.0 * std::sin(angle), 7.0 * std::cos(angle)};
    EXPECT_EQ(direction_of(v), direction_by_angle(v)) << i;
  }
}

std::vector<LatticeCell> some_cells() { return {{5, 5}, {6, 5}, {6, 6}, {7, 7}, {5, 4}, {10, 3}, {0, 11}, {11, 11}}; }

TEST(Kernels, ColoniesKnowTheirNeighbours) {
  const GridFrame lattice = GridFrame::centred(12, 12, 50.0);
  const std::vector<Colony> colonies = place_colonies(some_cells(), lattice, {.radius_m = 70}, Seed{1});
  EXPECT_EQ(colonies[0].neighbours, 1U << 0 | 1U << 2 | 1U << 3);  // north, east, south-east
  EXPECT_EQ(colonies[5].neighbours, 0U);
  EXPECT_DOUBLE_EQ(colonies[0].centre.x, lattice.x(5));
  EXPECT_DOUBLE_EQ(colonies[0].centre.y, lattice.y(5));
  EXPECT_DOUBLE_EQ(colonies[0].radius_m, 70);
}

TEST(Kernels, RowsAreTheSumsOfEquationsOneAndTwo) {
  const GridFrame lattice = GridFrame::centred(12, 12, 50.0);
  for (const Scatter& scatter : {Scatter{73.0, 0, 0, 5.0, 0}, Scatter{90.0, 0.4, 0.3, 5.0, 0.3}}) {
    const std::vector<Colony> colonies = place_colonies(some_cells(), lattice, scatter, Seed{2});
    const KernelSums sums(colonies, 10, 10);
    const GridFrame frame = GridFrame::centred(97, 83, 7.3);
    std::vector<float> normal(97), edge(97);
    for (int y = 0; y < frame.height; ++y) {
      sums.row(frame.x(0), frame.cell_m, frame.y(y), normal, edge);
      for (int x = 0; x < frame.width; ++x) {
        double n = 0, e = 0;
        for (const Colony& q : colonies) {
          const Vec2 v = Vec2{frame.x(x), frame.y(y)} - q.centre;
          const double t = std::sqrt(dot(v, v)) / q.radius_m;
          const bool open = (q.neighbours >> direction_by_angle(v) & 1) == 0;
          n += normal_kernel(t, 10);
          e += open ? edge_kernel(t, q.k1, 10) : 0.0;
        }
        ASSERT_NEAR(normal[static_cast<size_t>(x)], n, 2e-4) << x << " " << y;
        ASSERT_NEAR(edge[static_cast<size_t>(x)], e, 2e-3) << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace seamount::reef
