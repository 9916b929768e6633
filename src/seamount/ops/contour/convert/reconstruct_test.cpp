#include "seamount/ops/contour/convert/reconstruct.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/base/rng.h"
#include "seamount/geom/contour/faces.h"
#include "seamount/geom/contour/interpolation.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/tin/test_tin.h"
#include "seamount/ops/contour/convert/extract.h"

namespace seamount::contour {
namespace {

using ::testing::HasSubstr;

constexpr std::array kDrained = {Method::smooth, Method::interpolated};

Ring circle(Vec2 centre, double radius, bool hill = true) {
  Ring ring;
  for (int i = 0; i < 90; ++i) {
    const double a = (hill ? 2.0 : -2.0) * std::numbers::pi * i / 90;
    ring.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)});
  }
  return ring;
}

ContourSet nested(const GridFrame& frame, std::vector<Contour> contours) {
  geom::nest_contours(contours);
  geom::orient_contours(contours);
  return {frame, std::move(contours)};
}

/// A cone of 100 m with contours every 10 m, radius 10 m to 90 m.
ContourSet cone_contours(double cell_m = 2.0) {
  const int size = static_cast<int>(240 / cell_m);
  std::vector<Contour> contours;
  for (int k = 1; k <= 9; ++k) contours.push_back({10.0 * k, circle({1, 2}, 100.0 - 10.0 * k), -1});
  return nested(GridFrame::centred(size, size, cell_m), std::move(contours));
}

/// Hills, ridges and valleys that drain to the frame's edge, with all their contours.
ContourSet landscape(uint64_t seed, int size, double interval) {
  HeightField field(GridFrame::centred(size, size, 10.0));
  Rng rng(Seed{seed});
  std::vector<std::array<double, 4>> waves;
  for (int i = 0; i < 12; ++i)
    waves.push_back({rng.uniform(-0.02, 0.02), rng.uniform(-0.02, 0.02), rng.uniform(0, 6), rng.uniform(5, 25)});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Vec2 p{field.frame().x(x), field.frame().y(y)};
      double z = 300 - 0.25 * std::hypot(p.x, p.y);
      for (const auto& w : waves) z += w[3] * std::sin(w[0] * p.x + w[1] * p.y + w[2]);
      field(x, y) = static_cast<float>(z);
    }
  }
  ExtractParams params;
  params.interval_m = interval;
  return extract(field, params, {});
}

bool has_lower_neighbour(const HeightField& z, int x, int y) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (z.contains(x + dx, y + dy) && z(x + dx, y + dy) < z(x, y)) return true;
  return false;
}

/// Every cell within the border has a lower neighbour, but for at most one in each basin that holds no other.
void expect_drained(const HeightField& z, const ContourSet& set) {
  const geom::ContourFaces faces(set.contours);
  const Grid<int32_t> face = geom::rasterise_faces(set.contours, z.frame(), {});
  std::vector<int> sinks(static_cast<size_t>(faces.count()), 0);
  for (int y = 1; y + 1 < z.height(); ++y) {
    for (int x = 1; x + 1 < z.width(); ++x) {
      if (has_lower_neighbour(z, x, y)) continue;
      EXPECT_TRUE(faces.holds_water(face(x, y))) << x << " " << y;
      EXPECT_LE(++sinks[static_cast<size_t>(face(x, y))], 1) << x << " " << y;
    }
  }
}

/// Distance to the nearest of some rings, by trying all.
double distance_to(const std::vector<const Ring*>& rings, Vec2 p) {
  double best = std::numeric_limits<double>::infinity();
  for (const Ring* ring : rings) {
    for (size_t i = 0; i < ring->size(); ++i) {
      const Vec2 a = (*ring)[i];
      const Vec2 along = (*ring)[(i + 1) % ring->size()] - a;
      const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
      best = std::min(best, std::hypot(p.x - a.x - t * along.x, p.y - a.y - t * along.y));
    }
  }
  return best;
}

TEST(ContourFaces, CellsLieInTheInnermostRing) {
  const ContourSet set = landscape(3, 60, 20);
  const Grid<int32_t> face = geom::rasterise_faces(set.contours, set.frame, {});
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      int innermost = -1;
      for (size_t c = 0; c < set.contours.size(); ++c)
        if (geom::contains(set.contours[c].ring, {set.frame.x(x), set.frame.y(y)})) innermost = static_cast<int>(c);
      ASSERT_EQ(face(x, y), innermost + 1) << x << " " << y;
    }
  }
}

