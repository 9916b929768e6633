// Where reefs grow without being told: in the light, on a known sea floor, under the sea.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "seamount/ops/reef/grow.h"
#include "seamount/ops/reef/pieces.h"

namespace seamount::reef {
namespace {

/// An island of 300 m on a flank that falls to -600 m, with a hollow at -20 m inland and noise of the sea bed.
HeightField island(int cells, double cell_m, double steepness) {
  HeightField field(GridFrame::centred(cells, cells, cell_m));
  const double side = cells * cell_m;
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      const double px = field.frame().x(x) / side, py = field.frame().y(y) / side;
      const double r = std::sqrt(px * px + py * py) * (1.0 + 0.1 * std::sin(5 * std::atan2(py, px)));
      const double z = r < 0.2 ? 300.0 - 1500.0 * r : -steepness * (r - 0.2) * side;
      field(x, y) = static_cast<float>(r < 0.05 ? -20.0 : z);
    }
  }
  return field;
}

TEST(ReefLight, NothingGrowsOnLandInHollowsOrInTheDark) {
  for (const uint64_t seed : {1, 2, 3}) {
    for (const auto& [cell_m, steepness] : {std::pair{25.0, 0.03}, {60.0, 0.05}, {300.0, 0.01}}) {
      const HeightField base = island(200, cell_m, steepness);
      GrowParams p;
      const Grown grown = grow({base}, p, Seed{seed}, {});
      double reef = 0;
      for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 200; ++x) {
          const float z0 = base(x, y), a = grown.aggregate(x, y);
          reef += static_cast<double>(a);
          const bool inland = std::hypot(x - 99.5, y - 99.5) < 200 * 0.15;
          if (z0 >= 0 || inland) {
            ASSERT_EQ(a, 0.0F) << cell_m << ": land at " << x << " " << y;
            ASSERT_EQ(grown.terrain(x, y), z0);
            ASSERT_NE(grown.labels(x, y), Region::reef);
          }
          if (z0 < -1.15F * static_cast<float>(p.bounds.light_depth_m)) {
            ASSERT_EQ(a, 0.0F) << cell_m << ": dark at " << z0;
          }
        }
      }
      EXPECT_GT(reef * cell_m * cell_m, 0.05e6) << "there is one, cells of " << cell_m;
    }
  }
}

TEST(ReefLight, ClearWaterHasDeeperReefs) {
  const HeightField base = island(200, 40, 0.02);
  float deepest[2];
  for (const int clear : {0, 1}) {
    GrowParams p;
    p.bounds.light_depth_m = clear != 0 ? 60 : 12;
    const Grown grown = grow({base}, p, Seed{5}, {});
    deepest[clear] = 0;
    for (size_t i = 0; i < base.size(); ++i)
      if (grown.aggregate.cells()[i] >= 0.5F) deepest[clear] = std::min(deepest[clear], base.cells()[i]);
  }
  EXPECT_GT(deepest[0], -14.0F);
  EXPECT_LT(deepest[1], -35.0F);
}

TEST(ReefLight, UnknownGroundStaysUnknownAndBare) {
  HeightField base(GridFrame::centred(200, 200, 20), -20.0F);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 80; ++x) base(x, y) = std::numeric_limits<float>::quiet_NaN();
  GrowParams p;
  p.finish.blur_m = 30;
  const Grown grown = grow({base}, p, Seed{1}, {});
  double reef = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      ASSERT_EQ(std::isnan(grown.terrain(x, y)), x < 80);
      if (x < 80) {
        ASSERT_EQ(grown.aggregate(x, y), 0.0F);
      }
      reef += static_cast<double>(grown.aggregate(x, y));
    }
  }
  EXPECT_GT(reef, 500);
}

TEST(ReefLight, SaysWhyThereIsNoHabitat) {
  const auto message = [](const HeightField& base) -> std::string {
    try {
      grow({base}, {}, Seed{1}, {});
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  const HeightField deep(GridFrame::centred(100, 100, 20), -300.0F), land(GridFrame::centred(100, 100, 20), 7.0F);
  HeightField model(GridFrame::centred(100, 100, 20), 0.0F);
  for (int x = 30; x < 60; ++x) model(x, 50) = 90.0F;
  EXPECT_NE(message(deep).find("bounds.light_depth_m"), std::string::npos) << message(deep);
  EXPECT_NE(message(land).find("no sea floor"), std::string::npos) << message(land);
  EXPECT_NE(message(model).find("terrain.sea_floor"), std::string::npos) << message(model);
}

TEST(ReefLight, CoarseTerrainsHaveALatticeThatFits) {
  for (const double cell_m : {500.0, 3500.0}) {
    HeightField base(GridFrame::centred(150, 90, cell_m), -20.0F);
    std::string said;
    RunContext run;
    run.note = [&](const std::string& line) { said += line; };
    const Grown grown = grow({base}, {}, Seed{1}, run);
    EXPECT_NE(said.find("lattice_m"), std::string::npos);
    double reef = 0;
    for (const float a : grown.aggregate.cells()) reef += static_cast<double>(a);
    EXPECT_GT(reef, 100);
  }
}

TEST(ReefLight, EachPieceOfHabitatHasAStart) {
  Grid<uint8_t> habitat(GridFrame::centred(120, 120, 1.0), 0);
  const auto fill = [&](int x0, int y0, int size) {
    for (int y = y0; y < y0 + size; ++y)
      for (int x = x0; x < x0 + size; ++x) habitat(x, y) = 1;
  };
  fill(10, 10, 20), fill(70, 70, 20), fill(90, 10, 1);
  const std::vector<LatticeCell> starts = starts_of_pieces(habitat, Seed{1});
  ASSERT_EQ(starts.size(), 2U) << "one cell is no piece";
  EXPECT_EQ(starts[0], (LatticeCell{29, 29})) << "nearest to the middle";
  EXPECT_EQ(starts[1], (LatticeCell{70, 70}));
  EXPECT_TRUE(starts_of_pieces(Grid<uint8_t>(habitat.frame(), 0), Seed{1}).empty());
  const Grid<uint8_t> wide(GridFrame::centred(600, 300, 1.0), 1);
  EXPECT_EQ(starts_of_pieces(wide, Seed{1}).size(), 8U);
}

}  // namespace
}  // namespace seamount::reef
