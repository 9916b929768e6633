// P0 eq. 1.2 and 1.16, Algorithm 1 part 1, and the laws that islands keep.
#include "seamount/ops/island/build.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "seamount/base/error.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/island/archipelago.h"
#include "seamount/ops/island/choose_plan.h"
#include "seamount/ops/island/coordinate.h"
#include "seamount/ops/island/outlines.h"

namespace seamount::island {
namespace {

/// Nothing but the paper: no detail, valleys or noise.
BuildParams plain() {
  return {.massif = 0.0, .relief = 0.0, .detail = {.coast_m = 0.0, .width_variation = 0.0, .noise_m = 0.0}};
}

TEST(Build, HeightIsTheProfileOfTheCoordinate) {
  BuildParams params = plain();
  params.profile = {{{0, 900}, {1, 30}, {2, 0}, {3, -12}, {4, -30}, {5, -800}}};
  params.interpolation = Interpolation::linear;
  const Plan plan = plan_from_polar({{{2000}}, {{2300}}, {{3200}}, {{3900}}, {{6000}}}, {}, {});
  const Island isle = build(plan, params, GridFrame::centred(129, 129, 100), Seed{1}, {});
  const auto linear = [&](double x) {
    const auto& k = params.profile.knots;
    const auto i = std::min<size_t>(4, static_cast<size_t>(x));
    return k[i].y + (x - static_cast<double>(i)) * (k[i + 1].y - k[i].y);
  };
  for (size_t c = 0; c < isle.terrain.size(); ++c) {
    ASSERT_NEAR(isle.terrain.cells()[c], linear(isle.coordinate.cells()[c]), 0.4);
    ASSERT_EQ(static_cast<int>(isle.labels.cells()[c]), std::min(4, static_cast<int>(isle.coordinate.cells()[c])));
  }
  EXPECT_NEAR(isle.terrain(64, 64), 900, 1);
  EXPECT_NEAR(isle.terrain(64 + 23, 64), 0, 0.5);  // the coast, at 2300 m
}

TEST(Build, CoastStaysWhereItIsUnderNoiseAndValleys) {
  const Plan plan = plan_from_polar({{{3000}}}, {}, {});
  BuildParams params = plain();
  params.relief = 1.0;
  params.detail.noise_m = 8.0;
  const Island isle = build(plan, params, GridFrame::centred(256, 256, 45), Seed{4}, {});
  int wrong = 0;
  for (size_t c = 0; c < isle.terrain.size(); ++c) {
    const bool land = isle.coordinate.cells()[c] < 2.0F;
    wrong += land != (isle.terrain.cells()[c] > 0.0F) ? 1 : 0;
  }
  EXPECT_LT(wrong, 60);  // of 65536: cells that the coast itself crosses
}

TEST(Build, LandDoesNotDipBelowTheSeaAndStaysFinite) {
  for (const uint64_t seed : {1, 2, 3, 4}) {
    const GridFrame frame = GridFrame::centred(200, 150, 60);
    const Island isle = build(random_plan(frame, {}, 0.6, Seed{seed}, {}), {}, frame, Seed{seed}, {});
    for (size_t c = 0; c < isle.terrain.size(); ++c) {
      ASSERT_TRUE(std::isfinite(isle.terrain.cells()[c]));
      ASSERT_GT(isle.terrain.cells()[c], isle.labels.cells()[c] == Region::mountain ? -1.0F : -3000.0F);
    }
  }
}

TEST(Build, PreviewIsTheFineResultAveraged) {
  const Plan plan = plan_from_polar({{{3000, 3600, 2800, 3300, 3900}}}, {}, {});
  const Island coarse = build(plan, {}, GridFrame::centred(128, 128, 96), Seed{6}, {});
  const Island fine = build(plan, {}, GridFrame::centred(1024, 1024, 12), Seed{6}, {});
  double error = 0, relief = 0;
  int land = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      double mean = 0;
      for (int j = 0; j < 8; ++j) {
        for (int i = 0; i < 8; ++i) mean += fine.terrain(8 * x + i, 8 * y + j) / 64.0;
      }
      if (mean <= 0) continue;
      ++land;
      error += std::pow(coarse.terrain(x, y) - mean, 2);
      relief += mean * mean;
    }
  }
  EXPECT_LT(std::sqrt(error / land), 0.06 * std::sqrt(relief / land));
}