TEST(ContourInterpolation, IsThatOfTheExactDistances) {
  const ContourSet set = nested(GridFrame::centred(150, 90, 1.5), {{10, circle({0, 0}, 60), -1},
                                                                   {25, circle({-20, 5}, 25), -1},
                                                                   {25, circle({30, -8}, 18), -1},
                                                                   {40, circle({-24, 8}, 9), -1}});
  const geom::ContourFaces faces(set.contours);
  const geom::ContourInterpolation made = geom::interpolate_contours(set.contours, faces, set.frame, {});
  const std::vector<const Ring*> level10 = {&set.contours[0].ring};
  const std::vector<const Ring*> level25 = {&set.contours[1].ring, &set.contours[3].ring};
  int checked = 0;
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 150; ++x) {
      if (made.face(x, y) != 1) continue;
      const Vec2 p{set.frame.x(x), set.frame.y(y)};
      const double below = distance_to(level10, p);
      const double above = distance_to(level25, p);
      EXPECT_NEAR(made.height_m(x, y), (above * 10 + below * 25) / (below + above), 1e-3);
      EXPECT_NEAR(made.low(x, y), below / 1.5, 1e-4);
      EXPECT_NEAR(made.high(x, y), above / 1.5, 1e-4);
      ++checked;
    }
  }
  EXPECT_GT(checked, 2000);
}

TEST(ContourReconstruct, HonoursContoursAndTheLevelsBeyond) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    const ContourSet set = landscape(seed, 130, 25);
    const geom::ContourFaces faces(set.contours);
    const Grid<int32_t> face = geom::rasterise_faces(set.contours, set.frame, {});
    for (const Method method : kDrained) {
      const HeightField z = reconstruct(set, {.method = method}, {});
      int64_t beyond = 0;
      for (int y = 0; y < z.height(); ++y) {
        for (int x = 0; x < z.width(); ++x) {
          const int32_t f = face(x, y);
          if (faces.bounds_of(f) < 2) continue;
          beyond += z(x, y) < faces.low_m(f) - 1e-3 || z(x, y) > faces.high_m(f) + 1e-3;
        }
      }
      EXPECT_LE(beyond, z.frame().cells() / 2000) << "channels may cut through necks narrower than a cell";
    }
  }
}

TEST(ContourReconstruct, LeavesNoSinkWithoutABasin) {
  for (uint64_t seed = 1; seed <= 25; ++seed) {
    const ContourSet set = landscape(seed, 70 + static_cast<int>(seed), 20);
    for (const Method method : kDrained) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", method " + std::to_string(static_cast<int>(method)));
      expect_drained(reconstruct(set, {.method = method}, {}), set);
    }
    expect_drained(reconstruct(set, {.cell_m = 23.0}, {}), set);
  }
}

TEST(ContourReconstruct, ABasinHoldsOneSink) {
  const GridFrame frame = GridFrame::centred(100, 100, 2.0);
  const ContourSet set = nested(frame, {{0, circle({0, 0}, 90), -1},
                                        {10, circle({0, 0}, 70), -1},
                                        {10, circle({0, 0}, 40), -1},
                                        {0, circle({5, 0}, 20), -1}});
  ASSERT_FALSE(geom::is_hill(set.contours[2]));
  for (const Method method : kDrained) {
    const HeightField z = reconstruct(set, {.method = method}, {});
    expect_drained(z, set);
    EXPECT_LT(z(52, 49), -0.5F) << "the floor lies under its last contour";
    EXPECT_GT(z(50, 22), 10.2F) << "the rim rises over the contours on either side";
  }
}

TEST(ContourReconstruct, AConeStaysAConeAndGetsASummit) {
  for (const double cell : {2.0, 1.0, 5.0}) {
    const ContourSet set = cone_contours(cell);
    const HeightField z = reconstruct(set, {}, {});
    double worst = 0.0;
    for (int y = 0; y < z.height(); ++y) {
      for (int x = 0; x < z.width(); ++x) {
        const double r = std::hypot(z.frame().x(x) - 1, z.frame().y(y) - 2);
        if (r > 12 && r < 88) worst = std::max(worst, std::abs(z(x, y) - (100 - r)));
      }
    }
    EXPECT_LT(worst, 0.6) << cell;
    const float top = *std::max_element(z.cells().begin(), z.cells().end());
    EXPECT_GT(top, 93.0F) << cell;
    EXPECT_LT(top, 98.1F) << cell;
  }
}

TEST(ContourReconstruct, SlopesGoOnAcrossContours) {
  // Contours 30 m apart below and 10 m apart above: the plain interpolation breaks at 100 m.
  std::vector<Contour> contours;
  for (int k = 0; k <= 8; ++k)
    contours.push_back({k * 20.0, circle({0, 0}, k < 5 ? 200.0 - 30 * k : 120.0 - 10 * k), -1});
  const ContourSet set = nested(GridFrame::centred(220, 220, 2.0), std::move(contours));
  const auto sharpest_bend = [&](Method method) {
    const HeightField z = reconstruct(set, {.method = method}, {});
    float bend = 0.0F;
    for (int x = 20; x < 85; ++x) bend = std::max(bend, std::abs(z(x - 1, 110) - 2 * z(x, 110) + z(x + 1, 110)));
    return bend;
  };
  // A slope that went on wholly would leave a level tread below the break (NoTerraceRunsAlongTheFootOfARange).
  EXPECT_LT(sharpest_bend(Method::smooth), 0.65F * sharpest_bend(Method::interpolated));
}

