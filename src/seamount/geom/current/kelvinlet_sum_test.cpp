#include "seamount/geom/current/kelvinlet_sum.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

VectorField still(const GridFrame& frame) { return {ScalarField(frame, 0.0F), ScalarField(frame, 0.0F)}; }

std::vector<Kelvinlet> random_kelvinlets(int count, const GridFrame& frame, double low_radius, double high_radius,
                                         uint64_t seed, double beyond = 0.0) {
  Rng rng(Seed{seed}.derive("kelvinlets"));
  std::vector<Kelvinlet> all;
  for (int i = 0; i < count; ++i) {
    Kelvinlet k;
    k.kind = static_cast<KelvinletKind>(i % 3);
    k.centre = {rng.uniform(frame.west_m - beyond, frame.east_m() + beyond),
                rng.uniform(frame.south_m() - beyond, frame.north_m + beyond)};
    k.radius_m = low_radius * std::pow(high_radius / low_radius, rng.uniform(0.0, 1.0));
    k.speed_m_s = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    k.poisson_ratio = rng.uniform(0.0, 0.5);
    all.push_back(k);
  }
  return all;
}

/// Largest difference between the fast and the plain sum, m/s; the strongest of the above has a speed of about 1.
double error_of(const std::vector<Kelvinlet>& kelvinlets, const GridFrame& frame) {
  VectorField fast = still(frame), plain = still(frame);
  add_kelvinlets(kelvinlets, fast, {});
  add_each_kelvinlet(kelvinlets, plain, {});
  double most = 0.0;
  for (size_t i = 0; i < fast.x.size(); ++i) {
    most = std::max(most, static_cast<double>(std::hypot(fast.x.cells()[i] - plain.x.cells()[i],
                                                         fast.y.cells()[i] - plain.y.cells()[i])));
  }
  return most;
}

TEST(KelvinletSum, IsThePlainSum) {
  const GridFrame frame = GridFrame::centred(160, 120, 10.0);
  for (const uint64_t seed : {1, 2, 3}) {
    EXPECT_LT(error_of(random_kelvinlets(400, frame, 3.0, 300.0, seed), frame), 0.01) << seed;
    EXPECT_LT(error_of(random_kelvinlets(2000, frame, 30.0, 31.0, seed), frame), 0.01) << seed;
    EXPECT_LT(error_of(random_kelvinlets(1, frame, 50.0, 51.0, seed), frame), 0.01) << seed;
    EXPECT_LT(error_of(random_kelvinlets(3, frame, 1.0, 100.0, seed), frame), 0.01) << seed;
  }
}

TEST(KelvinletSum, AllTheSameWay) {  // nothing cancels: as good against the whole
  const GridFrame frame = GridFrame::centred(200, 200, 5.0);
  std::vector<Kelvinlet> all = random_kelvinlets(3000, frame, 10.0, 60.0, 4);
  for (Kelvinlet& k : all) k.speed_m_s = {1.0, 0.3};
  VectorField current = still(frame);
  add_kelvinlets(all, current, {});
  const double whole = static_cast<double>(*std::max_element(current.x.cells().begin(), current.x.cells().end()));
  EXPECT_GT(whole, 50.0);
  EXPECT_LT(error_of(all, frame), 5e-4 * whole);
}

TEST(KelvinletSum, OddShapesAndPlacesOutside) {
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{1, 1}, {1, 50}, {70, 2}, {33, 129}}) {
    const GridFrame frame = GridFrame::centred(width, height, 10.0);
    EXPECT_LT(error_of(random_kelvinlets(60, frame, 2.0, 400.0, 5), frame), 0.01) << width << " x " << height;
    EXPECT_LT(error_of(random_kelvinlets(60, frame, 5.0, 400.0, 6, 5000.0), frame), 0.01) << width << " x " << height;
  }
  const GridFrame window = GridFrame::centred(64, 64, 0.01);
  EXPECT_LT(error_of(random_kelvinlets(60, window, 0.5, 40.0, 6, 5000.0), window), 0.01);
}

TEST(KelvinletSum, AddsToWhatFlowsAlready) {
  const GridFrame frame = GridFrame::centred(20, 20, 1.0);
  VectorField current{ScalarField(frame, 2.0F), ScalarField(frame, -1.0F)};
  const VectorField before = current;
  add_kelvinlets({}, current, {});
  EXPECT_EQ(current, before);
  const std::vector<Kelvinlet> one = {{KelvinletKind::grab, {0.5, 0.5}, 4.0, {0.5, 0.0}}};
  add_kelvinlets(one, current, {});
  EXPECT_NEAR(current.x(10, 9), 2.5F, 0.01F);
  EXPECT_NEAR(current.y(10, 9), -1.0F, 0.01F);
}

TEST(KelvinletSum, SameBitsOnAnyNumberOfThreads) {
  const GridFrame frame = GridFrame::centred(150, 90, 10.0);
  const std::vector<Kelvinlet> all = random_kelvinlets(500, frame, 3.0, 200.0, 8);
  VectorField one = still(frame), four = still(frame);
  RunContext serial, parallel;
  serial.threads = 1;
  parallel.threads = 4;
  add_kelvinlets(all, one, serial);
  add_kelvinlets(all, four, parallel);
  EXPECT_EQ(one, four);
}

TEST(KelvinletSum, NamesTheKelvinletThatIsWrong) {
  VectorField current = still(GridFrame::centred(4, 4, 1.0));
  std::vector<Kelvinlet> all(3);
  all[2].radius_m = 0.0;
  try {
    add_kelvinlets(all, current, {});
    FAIL();
  } catch (const InvalidArgument& e) {
    EXPECT_EQ(e.field(), "kelvinlets[2]");
  }
  all[2].radius_m = 1.0;
  all[1].speed_m_s.x = std::nan("");
  EXPECT_THROW(add_kelvinlets(all, current, {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
