#include "seamount/ops/terrain/mask.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "seamount/geom/grid/surface.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::terrain {
namespace {

HeightField hills(int width = 90, int height = 70) {
  HeightField terrain = geom::fbm_grid(GridFrame::centred(width, height, 20.0), Seed{3}, {.wavelength_m = 900}, {});
  for (float& z : terrain.cells()) z *= 300.0F;
  return terrain;
}

Mask select(const HeightField& terrain, std::vector<Criterion> criteria, Combine combine = Combine::product) {
  return mask({terrain}, {.criteria = std::move(criteria), .combine = combine}, Seed{1}, {});
}

TEST(SoftRange, IsOneWithinAndFadesSmoothlyBeyond) {
  EXPECT_EQ(soft_range(5, 2, 8, 4), 1);
  EXPECT_EQ(soft_range(2, 2, 8, 4), 1);
  EXPECT_DOUBLE_EQ(soft_range(0, 2, 8, 4), 0.5);
  EXPECT_DOUBLE_EQ(soft_range(9, 2, 8, 4), 1 - (3.0 / 16 - 2.0 / 64));
  EXPECT_EQ(soft_range(-2, 2, 8, 4), 0);
  EXPECT_EQ(soft_range(1e9, 2, {}, 4), 1);
  EXPECT_EQ(soft_range(-1e9, {}, 8, 4), 1);
  EXPECT_EQ(soft_range(1.999, 2, 8, 0), 0);
  EXPECT_EQ(soft_range(2, 2, 8, 0), 1);
}

TEST(Mask, NothingAskedSelectsEverythingAndInvertedNothing) {
  const HeightField terrain = hills();
  EXPECT_EQ(select(terrain, {}), Mask(terrain.frame(), 1.0F));
  EXPECT_EQ(select(terrain, {}, Combine::max), Mask(terrain.frame(), 1.0F));
  EXPECT_EQ(mask({terrain}, {.invert = true}, {}, {}), Mask(terrain.frame(), 0.0F));
}

TEST(Mask, HeightAndDepthAreTheSoftRangeOfEachCell) {
  const HeightField terrain = hills();
  const Mask high = select(terrain, {ByHeight{.low_m = 10, .high_m = 60, .falloff_m = 25}});
  const Mask deep = select(terrain, {ByDepth{.low_m = 5, .high_m = 40, .falloff_m = 0}});
  for (size_t i = 0; i < terrain.size(); ++i) {
    const double z = terrain.cells()[i];
    ASSERT_NEAR(high.cells()[i], soft_range(z, 10, 60, 25), 1e-5);
    ASSERT_EQ(deep.cells()[i], -z >= 5 && -z <= 40 ? 1 : 0);
  }
}

TEST(Mask, SlopeAspectAndCurvatureFollowTheSurface) {
  const HeightField terrain = hills();
  const Mask steep = select(terrain, {BySlope{.low_deg = 20, .falloff_deg = 8, .scale_m = 0}});
  const Mask north = select(
      terrain, {ByAspect{.direction_deg = -340, .spread_deg = 80, .falloff_deg = 40, .level_deg = 4, .scale_m = 0}});
  const Mask ridges =
      select(terrain, {ByCurvature{.bend = Bend::plan, .low_per_km = 2.0, .falloff_per_km = 4.0, .scale_m = 0}});
  for (int y = 0; y < terrain.height(); ++y) {
    for (int x = 0; x < terrain.width(); ++x) {
      const geom::SurfaceFit fit = geom::fit_surface(terrain, x, y);
      ASSERT_NEAR(steep(x, y), soft_range(fit.slope_deg(), 20, {}, 8), 1e-3);
      const double away = std::abs(std::remainder(fit.aspect_deg() - 20.0, 360.0));
      ASSERT_NEAR(north(x, y), soft_range(away, {}, 40, 40) * soft_range(fit.slope_deg(), 4, {}, 4), 2e-3);
      ASSERT_NEAR(ridges(x, y), soft_range(1000 * fit.plan_curvature(), 2, {}, 4), 2e-2);
    }
  }
}

TEST(Mask, LevelGroundFacesNowhere) {
  const HeightField flat(GridFrame::centred(8, 8, 10), 5.0F);
  const Mask any = select(flat, {ByAspect{.spread_deg = 360}});
  EXPECT_EQ(any, Mask(flat.frame(), 0.0F));
  EXPECT_EQ(select(flat, {ByAspect{.spread_deg = 360, .invert = true}}), Mask(flat.frame(), 1.0F));
}

TEST(Mask, RegionsAreSelectedByTheDistanceFromTheirBorder) {
  const GridFrame frame = GridFrame::centred(60, 8, 10.0);
  const HeightField terrain(frame, 0.0F);
  LabelMap labels(frame, Region::abyss);
  for (int y = 0; y < 8; ++y) {
    for (int x = 20; x < 40; ++x) labels(x, y) = Region::reef;
  }
  const auto by = [&](const ByRegion& region) {
    return mask({.terrain = terrain, .labels = &labels}, {.criteria = {region}}, {}, {});
  };
  const Mask itself = by({.region = Region::reef, .falloff_m = 0});
  const Mask near = by({.region = Region::reef, .low_m = -20, .high_m = 40, .falloff_m = 30});
  for (int x = 0; x < 60; ++x) {
    ASSERT_EQ(itself(x, 4), x >= 20 && x < 40 ? 1 : 0) << x;
    const double distance = std::abs((x + 0.5) * 10 - 300) - 100;
    ASSERT_NEAR(near(x, 4), soft_range(distance, -20, 40, 30), 1e-5) << x;
  }
  EXPECT_EQ(by({.region = Region::beach}), Mask(frame, 0.0F));  // there is none
}

TEST(Mask, AreasAndLinesComeFromParametersOrTheDrawing) {
  const HeightField terrain(GridFrame::centred(80, 80, 10.0), 0.0F);
  const Polygon square = {{{-200, -200}, {200, -200}, {200, 200}, {-200, 200}}, {}};
  const Drawing drawing = {.areas = {{"park", {square}}, {"pond", {{{{300, 300}, {350, 300}, {350, 350}}, {}}}}},
                           .lines = {{{{-400, 0}, {400, 0}}, 0, false}},
                           .crs = {}};
  const Mask drawn = select(terrain, {ByArea{.polygons = {square}, .falloff_m = 80}});
  const auto from = [&](const Criterion& c) {
    return mask({.terrain = terrain, .drawing = &drawing}, {.criteria = {c}}, {}, {});
  };
  EXPECT_EQ(from(ByArea{.feature = "park", .falloff_m = 80}), drawn);
  EXPECT_NE(from(ByArea{.falloff_m = 80}), drawn);
  EXPECT_EQ(drawn(40, 40), 1);
  EXPECT_NEAR(drawn(63, 40), soft_range(35, {}, 0, 80), 1e-5);  // 35 m beyond the border
  EXPECT_EQ(from(ByLine{}), select(terrain, {ByLine{.points = {{-400, 0}, {400, 0}}}}));
  EXPECT_NEAR(from(ByLine{})(40, 50), soft_range(105, {}, 0, 200), 1e-5);
  EXPECT_THROW(from(ByArea{.feature = "lake"}), InvalidArgument);
}

TEST(Mask, ClosedLinesAreAreasWhereThereAreNone) {
  const HeightField terrain = hills();
  const Ring ring = {{-300, -300}, {300, -300}, {300, 300}, {-300, 300}};
  Drawing areas, lines;
  areas.areas = {{"a", {{ring, {}}}}};
  lines.lines = {{ring, 0, true, {}}};
  const MaskParams params{.criteria = {ByArea{}}};
  EXPECT_EQ(mask({terrain, nullptr, &lines}, params, {}, {}), mask({terrain, nullptr, &areas}, params, {}, {}));
}

TEST(Mask, NoiseCoversItsShareAndHangsOnTheSeed) {
  const HeightField terrain(GridFrame::centred(400, 400, 20.0), 0.0F);
  for (const double coverage : {0.2, 0.5, 0.8}) {
    const Mask clouds = select(terrain, {ByNoise{.coverage = coverage, .wavelength_m = 400}});
    double sum = 0;
    for (const float w : clouds.cells()) sum += w;
    EXPECT_NEAR(sum / static_cast<double>(clouds.size()), coverage, 0.06);
  }
  const MaskParams params{.criteria = {ByNoise{}}};
  EXPECT_NE(mask({terrain}, params, Seed{1}, {}), mask({terrain}, params, Seed{2}, {}));
  EXPECT_EQ(select(terrain, {ByNoise{.coverage = 0}}), Mask(terrain.frame(), 0.0F));
  // Two criteria of one mask are two noises.
  EXPECT_NE(select(terrain, {ByNoise{}, ByNoise{}}, Combine::min), select(terrain, {ByNoise{}}));
}

TEST(Mask, CombinesByProductMinimumAndMaximum) {
  const HeightField terrain = hills();
  const Criterion high = ByHeight{.low_m = 30, .falloff_m = 40}, steep = BySlope{.low_deg = 15, .falloff_deg = 10};
  const Mask a = select(terrain, {high}), b = select(terrain, {steep});
  const Mask both = select(terrain, {high, steep}), least = select(terrain, {high, steep}, Combine::min);
  const Mask any = select(terrain, {high, steep}, Combine::max);
  for (size_t i = 0; i < terrain.size(); ++i) {
    const float x = a.cells()[i], y = b.cells()[i];
    ASSERT_EQ(both.cells()[i], x * y);
    ASSERT_EQ(least.cells()[i], std::min(x, y));
    ASSERT_EQ(any.cells()[i], std::max(x, y));
  }
  // A mask that is put in counts like a criterion, so masks nest.
  EXPECT_EQ(mask({.terrain = terrain, .mask = &a}, {.criteria = {steep}}, Seed{1}, {}), both);
}

TEST(Mask, InvertingIsOneMinus) {
  const HeightField terrain = hills();
  const Mask some = select(terrain, {ByHeight{.low_m = 30, .falloff_m = 40}});
  const Mask rest = select(terrain, {ByHeight{.low_m = 30, .falloff_m = 40, .invert = true}});
  for (size_t i = 0; i < terrain.size(); ++i) ASSERT_NEAR(some.cells()[i] + rest.cells()[i], 1.0F, 1e-6);
}

TEST(Mask, LowAndHighAreWhatUnselectedAndSelectedGroundGets) {
  const HeightField terrain = hills();
  const std::vector<Criterion> high = {ByHeight{.low_m = 30, .falloff_m = 40}};
  const Mask share = select(terrain, high);
  for (const auto& [low, top] : {std::pair{1.0, 10.0}, {10.0, 0.25}, {-3.0, -3.0}}) {
    const Mask made = mask({.terrain = terrain}, {.criteria = high, .low = low, .high = top}, Seed{1}, {});
    for (size_t i = 0; i < share.size(); ++i) {
      const float w = share.cells()[i];
      ASSERT_NEAR(made.cells()[i], low + w * (top - low), 1e-5);
      if (w == 0.0F || w == 1.0F) {
        ASSERT_EQ(made.cells()[i], static_cast<float>(w == 0.0F ? low : top));
      }
    }
  }
}

TEST(Mask, SelectsByAnyField) {
  const HeightField terrain = hills();
  ScalarField flow(terrain.frame());
  for (size_t i = 0; i < flow.size(); ++i) flow.cells()[i] = static_cast<float>(i);
  const Mask wet = mask({.terrain = terrain, .values = &flow},
                        {.criteria = {ByValue{.low = 100, .high = 200, .falloff = 50}}}, {}, {});
  for (size_t i = 0; i < 400; ++i) ASSERT_NEAR(wet.cells()[i], soft_range(static_cast<double>(i), 100, 200, 50), 1e-6);
}

TEST(Mask, SaysWhatIsMissingAndWhatDoesNotFit) {
  const HeightField terrain = hills();
  const auto message = [&](const Criterion& c) -> std::string {
    try {
      select(terrain, {ByHeight{}, c});
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(ByRegion{}), "criteria[1]: selects by region, but the input 'labels' is open: connect a label map");
  EXPECT_EQ(message(ByHeight{.low_m = 5, .high_m = 2}), "criteria[1].low: 5 is above high = 2");
  EXPECT_EQ(message(ByLine{.points = {{0, 0}}}), "criteria[1].points: a line needs two points");
  EXPECT_NE(message(ByValue{}), "");
  const LabelMap small(GridFrame::centred(8, 8, 10), Region::reef);
  EXPECT_THROW(mask({.terrain = terrain, .labels = &small}, {}, {}, {}), IncompatibleInputs);
}

TEST(Mask, SameBytesForAnyNumberOfThreadsAndOddShapes) {
  const MaskParams params{.criteria = {ByNoise{}, BySlope{.low_deg = 10}, ByAspect{}, ByCurvature{}}};
  const HeightField terrain = hills(300, 310);
  EXPECT_EQ(mask({terrain}, params, Seed{1}, {.threads = 1}), mask({terrain}, params, Seed{1}, {.threads = 3}));
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {7, 1}}) {
    const Mask tiny = mask({hills(width, height)}, params, Seed{1}, {});
    for (const float w : tiny.cells()) EXPECT_TRUE(w >= 0 && w <= 1);
  }
}

