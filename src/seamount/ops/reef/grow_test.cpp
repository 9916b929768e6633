#include "seamount/ops/reef/grow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include <algorithm>
#include <cmath>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/reef/habitat.h"
#include "seamount/ops/reef/kernels.h"

namespace seamount::reef {
namespace {

using ::testing::HasSubstr;

/// A sea floor that slopes down to the east.
HeightField slope(int cells, double cell_m) {
  HeightField field(GridFrame::centred(cells, cells, cell_m));
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) field(x, y) = static_cast<float>(-30.0 - 0.005 * field.frame().x(x));
  }
  return field;
}

/// P4 sec. 4.1 on a small terrain.
GrowParams paper() {
  GrowParams p;
  p.lattice_m = 100;
  p.particles = 150;
  p.walk.max_steps = 30000;
  p.bounds.margin_m = 0;
  p.starts.points = {{210, -130}};
  p.kernel.combine = Combine::sum;
  p.heights.mode = Lift::proportional;
  p.irregularity = 0;
  p.heights.w0 = 0.5;
  p.heights.w1 = 0.2;
  p.heights.w2 = 0.1;
  p.kernel.k2 = 10;
  p.sand.cays = 0;
  return p;
}

template <class Params>
std::string message(const HeightField& terrain, const Params& params, GrowInputs in) {
  try {
    grow(in, params, Seed{1}, {});
  } catch (const Error& error) {
    return error.what();
  }
  return terrain.empty() ? "" : "no error";
}

std::string message(const HeightField& terrain, const GrowParams& params) {
  return message(terrain, params, GrowInputs{terrain});
}

TEST(ReefGrow, IsEquationsOneAndTwoWithThePapersSettings) {
  HeightField base = slope(160, 25);  // with a hollow and a hill: the paper's heights know no sea
  for (int y = 60; y < 110; ++y)
    for (int x = 60; x < 110; ++x) base(x, y) += y < 90 && x > 70 && x < 90 && y > 70 ? -40.0F : 90.0F;
  GrowParams p = paper();
  for (const double irregularity : {0.0, 1.0}) {
    p.irregularity = irregularity;
    const Grown grown = grow({base}, p, Seed{4}, {});
    const Habitat habitat = find_habitat(base, {}, *p.lattice_m, 0.0, p.starts, p.bounds, Seed{4}, {});
    WalkRules rules;
    rules.particles = 150;
    rules.launch = p.walk.launch;
    const Aggregate reef = aggregate(habitat.suitable, habitat.kernels, rules, Seed{4}, {});
    const auto colonies =
        place_colonies(reef.cells, habitat.lattice,
                       {146.484375, 0.45 * irregularity, 0.3 * irregularity, p.kernel.k1, p.kernel.k1_jitter}, Seed{4});
    for (int y = 3; y < 160; y += 7) {
      for (int x = 2; x < 160; ++x) {
        double n = 0, e = 0;
        for (const Colony& q : colonies) {
          const Vec2 v = Vec2{base.frame().x(x), base.frame().y(y)} - q.centre;
          const double t = std::sqrt(dot(v, v)) / q.radius_m;
          n += std::exp(-std::pow(t, 10));
          if (t < 1 && (q.neighbours >> direction_of(v) & 1) == 0)
            e += std::exp(-std::pow(std::log(q.k1 * (1 - t)), 10));
        }
        const double h0 = static_cast<double>(base(x, y)) + 250;
        ASSERT_NEAR(grown.terrain(x, y), -250 + 0.5 * h0 + 0.2 * h0 * n + 0.1 * h0 * e, 0.1) << x << " " << y;
        ASSERT_NEAR(grown.aggregate(x, y), std::min(1.0, n), 1e-3);
      }
    }
  }
}

/// Half of the ground is a sea of 0 m without a floor, the other half a shelf: reefs stand on the shelf only.
TEST(ReefGrow, NothingStandsOnASeaWithoutAFloor) {
  for (const uint64_t seed : {1, 2, 3}) {
    HeightField base(GridFrame::centred(200, 200, 20), -30.0F);
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 100; ++x) base(x, y) = 0.0F;
    std::string said;
    RunContext run;
    run.note = [&](const std::string& line) { said = line; };
    const Grown grown = grow({base}, GrowParams(), Seed{seed}, run);
    EXPECT_NE(said.find("terrain.sea_floor"), std::string::npos);
    double reef = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x) {
        reef += static_cast<double>(grown.aggregate(x, y));
        if (x >= 100) continue;
        ASSERT_EQ(grown.terrain(x, y), 0.0F) << seed << " " << x << " " << y;
        ASSERT_EQ(grown.aggregate(x, y), 0.0F);
      }
    }
    EXPECT_GT(reef, 0) << "there is one on the shelf, " << seed;
  }
}

