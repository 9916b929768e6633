#include "seamount/ops/amplify/sparse.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/amplify/atom_detail.h"
#include "seamount/ops/amplify/test_dictionary.h"

namespace seamount::amplify {
namespace {

/// An archipelago around `lift` metres.
HeightField ground(int width, int height, uint64_t seed, double lift = 200.0) {
  HeightField terrain =
      geom::fbm_grid(GridFrame::centred(width, height, 60.0), Seed{seed}, {.wavelength_m = 900.0}, {});
  for (float& z : terrain.cells()) z = 800.0F * z + static_cast<float>(lift);
  return terrain;
}

constexpr std::array kFactors = {std::pair{Factor::x2, 2}, std::pair{Factor::x4, 4}, std::pair{Factor::x8, 8}};

TEST(AmplifySparse, MeansOfTheResultAreTheTerrain) {
  const Dictionary dictionary = random_dictionary(64, 1);
  for (const auto& [width, height] : {std::pair{41, 30}, {1, 1}, {1, 7}, {2, 3}, {6, 1}}) {
    for (const auto& [factor, times] : kFactors) {
      const HeightField terrain = ground(width, height, 2);
      const HeightField fine = sparse(terrain, dictionary, {.factor = factor}, {});
      ASSERT_EQ(fine.width(), times * width);
      const HeightField means = geom::box_downsample(fine, times, {});
      for (size_t i = 0; i < terrain.size(); ++i) ASSERT_NEAR(means.data()[i], terrain.data()[i], 1e-3);
    }
  }
}

TEST(AmplifySparse, CoversTheSameGround) {
  GridFrame frame = ground(20, 12, 1).frame();
  frame.west_m = 500030.0;
  frame.north_m = 4100000.0;
  frame.crs = "EPSG:32631";
  HeightField terrain = ground(20, 12, 1);
  terrain.set_frame(frame);
  const GridFrame fine = sparse(terrain, random_dictionary(16, 1), {.factor = Factor::x8}, {}).frame();
  EXPECT_EQ(fine.cell_m, 7.5);
  EXPECT_EQ(fine.west_m, frame.west_m);
  EXPECT_EQ(fine.north_m, frame.north_m);
  EXPECT_EQ(fine.east_m(), frame.east_m());
  EXPECT_EQ(fine.south_m(), frame.south_m());
  EXPECT_EQ(fine.crs, frame.crs);
}

/// The blend of atoms, cell by cell as it is defined.
TEST(AmplifySparse, DetailIsTheBlendOfNearestAtoms) {
  const Dictionary dictionary = random_dictionary(50, 8);
  const HeightField terrain = ground(11, 8, 3);
  const auto beyond = [&](int x, int y) {
    const auto along = [](int i, int n) {
      return i < 0 ? std::min(-i, n - 1) : i < n ? i : std::max(0, 2 * n - 2 - i);
    };
    const auto row = [&](int column) {
      const int edge = std::clamp(y, 0, 7);
      return y == edge ? terrain(column, y) : 2.0F * terrain(column, edge) - terrain(column, along(y, 8));
    };
    const int edge = std::clamp(x, 0, 10);
    return x == edge ? row(x) : 2.0F * row(edge) - row(along(x, 11));
  };
  std::vector<double> wanted(22 * 16, 0.0);
  for (int j = -2; j < 8; j += 2) {
    for (int i = -2; i < 11; i += 2) {
      std::array<float, kShape * kShape> cells;
      for (int k = 0; k < kShape * kShape; ++k) cells[k] = beyond(i - 1 + k % kShape, j - 1 + k / kShape);
      const Shape shape = describe_shape(cells.data(), kShape);
      size_t best = 0;
      double most = -2.0;
      for (size_t a = 0; a < dictionary.shapes.size(); ++a) {
        double product = 0.0;
        for (int f = 0; f < kFeatures; ++f) product += shape.features[f] * dictionary.shapes[a][f];
        if (product > most) {
          most = product;
          best = a;
        }
      }
      for (int k = 0; k < kDetail * kDetail; ++k) {
        const auto [east, south] = on_ground(shape.turn, k % kDetail, k / kDetail, kDetail);
        const int x = 2 * i + east, y = 2 * j + south;
        if (x < 0 || y < 0 || x >= 22 || y >= 16) continue;
        const auto fade = [](int at) { return std::pow(std::sin(M_PI * (at + 0.5) / kDetail), 2); };
        wanted[22 * y + x] +=
            0.7 * fade(east) * fade(south) * shape.relief_m * std::max(0.0, most) * dictionary.details[best][k];
      }
    }
  }
  const Grid<float> made = AtomDetail(dictionary, 0.7).of(terrain, {});
  for (size_t i = 0; i < wanted.size(); ++i) ASSERT_NEAR(made.data()[i], wanted[i], 1e-2) << i;
}

TEST(AmplifySparse, LandAndSeaKeepTheirSidesButAtTheCoast) {
  for (const uint64_t seed : {1, 2, 3}) {
    const HeightField terrain = ground(50, 40, seed, 60.0);
    const HeightField fine = sparse(terrain, random_dictionary(64, seed), {.strength = 2.0}, {});
    int coasts = 0;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 50; ++x) {
        bool land = true, sea = true;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            land = land && terrain.clamped(x + dx, y + dy) > 0.0F;
            sea = sea && terrain.clamped(x + dx, y + dy) <= 0.0F;
          }
        }
        if (!land && !sea) ++coasts;
        for (int k = 0; k < 16; ++k) {
          const float z = fine(4 * x + k % 4, 4 * y + k / 4);
          ASSERT_TRUE((!land || z > 0.0F) && (!sea || z <= 0.0F)) << x << " " << y << ": " << z;
        }
      }
    }
    EXPECT_GT(coasts, 100);
  }
}