TEST(Mask, ACoarseMaskIsTheFineOneAveraged) {
  const auto at = [](double cell) {
    const auto side = static_cast<int>(std::lround(6400 / cell));
    HeightField terrain =
        geom::fbm_grid(GridFrame::centred(side, side, cell), Seed{3}, {.wavelength_m = 2400, .cell_m = cell}, {});
    for (float& z : terrain.cells()) z *= 500.0F;
    return mask({terrain},
                {.criteria = {BySlope{.low_deg = 12, .falloff_deg = 8, .scale_m = 200}, ByCurvature{.scale_m = 300}}},
                Seed{1}, {});
  };
  const Mask fine = at(10), coarse = at(40);
  double difference = 0;
  for (int y = 0; y < coarse.height(); ++y) {
    for (int x = 0; x < coarse.width(); ++x) {
      double sum = 0;
      for (int i = 0; i < 16; ++i) sum += fine(4 * x + i % 4, 4 * y + i / 4);
      difference += std::abs(sum / 16 - coarse(x, y));
    }
  }
  EXPECT_LT(difference / static_cast<double>(coarse.size()), 0.03);
}

/// Nothing is selected where nothing is known, whatever the criteria, and the rim of a hole is no cliff.
TEST(Mask, UnknownCellsAreNotSelected) {
  HeightField terrain(GridFrame::centred(60, 50, 10.0));
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 60; ++x) terrain(x, y) = static_cast<float>(3 * x);  // 17 degrees everywhere
  for (int y = 20; y < 30; ++y)
    for (int x = 20; x < 40; ++x) terrain(x, y) = std::numeric_limits<float>::quiet_NaN();
  MaskParams params;
  BySlope steep;
  steep.low_deg = 25;
  steep.falloff_deg = 0;
  params.criteria = {steep};
  const Mask cliffs = mask({terrain, nullptr, nullptr, nullptr, nullptr}, params, Seed{1}, {});
  for (const float w : cliffs.cells()) ASSERT_EQ(w, 0.0F);
  params.invert = true;
  const Mask gentle = mask({terrain, nullptr, nullptr, nullptr, nullptr}, params, Seed{1}, {});
  for (size_t i = 0; i < gentle.size(); ++i) ASSERT_EQ(gentle.cells()[i], std::isnan(terrain.cells()[i]) ? 0.0F : 1.0F);
}

}  // namespace
}  // namespace seamount::terrain