TEST(ContourReconstruct, StairsAreTheHeightsOfTheContours) {
  const ContourSet set = cone_contours();
  const HeightField z = reconstruct(set, {.method = Method::stairs}, {});
  EXPECT_EQ(z(60, 60), 90.0F);
  EXPECT_EQ(z(60, 60 + 22), 50.0F);
  EXPECT_EQ(z(0, 0), 0.0F) << "the land outside lies a step lower than the first contour";
}

TEST(ContourReconstruct, TheSameContoursComeOutAgain) {
  const ContourSet set = landscape(5, 160, 25);
  const HeightField z = reconstruct(set, {}, {});
  ExtractParams params;
  params.interval_m = 25;
  const ContourSet again = extract(z, params, {});
  for (const double level : {100.0, 200.0, 300.0}) {
    std::vector<const Ring*> rings;
    for (const Contour& c : again.contours)
      if (c.height_m == level) rings.push_back(&c.ring);
    for (const Contour& c : set.contours) {
      if (c.height_m != level || c.ring.size() < 20) continue;
      for (const Vec2 p : c.ring) {
        if (std::abs(p.x) > 790 || std::abs(p.y) > 790) continue;
        EXPECT_LT(distance_to(rings, p), 10.0) << level;
      }
    }
  }
}

TEST(ContourReconstruct, FromANetworkIsLinearAndDrains) {
  const Tin plane = geom::lattice_tin(21, 17, 4.0, Seed{3}, [](Vec2 p) { return 3 * p.x - 2 * p.y; });
  const HeightField flat = reconstruct(plane, {.cell_m = 0.7}, {});
  for (int y = 0; y < flat.height(); ++y)
    for (int x = 0; x < flat.width(); ++x)
      EXPECT_NEAR(flat(x, y), 3 * flat.frame().x(x) - 2 * flat.frame().y(y), 1.5) << x << " " << y;
  EXPECT_NEAR(flat(50, 40), 3 * flat.frame().x(50) - 2 * flat.frame().y(40), 1e-3);
  for (uint64_t seed = 0; seed < 10; ++seed) {
    Tin rough = geom::lattice_tin(21, 17, 4.0, Seed{seed}, [](Vec2 p) { return 100 - 0.1 * dot(p, p); });
    Rng rng(Seed{seed}.derive("rough"));
    for (float& z : rough.height_m) z += static_cast<float>(rng.uniform(-0.2, 0.2));
    const HeightField z = reconstruct(rough, {.cell_m = 1.3}, {});
    for (int y = 1; y + 1 < z.height(); ++y)
      for (int x = 1; x + 1 < z.width(); ++x) EXPECT_TRUE(has_lower_neighbour(z, x, y)) << seed;
  }
}

TEST(ContourReconstruct, OddFrames) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {40, 1}, {2, 3}, {5, 7}}) {
    const GridFrame frame = GridFrame::centred(width, height, 5.0);
    const ContourSet set = nested(frame, {{5, circle({0, 0}, 60), -1}, {9, circle({2, 0}, 4), -1}});
    for (const Method method : {Method::smooth, Method::interpolated, Method::stairs}) {
      const HeightField z = reconstruct(set, {.method = method}, {});
      for (const float v : z.cells()) EXPECT_TRUE(std::isfinite(v));
    }
  }
}

TEST(ContourReconstruct, IsTheSameOnAnyNumberOfThreads) {
  const ContourSet set = landscape(2, 300, 20);
  const HeightField one = reconstruct(set, {}, {.threads = 1});
  EXPECT_EQ(reconstruct(set, {}, {.threads = 2}), one);
}

TEST(ContourReconstruct, SaysWhatIsWrong) {
  const auto message = [](auto&& call) -> std::string {
    try {
      call();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const GridFrame frame = GridFrame::centred(10, 10, 10.0);
  EXPECT_THAT(message([&] { reconstruct(ContourSet{frame, {}}, {}, {}); }), HasSubstr("contours: there are none"));
  const ContourSet crossed{frame, {{5, circle({0, 0}, 20), -1}, {7, circle({10, 0}, 20), -1}}};
  EXPECT_THAT(message([&] { reconstruct(crossed, {}, {}); }), HasSubstr("those of 5 m and 7 m cross or touch at ("));
  EXPECT_THAT(message([&] { reconstruct(cone_contours(), {.cell_m = 0.002}, {}); }), HasSubstr("cell_m: 0.002 makes"));
  EXPECT_THAT(message([&] { reconstruct(Tin{}, {}, {}); }), HasSubstr("tin: has no triangles"));
}

}  // namespace
}  // namespace seamount::contour