TEST(ReefGrow, UnionOfOneColonyHasTheKernelsThemselves) {
  const HeightField base(GridFrame::centred(200, 200, 5), -40.0F);
  GrowParams p = paper();
  p.kernel.combine = Combine::union_;
  p.kernel.k1_jitter = 0;
  p.detail.grooves_m = 0;
  p.starts.points = {{50, 50}};
  p.particles = 1;
  p.walk.max_steps = 1;  // lost: the kernel stays alone
  p.walk.stickiness = 0.001;
  const Grown grown = grow({base}, p, Seed{1}, {});
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const Vec2 v = Vec2{base.frame().x(x), base.frame().y(y)} - Vec2{50, 50};
      const double t = std::sqrt(dot(v, v)) / 146.484375;
      double low = 1e9, high = -1e9;  // of the kernels within 5 % of the radius: what the form's lattice resolves
      for (double u = std::max(0.0, t - 0.05); u <= t + 0.05; u += 0.002) {
        const double z = -250 + 210 * (0.5 + 0.2 * normal_kernel(u, 10) + 0.1 * edge_kernel(u, 5, 10));
        low = std::min(low, z), high = std::max(high, z);
      }
      ASSERT_GT(grown.terrain(x, y), low - 0.5) << x << " " << y;
      ASSERT_LT(grown.terrain(x, y), high + 0.5) << x << " " << y;
    }
  }
}

TEST(ReefGrow, NeverLowersTheGroundAndEndsAtTheSurface) {
  HeightField base = slope(220, 20);
  for (int y = 0; y < 220; ++y) {
    for (int x = 0; x < 40; ++x) base(x, y) = static_cast<float>(30 - x);
  }
  GrowParams p;
  p.sand.cays = 0;
  p.walk.launch = Launch::ring;
  const Grown grown = grow({base}, p, Seed{2}, {});
  int lifted = 0;
  for (size_t i = 0; i < base.size(); ++i) {
    const float z = grown.terrain.cells()[i], z0 = base.cells()[i];
    ASSERT_GE(z, z0 - 1e-3F);
    if (z0 > 0) {
      ASSERT_EQ(z, z0) << "land is left alone";
    } else if (z0 < -1) {
      ASSERT_LT(z, p.heights.crest_m + 0.1);
    }
    lifted += z > z0 + 10 ? 1 : 0;
  }
  EXPECT_GT(lifted, 3000);
}

TEST(ReefGrow, WaterBehindARingIsLagoon) {
  const HeightField base(GridFrame::centred(200, 200, 20), -30.0F);
  Drawing ring;
  ValuedLine line;
  for (int i = 0; i < 60; ++i) line.points.push_back({1000 * std::cos(i * 0.10472), 1000 * std::sin(i * 0.10472)});
  line.closed = true;
  ring.lines.push_back(line);
  GrowParams p;
  p.starts.line_cover = 1;
  p.particles = 30;
  p.passes.least_km2 = 1e6;
  p.sand.cays = 0;
  const Grown grown = grow({.terrain = base, .drawing = &ring}, p, Seed{2}, {});
  EXPECT_EQ(grown.labels(100, 100), Region::lagoon);
  EXPECT_EQ(grown.labels(2, 100), Region::abyss);
  EXPECT_EQ(std::count(grown.labels.cells().begin(), grown.labels.cells().end(), Region::mountain), 0);
  const Drawing outlines = reef_outlines(grown.aggregate, {});
  ASSERT_EQ(outlines.areas.size(), 1U);
  ASSERT_FALSE(outlines.areas[0].parts.empty());
  EXPECT_FALSE(outlines.areas[0].parts[0].holes.empty());
  EXPECT_FALSE(geom::find_defect(outlines.areas[0].parts[0]));
}

TEST(ReefGrow, LabelsGoOnWhereNoReefGrows) {
  const HeightField base(GridFrame::centred(150, 150, 20), -30.0F);
  LabelMap labels(base.frame(), Region::abyss);
  for (int y = 0; y < 150; ++y) labels(0, y) = Region::lagoon;
  GrowParams p;
  p.lattice_m = 30;
  const Grown grown = grow({.terrain = base, .labels = &labels}, p, Seed{2}, {});
  EXPECT_EQ(grown.labels(0, 75), Region::lagoon);
  EXPECT_EQ(grown.labels(149, 75), Region::abyss);
  EXPECT_GT(std::count(grown.labels.cells().begin(), grown.labels.cells().end(), Region::reef), 100);
}

TEST(ReefGrow, ACoarseRasterIsAPreviewOfAFineOne) {
  GrowParams p;
  p.lattice_m = 60;
  const Grown fine = grow({slope(800, 5)}, p, Seed{5}, {});
  const Grown coarse = grow({slope(200, 20)}, p, Seed{5}, {});
  const HeightField averaged = geom::box_downsample(fine.terrain, 4, {});
  double difference = 0, relief = 0;
  for (size_t i = 0; i < averaged.size(); ++i) {
    difference += std::abs(static_cast<double>(averaged.cells()[i]) - static_cast<double>(coarse.terrain.cells()[i]));
    relief += std::abs(static_cast<double>(averaged.cells()[i]) + 30.0);
  }
  EXPECT_LT(difference, 0.06 * relief);
}