TEST(Build, SameBytesOnAnyNumberOfThreadsAndAnotherSeedDiffers) {
  const GridFrame frame = GridFrame::centred(173, 211, 50);
  const Plan plan = random_plan(frame, {}, 0.4, Seed{1}, {});
  const Island one = build(plan, {}, frame, Seed{1}, {.threads = 1});
  const Island many = build(plan, {}, frame, Seed{1}, {.threads = 3});
  EXPECT_EQ(one.terrain, many.terrain);
  EXPECT_EQ(one.labels, many.labels);
  EXPECT_NE(one.terrain, build(plan, {}, frame, Seed{2}, {}).terrain);
}

TEST(Build, SinksAsThePaintingsBrightnessSays) {
  const GridFrame frame = GridFrame::centred(160, 160, 80);
  LabelMap labels(frame, Region::abyss);
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) {
      const double r = std::hypot(x - 80, y - 80);
      labels(x, y) = r < 38   ? Region::mountain
                     : r < 40 ? Region::beach
                     : r < 50 ? Region::lagoon
                     : r < 56 ? Region::reef
                              : Region::abyss;
    }
  }
  BuildParams params;
  params.coast.path = "painted.png";
  const auto painted = [&](float lambda) {
    const auto read = [&](const FilePath&) -> CoastFile {
      return PaintedCoast{labels, lambda > 0 ? ScalarField(frame, lambda) : ScalarField()};
    };
    return build({.read_coast = read}, params, frame, Seed{3}, {});
  };
  const Island before = painted(0.0F), after = painted(0.4F);
  EXPECT_EQ(before.labels, after.labels);
  const float floor = *std::min_element(before.terrain.cells().begin(), before.terrain.cells().end());
  for (size_t c = 0; c < before.terrain.size(); ++c) {
    const float expected = floor + 0.6F * (before.terrain.cells()[c] - floor);
    ASSERT_NEAR(after.terrain.cells()[c], expected, 0.01F);
  }
}

TEST(Build, TinyAndThinFramesWork) {
  const Plan plan = plan_from_polar({{{0.2}}}, {}, {});
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 9}, {9, 1}}) {
    const Island isle = build(plan, {.floor_m = -100.0}, GridFrame::centred(w, h, 1.0), Seed{1}, {});
    for (const float z : isle.terrain.cells()) EXPECT_TRUE(std::isfinite(z));
  }
}

TEST(RandomPlan, IsEquation1_16) {
  // r(theta) = r* + eta(theta): without irregularity a circle, with it a closed curve around it.
  const GridFrame frame = GridFrame::centred(100, 100, 100);
  const Plan circle = random_plan(frame, {}, 0.0, Seed{3}, {});
  for (const double r : circle.polar[kCoast].radii_m) EXPECT_NEAR(r, 2600, 1e-6);
  const Plan coast = random_plan(frame, {}, 0.4, Seed{3}, {});
  const auto& radii = coast.polar[kCoast].radii_m;
  for (size_t i = 0; i < radii.size(); i += 37) {
    const double theta = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(radii.size());
    EXPECT_NEAR(radii[i], 2600 * (1 + 0.4 * geom::fbm_circle(Seed{3}.derive("island.coast"), theta, 3.0, 5)), 1e-6);
  }
  double mean = 0, largest_step = 0;
  for (size_t i = 0; i < radii.size(); ++i) {
    mean += radii[i] / static_cast<double>(radii.size());
    largest_step = std::max(largest_step, std::abs(radii[i] - radii[(i + 1) % radii.size()]));
  }
  EXPECT_NEAR(mean, 2600, 400);
  EXPECT_LT(largest_step, 120);  // no seam at angle 0
}

