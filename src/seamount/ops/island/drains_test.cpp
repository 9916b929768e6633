// Valleys run to the sea and the coast stays where it was drawn, whatever the parameters.
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/water/flow.h"
#include "seamount/ops/island/build.h"

namespace seamount::island {
namespace {

Polygon rectangle(double w, double h) { return {{{-w, -h}, {w, -h}, {w, h}, {-w, h}}, {}}; }

Polygon star() {
  Polygon out;
  for (int i = 0; i < 10; ++i) {
    const double a = 0.2 + 0.62831853 * i, r = i % 2 == 0 ? 6000.0 : 2400.0;
    out.outer.push_back({r * std::cos(a), r * std::sin(a)});
  }
  return out;
}

struct Drawn {
  const char* name;
  std::vector<Polygon> land;
};

std::vector<Drawn> shapes() {
  return {{"rectangle", {rectangle(6000, 3500)}},
          {"star", {star()}},
          {"L", {{{{-5000, -5000}, {5000, -5000}, {5000, -2500}, {-2000, -2500}, {-2000, 5000}, {-5000, 5000}}, {}}}},
          {"spit",
           {{{{-6000, -2000},
              {-1000, -2000},
              {-1000, -300},
              {6500, -200},
              {6500, 200},
              {-1000, 300},
              {-1000, 2000},
              {-6000, 2000}},
             {}}}},
          {"two islands",
           {{{{-6000, -2000}, {-1500, -2500}, {-1500, 2500}, {-6000, 2000}}, {}},
            {{{2000, -1000}, {6000, -1500}, {5000, 1500}}, {}}}}};
}

/// Cells whose sides of the coast agree with the polygon's at their centre, as intersection over union.
double agreement(const Island& isle, const std::vector<Polygon>& land) {
  int64_t both = 0, either = 0;
  for (int y = 0; y < isle.terrain.height(); ++y) {
    for (int x = 0; x < isle.terrain.width(); ++x) {
      const Vec2 p{isle.terrain.frame().x(x), isle.terrain.frame().y(y)};
      bool inside = false;
      for (const Polygon& polygon : land) inside = inside || geom::contains(polygon, p);
      const bool made = isle.terrain(x, y) > 0.0F;
      both += inside && made ? 1 : 0;
      either += inside || made ? 1 : 0;
    }
  }
  return static_cast<double>(both) / static_cast<double>(either);
}

TEST(DrawnCoast, StaysWhereItWasDrawnByDefault) {
  for (const Drawn& shape : shapes()) {
    for (const double scale : {0.02, 1.0, 30.0}) {
      std::vector<Polygon> land = shape.land;
      for (Polygon& polygon : land)
        for (Vec2& p : polygon.outer) p = scale * p;
      for (const int size : {96, 240}) {
        const GridFrame frame = GridFrame::centred(size, size, scale * 18000.0 / size);
        const Island isle = build(plan_from_areas({{{"", land}}, {}, {}}, {}, "areas"), {}, frame, Seed{5}, {});
        EXPECT_GE(agreement(isle, land), size > 100 ? 0.99 : 0.985) << shape.name << " " << scale << " " << size;
      }
    }
  }
}

TEST(DrawnCoast, DetailThatIsAskedForDoesNotCutNarrowLand) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    const std::vector<Polygon> spit = shapes()[3].land;
    BuildParams params;
    params.detail.coast_m = 900;
    const GridFrame frame = GridFrame::centred(240, 240, 75.0);
    const Island isle = build(plan_from_areas({{{"", spit}}, {}, {}}, {}, "areas"), params, frame, Seed{seed}, {});
    const int row = static_cast<int>(std::lround(frame.row(0)));
    for (double x = -5000; x < 5800; x += 75)
      ASSERT_GT(isle.terrain(static_cast<int>(std::lround(frame.column(x))), row), 0.0F) << seed << " at " << x;
    EXPECT_LT(agreement(isle, spit), 0.99);  // it does something
  }
}

TEST(Valleys, RunToTheSeaWhateverTheParameters) {
  const GridFrame frame = GridFrame::centred(128, 128, 150);
  for (const uint64_t seed : {3U, 14U, 15U}) {
    for (const double relief : {0.5, 1.0, 2.0}) {
      for (const double spacing : {60.0, 1000.0, 6000.0, 60000.0}) {
        for (const bool polar : {true, false}) {
          const Plan plan = polar ? random_plan(frame, {}, 0.6, Seed{seed}, {})
                                  : plan_from_areas({{{"", {star()}}}, {}, {}}, {}, "areas");
          BuildParams params{.massif = 1.0, .relief = relief};
          params.detail.valley_spacing_m = spacing;
          params.detail.noise_m = 12.0;
          const Island isle = build(plan, params, frame, Seed{seed}, {});
          const HeightField filled = geom::fill_depressions(isle.terrain, 0.0F, {});
          float deepest = 0.0F;
          for (size_t c = 0; c < filled.size(); ++c)
            deepest = std::max(deepest, filled.cells()[c] - isle.terrain.cells()[c]);
          EXPECT_EQ(deepest, 0.0F) << "seed " << seed << " relief " << relief << " spacing " << spacing << polar;
        }
      }
    }
  }
}

}  // namespace
}  // namespace seamount::island