TEST(ReefGrow, IsTheSameOnAnyNumberOfThreads) {
  const HeightField base = slope(300, 15);
  for (const Combine combine : {Combine::union_, Combine::sum}) {
    GrowParams p;
    p.kernel.combine = combine;
    p.finish.blur_m = 20;
    const Grown one = grow({base}, p, Seed{1}, {.threads = 1});
    for (const int threads : {2, 4}) {
      const Grown more = grow({base}, p, Seed{1}, {.threads = threads});
      EXPECT_TRUE(one.terrain == more.terrain);
      EXPECT_TRUE(one.labels == more.labels);
      EXPECT_TRUE(one.aggregate == more.aggregate);
    }
  }
}

TEST(ReefGrow, NormalisesToTheGivenHeights) {
  GrowParams p = paper();
  p.finish.normalise = true;
  p.finish.blur_m = 30;
  const Grown grown = grow({slope(120, 25)}, p, Seed{1}, {});
  const auto [low, high] = std::minmax_element(grown.terrain.cells().begin(), grown.terrain.cells().end());
  EXPECT_NEAR(*low, -250, 0.01);
  EXPECT_NEAR(*high, 250, 0.01);
}

TEST(ReefGrow, TakesOddShapes) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {40, 1}, {3, 2}}) {
    GrowParams p;
    p.lattice_m = 10;
    p.bounds.margin_m = 0;
    const HeightField base(GridFrame::centred(width, height, 10), -20.0F);
    const Grown grown = grow({base}, p, Seed{1}, {});
    for (const float z : grown.terrain.cells()) ASSERT_TRUE(std::isfinite(z));
  }
}

TEST(ReefGrow, SaysWhatIsWrong) {
  const HeightField base = slope(200, 20);
  GrowParams p;
  p.starts.points = {{0, 0}, {9000, 0}};
  EXPECT_THAT(message(base, p), HasSubstr("starts.points: place 2 at (9000, 0) m lies outside the terrain"));
  p.starts.points = {{0, 0}};
  p.bounds.high_m = -35;
  EXPECT_THAT(message(base, p), HasSubstr("starts.points: place 1 at (0, 0) m lies outside the habitat"));
  EXPECT_THAT(message(base, p), HasSubstr("the ground is at -30"));
  p.starts.points = {};
  p.bounds.high_m = -500;
  EXPECT_THAT(message(base, p), HasSubstr("bounds.high_m: -500 m lies in the dark"));
  p = {};
  p.particles = 100000;
  EXPECT_THAT(message(base, p), HasSubstr("particles: 100000 do not fit the"));
  p = {};
  p.walk.stickiness = 0;
  EXPECT_THAT(message(base, p), HasSubstr("walk.stickiness: 0 is outside [0.001, 1]"));
  p = {};
  p.lattice_m = 0.1;
  EXPECT_THAT(message(base, p), HasSubstr("lattice_m: 0.1 m gives 40000 cells a side"));
  p = {};
  p.bounds.margin_m = 5000;
  EXPECT_THAT(message(base, p), HasSubstr("bounds.margin_m: 5000 m leaves nothing"));
  p = {};
  p.starts.line = {{9000, 9000}, {9500, 9000}};
  EXPECT_THAT(message(base, p), HasSubstr("starts.line: no covered part"));
  p = {};
  p.starts.contour_m = 300;
  EXPECT_THAT(message(base, p), HasSubstr("starts.contour_m: the terrain has no contour at 300 m"));
  p = {};
  const ScalarField nowhere(base.frame(), 0.0F), other(GridFrame::centred(3, 3, 1), 1.0F);
  EXPECT_THAT(message(base, p, {.terrain = base, .habitat = &nowhere}), HasSubstr("habitat: the mask has no"));
  EXPECT_THAT(message(base, p, {.terrain = base, .start = &nowhere}), HasSubstr("start: no lattice cell"));
  EXPECT_THAT(message(base, p, {.terrain = base, .habitat = &other}), HasSubstr("habitat: 3 x 3 cells do not match"));
  const LabelMap labels(other.frame(), Region::abyss);
  EXPECT_THAT(message(base, p, {.terrain = base, .labels = &labels}), HasSubstr("labels: 3 x 3 cells do not match"));
  p.finish.normalise = true;
  p.finish.low_m = 300;
  EXPECT_THAT(message(base, p), HasSubstr("finish.low_m: 300 is not below"));
}

}  // namespace
}  // namespace seamount::reef
