#include "seamount/ops/terrain/sculpt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/geom/brush/brush_rows.h"
#include "seamount/geom/grid/resample.h"
#include "seamount/geom/grid/surface.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::terrain {
namespace {

using ::testing::HasSubstr;

HeightField hills(int width = 90, int height = 70, double cell_m = 40.0) {
  HeightField terrain = geom::fbm_grid(GridFrame::centred(width, height, cell_m), Seed{7}, {.wavelength_m = 900}, {});
  for (float& z : terrain.cells()) z *= 300.0F;
  return terrain;
}

HeightField plane(double slope, int width = 90, int height = 70, double cell_m = 40.0) {
  HeightField terrain(GridFrame::centred(width, height, cell_m));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) terrain(x, y) = static_cast<float>(slope * terrain.frame().x(x));
  return terrain;
}

HeightField sculpted(const HeightField& terrain, std::vector<SculptStroke> strokes, const Mask* mask = nullptr,
                     Seed seed = {1}) {
  return sculpt(terrain, mask, {std::move(strokes)}, seed, {});
}

const Polyline kLine = {{-900, -300}, {-200, 250}, {700, 100}};
const Brush kBrush{kLine, {}, 300, 0.2};

/// What a stroke weighs, cell by cell.
ScalarField weights(const Brush& brush, const GridFrame& frame) {
  ScalarField out(frame, 0.0F);
  geom::BrushBand band;
  band.read(geom::brush_path(brush, frame, ""), frame, 0, frame.height);
  band.each_row([&](int y, int x, std::span<const float> w) { std::copy(w.begin(), w.end(), &out(x, y)); });
  return out;
}

TEST(Sculpt, RaisesAndLowersByTheBrushAndLeavesTheRestToTheBit) {
  const HeightField before = hills();
  const ScalarField w = weights(kBrush, before.frame());
  const HeightField up = sculpted(before, {RaiseTool{kBrush, 120}});
  const HeightField down = sculpted(before, {LowerTool{kBrush, 120}});
  int touched = 0;
  for (size_t i = 0; i < w.size(); ++i) {
    const float z = before.cells()[i], share = w.cells()[i];
    ASSERT_NEAR(up.cells()[i], z + 120 * share, 1e-3);
    ASSERT_NEAR(down.cells()[i], z - 120 * share, 1e-3);
    if (share == 0.0F) {
      ASSERT_EQ(up.cells()[i], z);
    }
    touched += share > 0.0F ? 1 : 0;
  }
  EXPECT_GT(touched, 500);
  EXPECT_EQ(sculpted(before, {}), before);
}

TEST(Sculpt, OneStrokeThatCrossesItselfDoesNotCountTwiceTwoDo) {
  const HeightField flat = plane(0.0);
  const Brush there{{{-800, 0}, {800, 0}}, {}, 300, 0.5};
  const Brush there_and_back{{{-800, 0}, {800, 0}, {-800, 0.5}}, {}, 300, 0.5};
  const auto highest = [](const HeightField& z) { return *std::max_element(z.cells().begin(), z.cells().end()); };
  EXPECT_NEAR(highest(sculpted(flat, {RaiseTool{there_and_back, 100}})), 100, 0.1);
  EXPECT_NEAR(highest(sculpted(flat, {RaiseTool{there, 100}, RaiseTool{there, 100}})), 200, 0.1);
}

TEST(Sculpt, PressureScalesWhatIsDone) {
  Brush light = kBrush;
  light.pressure = {0.25, 0.25, 0.25};
  const HeightField before = hills();
  const HeightField all = sculpted(before, {RaiseTool{kBrush, 100}}), part = sculpted(before, {RaiseTool{light, 400}});
  for (size_t i = 0; i < all.size(); ++i) ASSERT_NEAR(all.cells()[i], part.cells()[i], 1e-2);
  light.pressure = {0, 0, 0};
  EXPECT_EQ(sculpted(before, {RaiseTool{light, 400}}), before);
}