TEST(AmplifySparse, FlatWaterStaysFlat) {
  HeightField terrain = ground(40, 40, 4, 900.0);
  for (int y = 10; y < 20; ++y)
    for (int x = 15; x < 30; ++x) terrain(x, y) = 350.0F;
  const HeightField fine = sparse(terrain, random_dictionary(64, 5), {.factor = Factor::x8}, {});
  for (int y = 8 * 11; y < 8 * 19; ++y)
    for (int x = 8 * 16; x < 8 * 29; ++x) ASSERT_EQ(fine(x, y), 350.0F);
  EXPECT_NE(fine(8 * 30 + 3, 8 * 15), terrain(30, 15));
}

TEST(AmplifySparse, UnknownCellsStayUnknownAndNoOthersBecomeSo) {
  HeightField terrain = ground(30, 20, 6);
  for (const auto& [x, y] : {std::pair{0, 0}, {12, 7}, {13, 7}, {29, 10}}) terrain(x, y) = NAN;
  const HeightField fine = sparse(terrain, random_dictionary(32, 5), {}, {});
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 120; ++x) ASSERT_EQ(std::isnan(fine(x, y)), std::isnan(terrain(x / 4, y / 4)));
  const HeightField nothing = sparse(HeightField(terrain.frame(), NAN), random_dictionary(32, 5), {}, {});
  EXPECT_EQ(nothing.width(), 120);
  EXPECT_TRUE(std::isnan(nothing(60, 40)));
}

TEST(AmplifySparse, StrengthScalesTheDetail) {
  const HeightField terrain = ground(32, 32, 7, 2000.0);
  const Dictionary dictionary = random_dictionary(64, 5);
  const auto made = [&](double strength) {
    return sparse(terrain, dictionary, {.factor = Factor::x2, .strength = strength}, {});
  };
  const HeightField none = made(0.0), half = made(0.5), whole = made(1.0);
  for (size_t i = 0; i < none.size(); ++i)
    ASSERT_NEAR(whole.data()[i] - none.data()[i], 2.0F * (half.data()[i] - none.data()[i]), 5e-3);
  EXPECT_FALSE(none == whole);
}

/// What lies some cells away does not matter: a piece of a terrain is amplified as in the whole.
TEST(AmplifySparse, SeesOnlyWhatIsNear) {
  const HeightField whole = ground(80, 60, 9);
  GridFrame frame = whole.frame();
  frame.width = 40;
  HeightField west(frame);
  for (int y = 0; y < 60; ++y) std::copy_n(whole.row(y).begin(), 40, west.row(y).begin());
  const Dictionary dictionary = random_dictionary(64, 5);
  const HeightField a = sparse(whole, dictionary, {}, {}), b = sparse(west, dictionary, {}, {});
  constexpr int kReach = 12;  // cells
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 4 * (40 - kReach); ++x) ASSERT_EQ(a(x, y), b(x, y)) << x << " " << y;
}

TEST(AmplifySparse, RefusesWhatItCannotDo) {
  EXPECT_THROW(sparse(HeightField(), random_dictionary(16, 1), {}, {}), InvalidArgument);
  EXPECT_THROW(sparse(ground(4, 4, 1), {}, {}, {}), InvalidArgument);
  EXPECT_THROW(sparse(ground(4, 4, 1), random_dictionary(16, 1), {.strength = 3}, {}), InvalidArgument);
  EXPECT_THROW(sparse(HeightField(GridFrame::centred(17000, 1, 1.0), 0.0F), random_dictionary(16, 1), {}, {}),
               InvalidArgument);
}

}  // namespace
}  // namespace seamount::amplify
