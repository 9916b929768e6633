// A coarse grid is a preview of a fine one: build, wind and coral at 128 against 1024 averaged down.
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/grid/resample.h"
#include "seamount/ops/island/build.h"
#include "seamount/ops/island/coral.h"
#include "seamount/ops/island/wind.h"

namespace seamount::island {
namespace {

struct Stages {
  HeightField built, blown, reefed;
};

Stages make(const Plan& plan, int size) {
  const GridFrame frame = GridFrame::centred(size, size, 16384.0 / size);
  Island isle = build(plan, {}, frame, Seed{8}, {});
  const WindParams strokes{.strokes = {{{{-6000, 2000}, {0, 1200}, {6000, 2800}}, 900, 500}},
                           .radial_count = 16,
                           .radial_width_m = 420,
                           .radial_strength_m = 300};
  Warped blown = wind(isle.terrain, &isle.labels, &isle.coordinate, strokes, Seed{8}, {});
  Reefed reefed =
      coral(blown.terrain, blown.labels, &blown.coordinate, {.subsidence = 0.15, .pass_width_m = 600}, Seed{8}, {});
  return {std::move(isle.terrain), std::move(blown.terrain), std::move(reefed.terrain)};
}

/// Root mean square difference over that of the fine result, both where `counts` holds for the fine one.
template <class Counts>
double difference(const HeightField& coarse, const HeightField& fine, Counts counts) {
  const Grid<float> mean = geom::box_downsample(fine, fine.width() / coarse.width(), {});
  double error = 0, all = 0;
  for (size_t c = 0; c < coarse.size(); ++c) {
    if (!counts(mean.cells()[c])) continue;
    error += std::pow(coarse.cells()[c] - mean.cells()[c], 2);
    all += std::pow(mean.cells()[c], 2);
  }
  return std::sqrt(error / all);
}

class Preview : public ::testing::TestWithParam<bool> {
 protected:
  static Plan plan(bool polar) {
    if (polar) return plan_from_polar({{{3600, 4400, 3300, 3900, 4600}}}, {}, {});
    const Polygon coast{
        {{-4500, -2500}, {-1000, -3600}, {3800, -2600}, {4300, 500}, {1500, 300}, {1200, 3000}, {-2800, 3300}}, {}};
    return plan_from_areas({{{"", {coast}}}, {}, {}}, {}, "areas");
  }
};

TEST_P(Preview, ShowsWhatTheFineResultWillBe) {
  const Stages coarse = make(plan(GetParam()), 128);
  const Stages fine = make(plan(GetParam()), 1024);
  const auto land = [](float z) { return z > 0; };
  const auto sea = [](float z) { return z < -40; };
  for (const auto& [a, b, name] : {std::tuple{&coarse.built, &fine.built, "build"},
                                   {&coarse.blown, &fine.blown, "wind"},
                                   {&coarse.reefed, &fine.reefed, "coral"}}) {
    EXPECT_LT(difference(*a, *b, land), 0.1) << name;
    EXPECT_LT(difference(*a, *b, sea), 0.05) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Plans, Preview, ::testing::Bool(),
                         [](const auto& row) { return row.param ? "polar" : "areas"; });

}  // namespace
}  // namespace seamount::island