TEST(Sculpt, SmoothTakesDetailOffAndHasNoEdge) {
  const HeightField before = hills();
  const Brush all{{{-3000, 0}, {3000, 0}}, {}, 2500, 1.0};
  const HeightField smooth = sculpted(before, {SmoothTool{{{{0, 0}}, {}, 600, 0}, 1.0}});
  const auto roughness = [](const HeightField& z, int x0, int x1) {
    double sum = 0.0;
    for (int y = 33; y < 37; ++y)
      for (int x = x0; x < x1; ++x) sum += std::abs(z(x - 1, y) - 2 * z(x, y) + z(x + 1, y));
    return sum;
  };
  EXPECT_LT(roughness(smooth, 43, 47), 0.15 * roughness(before, 43, 47));
  // A plane stays a plane, to the terrain's edges; nothing goes beyond the heights around it.
  const HeightField slope = plane(0.4), still = sculpted(slope, {SmoothTool{all, 1.0}});
  for (size_t i = 0; i < slope.size(); ++i) ASSERT_NEAR(still.cells()[i], slope.cells()[i], 0.02);
  HeightField step = plane(0.0);
  for (int y = 0; y < step.height(); ++y)
    for (int x = 45; x < step.width(); ++x) step(x, y) = 500.0F;
  const HeightField softened = sculpted(step, {SmoothTool{kBrush, 1.0}});
  for (const float z : softened.cells()) ASSERT_TRUE(z >= 0.0F && z <= 500.01F);
}

TEST(Sculpt, SmoothEqualsABlurOfTheWholeWeighed) {
  const HeightField before = hills();
  const HeightField blurred = geom::at_scale(before, 2.0 / 3.0 * 300, {});
  const ScalarField w = weights(kBrush, before.frame());
  const HeightField out = sculpted(before, {SmoothTool{kBrush, 0.7}});
  for (size_t i = 0; i < w.size(); ++i) {
    const double z = before.cells()[i];
    ASSERT_NEAR(out.cells()[i], z + 0.7 * w.cells()[i] * (blurred.cells()[i] - z), 0.05);
  }
}

TEST(Sculpt, FlattenTakesTheHeightWhereTheStrokeBegins) {
  const HeightField slope = plane(0.4);
  const Brush brush{{{-400, 0}, {800, 0}}, {}, 200, 0.8};
  const HeightField out = sculpted(slope, {FlattenTool{brush, {}, 1.0}});
  for (int x = 37; x < 62; ++x) EXPECT_NEAR(out(x, 35), -160, 1.0) << x;
  const HeightField given = sculpted(slope, {FlattenTool{brush, 55.0, 0.5}});
  EXPECT_NEAR(given(50, 35), 0.5 * (55 + slope(50, 35)), 0.1);
  // In order: what is raised first is the ground that is taken.
  const HeightField raised = sculpted(slope, {RaiseTool{{{{-400, 0}}, {}, 600, 0.9}, 70}, FlattenTool{brush, {}, 1.0}});
  EXPECT_NEAR(raised(60, 35), -160 + 70, 1.5);
  // One that begins outside begins where it comes in.
  const HeightField from_outside = sculpted(slope, {FlattenTool{{{{-9000, 0}, {800, 0}}, {}, 200, 0.8}, {}, 1.0}});
  EXPECT_NEAR(from_outside(50, 35), 0.4 * -1800, 60);
}

TEST(Sculpt, RampIsEvenFromBeginningToEnd) {
  const HeightField before = hills();
  const Brush brush{{{-1000, 0}, {1000, 0}}, {}, 300, 0.7};
  const HeightField out = sculpted(before, {RampTool{brush, 100.0, 300.0, 1.0}});
  for (int x = 25; x < 65; ++x) EXPECT_NEAR(out(x, 35), 200 + 0.1 * before.frame().x(x), 0.1) << x;
  const HeightField slope = plane(0.3);
  const HeightField same = sculpted(slope, {RampTool{brush, {}, {}, 1.0}});
  for (int x = 25; x < 65; ++x) EXPECT_NEAR(same(x, 33), slope(x, 33), 1.0);
}

TEST(Sculpt, RoughenIsOneFieldOfNoiseOfTheSeed) {
  const HeightField flat = plane(0.0);
  const HeightField out = sculpted(flat, {RoughenTool{kBrush, 60, 500}});
  const auto [low, high] = std::minmax_element(out.cells().begin(), out.cells().end());
  EXPECT_LT(*low, -10);
  EXPECT_GT(*high, 10);
  EXPECT_GT(*low, -100);
  EXPECT_LT(*high, 100);
  EXPECT_EQ(sculpted(flat, {RoughenTool{kBrush, 60, 500}}), out);
  EXPECT_FALSE(sculpted(flat, {RoughenTool{kBrush, 60, 500}}, nullptr, {2}) == out);
  // Another stroke somewhere before it changes nothing where it is not.
  const HeightField more = sculpted(flat, {RaiseTool{{{{-1600, 1200}}, {}, 200, 0}, 50}, RoughenTool{kBrush, 60, 500}});
  EXPECT_EQ(more(45, 35), out(45, 35));
}