TEST(Outlines, LeadBackToTheSameIsland) {
  const GridFrame frame = GridFrame::centred(256, 256, 50);
  const Plan plan = plan_from_polar({{{3000, 3500, 2600, 3200}}}, {},
                                    {.beach_m = 250, .lagoon_m = 600, .reef_m = 500, .slope_m = 1500});
  const Island isle = build(plan, plain(), frame, Seed{1}, {});
  const Drawing drawn = outlines(isle.labels, {}, {});
  ASSERT_EQ(drawn.areas.size(), 4U);
  const Island again = build(plan_from_areas(drawn, {.slope_m = 1500}, "outlines"), plain(), frame, Seed{1}, {});
  int same = 0;
  for (size_t c = 0; c < isle.labels.size(); ++c) same += isle.labels.cells()[c] == again.labels.cells()[c] ? 1 : 0;
  EXPECT_GT(same, static_cast<int>(0.985 * static_cast<double>(isle.labels.size())));
}

TEST(Outlines, OfRegionsNarrowerThanACellStillLeadBack) {
  // A beach of 30 m on cells of 160 m: the traced outlines of mountain and beach touch each other.
  const GridFrame frame = GridFrame::centred(64, 64, 160);
  const Plan plan = plan_from_polar({{{2400}}}, {}, {.beach_m = 30, .lagoon_m = 60, .reef_m = 700, .slope_m = 1200});
  const Island isle = build(plan, plain(), frame, Seed{1}, {});
  const Drawing drawn = outlines(isle.labels, {}, {});
  const Island again = build(plan_from_areas(drawn, {}, "outlines"), plain(), frame, Seed{1}, {});
  int same = 0;
  for (size_t c = 0; c < isle.labels.size(); ++c) {
    same += isle.labels.cells()[c] == again.labels.cells()[c] ? 1 : 0;
  }
  EXPECT_GT(same, static_cast<int>(0.95 * static_cast<double>(isle.labels.size())));
}

TEST(Archipelago, BlendsHeightsAndKeepsTheHigherLabel) {
  EXPECT_EQ(prior_label(Region::mountain, Region::beach), Region::mountain);
  EXPECT_EQ(prior_label(Region::abyss, Region::reef), Region::reef);
  EXPECT_EQ(prior_label(Region::lagoon, Region::beach), Region::beach);
  const GridFrame small = GridFrame::centred(128, 128, 50);
  const Island isle = build(plan_from_polar({{{1200}}}, {}, {}), plain(), small, Seed{1}, {});
  const GridFrame frame = GridFrame::centred(300, 200, 50);
  const ArchipelagoParams params{.places = {{-2500, 0}, {3000, 600}}, .turns_deg = {90}, .scales = {1, 0.8}};
  const Archipelago sea = archipelago({{&isle.terrain, &isle.labels}}, params, frame, {});
  const auto at = [&](double x, double y) {
    return sea.terrain(static_cast<int>(std::lround(frame.column(x))), static_cast<int>(std::lround(frame.row(y))));
  };
  EXPECT_NEAR(at(-2500, 0), isle.terrain(64, 64), 30);
  EXPECT_NEAR(at(3000, 600), 0.8 * isle.terrain(64, 64), 30);
  EXPECT_LT(at(7000, -4500), -100);
  EXPECT_THROW(archipelago({{&isle.terrain, nullptr}, {&isle.terrain, nullptr}}, {.places = {{0, 0}}}, frame, {}),
               InvalidArgument);
}

TEST(Archipelago, OneIslandInItsPlaceIsItself) {
  const GridFrame frame = GridFrame::centred(96, 96, 50);
  const Island isle = build(plan_from_polar({{{1000}}}, {}, {}), plain(), frame, Seed{1}, {});
  const Archipelago alone = archipelago({{&isle.terrain, &isle.labels}}, {}, frame, {});
  EXPECT_EQ(alone.labels, isle.labels);
  for (size_t c = 0; c < isle.terrain.size(); ++c) ASSERT_NEAR(alone.terrain.cells()[c], isle.terrain.cells()[c], 1e-2);
}

}  // namespace
}  // namespace seamount::island