TEST(Sculpt, EraseBringsBackTheGroundAsItCame) {
  const HeightField before = hills();
  Brush wide = kBrush;
  wide.radius_m = 900;
  wide.hardness = 0.9;
  const HeightField out = sculpted(before, {RaiseTool{kBrush, 200}, SmoothTool{kBrush, 1}, EraseTool{wide, 1.0}});
  for (size_t i = 0; i < out.size(); ++i) ASSERT_NEAR(out.cells()[i], before.cells()[i], 1e-3);
}

TEST(Sculpt, AMaskHoldsBack) {
  const HeightField before = hills();
  Mask mask(before.frame(), 1.0F);
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x)
      if (x < 45) mask(x, y) = y % 2 == 0 ? 0.0F : std::numeric_limits<float>::quiet_NaN();
  }
  const std::vector<SculptStroke> strokes = {RaiseTool{kBrush, 100}, SmoothTool{kBrush, 1}, RoughenTool{kBrush}};
  const HeightField out = sculpted(before, strokes, &mask), all = sculpted(before, strokes);
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < 45; ++x) ASSERT_EQ(out(x, y), before(x, y));
  EXPECT_EQ(out(60, 33), all(60, 33));
  EXPECT_THROW(sculpted(before, strokes, std::make_unique<Mask>(GridFrame::centred(3, 3, 1), 1.0F).get()),
               IncompatibleInputs);
}

TEST(Sculpt, UnknownGroundStaysUnknownAndSpoilsNothing) {
  HeightField before = hills();
  for (int y = 30; y < 38; ++y)
    for (int x = 40; x < 50; ++x) before(x, y) = std::numeric_limits<float>::quiet_NaN();
  const HeightField out =
      sculpted(before, {RaiseTool{kBrush, 100}, SmoothTool{kBrush, 1}, FlattenTool{kBrush}, RampTool{kBrush}});
  for (size_t i = 0; i < out.size(); ++i) ASSERT_EQ(std::isnan(out.cells()[i]), std::isnan(before.cells()[i]));
}

TEST(Sculpt, CoarseCellsShowWhatFineOnesDo) {
  Brush pressed = kBrush;
  pressed.pressure = {0.3, 1.0, 0.6};
  const std::vector<SculptStroke> strokes = {
      RaiseTool{pressed, 300}, RoughenTool{kBrush, 60, 700}, SmoothTool{{{{0, 0}, {900, 300}}, {}, 400, 0}, 1.0},
      FlattenTool{{{{600, -500}, {900, -600}}, {}, 300, 0.3}}, RampTool{{{{-900, 600}, {0, 700}}, {}, 250, 0.4}}};
  const HeightField fine = sculpted(hills(1024, 1024, 4), strokes);
  const HeightField start = geom::box_downsample(hills(1024, 1024, 4), 4, {});
  const HeightField coarse = sculpted(start, strokes), shown = geom::box_downsample(fine, 4, {});
  double worst = 0.0, sum = 0.0;
  for (size_t i = 0; i < coarse.size(); ++i) {
    const double off = std::abs(coarse.cells()[i] - shown.cells()[i]);
    worst = std::max(worst, off);
    sum += off * off;
  }
  EXPECT_LT(worst, 4.0);  // of 300 m
  EXPECT_LT(std::sqrt(sum / static_cast<double>(coarse.size())), 0.3);
}

TEST(Sculpt, OddShapes) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {40, 1}}) {
    const HeightField before = hills(width, height);
    const HeightField out = sculpted(before, {RaiseTool{kBrush, 100}, SmoothTool{kBrush}, FlattenTool{kBrush},
                                              RampTool{kBrush}, RoughenTool{kBrush}, EraseTool{kBrush}});
    for (const float z : out.cells()) EXPECT_TRUE(std::isfinite(z));
  }
}

TEST(Sculpt, MistakesAreNamed) {
  const auto error_of = [](const SculptStroke& stroke) -> std::string {
    try {
      sculpted(hills(), {RaiseTool{kBrush}, stroke});
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of(RaiseTool{}), "strokes[1].points: has no point");
  EXPECT_THAT(error_of(SmoothTool{{kLine, {1, 0.5}, 300, 0}}), HasSubstr("strokes[1].pressure: has 2 values for 3"));
  EXPECT_THAT(error_of(SmoothTool{{kLine, {1, 0.5, 1.5}, 300, 0}}), HasSubstr("strokes[1].pressure: 1.5 is outside"));
  EXPECT_THAT(error_of(LowerTool{{kLine, {}, 0, 0}}), HasSubstr("strokes[1].radius_m: 0 is outside"));
  EXPECT_THAT(error_of(LowerTool{{{{std::nan(""), 0}}, {}, 10, 0}}), HasSubstr("strokes[1].points: point 0"));
}

}  // namespace
}  // namespace seamount::terrain
