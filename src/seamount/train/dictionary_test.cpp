#include "seamount/train/dictionary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/amplify/sparse.h"
#include "seamount/train/detail_measures.h"
#include "seamount/train/dictionary_pieces.h"

namespace seamount::train {
namespace {

/// Ridges with detail down to the cell.
HeightField ridges(int cells, uint64_t seed) {
  HeightField terrain =
      geom::ridged_grid(GridFrame::centred(cells, cells, 30.0), Seed{seed}, {.wavelength_m = 2500.0, .octaves = 7}, {});
  for (float& z : terrain.cells()) z = 900.0F * z + 400.0F;
  return terrain;
}

DictionaryParams small() { return {.atoms = 200, .pieces = 6000, .least_detail_m = 0.1}; }

TEST(LearnDictionary, BringsBackTheDetailOfTheSameKindOfGround) {
  const std::vector<HeightField> grounds = {ridges(256, 1), ridges(256, 2)};
  const LearnedDictionary learned = learn_dictionary(grounds, small(), Seed{3}, {});
  EXPECT_GT(learned.dictionary.shapes.size(), 150U);
  EXPECT_LE(learned.dictionary.shapes.size(), 200U);
  const HeightField real = ridges(256, 9), coarse = geom::box_downsample(real, 4, {});
  const DetailMeasures made = measure_detail(amplify::sparse(coarse, learned.dictionary, {}, {}), real, 4, {});
  const DetailMeasures bicubic = measure_detail(geom::resample(coarse, real.frame(), {}), real, 4, {});
  const DetailMeasures same = measure_detail(real, real, 4, {});
  EXPECT_EQ(same.rms_m, 0.0);
  EXPECT_EQ(same.slope_off_deg, 0.0);
  for (int o = 0; o < 2; ++o) {
    EXPECT_GT(made.octaves[o], 0.4 * same.octaves[o]) << o;
    EXPECT_LT(made.octaves[o], 2.5 * same.octaves[o]) << o;
  }
  EXPECT_LT(bicubic.octaves[0], 0.1 * same.octaves[0]);
  EXPECT_LT(made.slope_off_deg, 0.6 * bicubic.slope_off_deg);
}

TEST(LearnDictionary, IsTheSameForTheSameSeedOnAnyNumberOfThreads) {
  const std::vector<HeightField> grounds = {ridges(200, 1)};
  const auto learn = [&](uint64_t seed, int threads) {
    return learn_dictionary(grounds, small(), Seed{seed}, {.threads = threads}).dictionary;
  };
  const amplify::Dictionary one = learn(1, 1), two = learn(1, 2), other = learn(2, 1);
  EXPECT_EQ(one.shapes, two.shapes);
  EXPECT_EQ(one.details, two.details);
  EXPECT_NE(one.details, other.details);
}

TEST(LearnDictionary, PassesOverSeaAndUnknownCells) {
  HeightField ground = ridges(200, 4);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (x < 80) ground(x, y) = -ground(x, y);
      if (x >= 140) ground(x, y) = std::numeric_limits<float>::quiet_NaN();
    }
  }
  const std::vector<HeightField> grounds = {ground};
  for (const Piece& piece : draw_pieces(grounds, 3000, 0.1, Seed{1}, {})) {
    for (const float z : piece.detail) ASSERT_TRUE(std::isfinite(z));
    ASSERT_GT(piece.strength, 0.0F);
  }
  EXPECT_GT(learn_dictionary(grounds, small(), Seed{1}, {}).pieces, 300);
  const std::vector<HeightField> sea = {HeightField(GridFrame::centred(100, 100, 30.0), -5.0F)};
  EXPECT_THROW(learn_dictionary(sea, small(), Seed{1}, {}), Error);
  EXPECT_THROW(learn_dictionary({}, small(), Seed{1}, {}), Error);
  EXPECT_THROW(learn_dictionary(grounds, {.atoms = 3}, Seed{1}, {}), InvalidArgument);
}

/// Pieces say what the ground has over its coarse cells: none where they are an exact plane.
TEST(DrawPieces, AreOfWhatCoarseCellsDoNotSay) {
  HeightField plane(GridFrame::centred(120, 120, 30.0));
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) plane(x, y) = 100.0F + 3.0F * static_cast<float>(x) + static_cast<float>(y);
  EXPECT_TRUE(draw_pieces(std::vector{plane}, 500, 0.05, Seed{1}, {}).empty());
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) plane(x, y) += (x + y) % 2 == 0 ? 2.0F : -2.0F;
  const std::vector<Piece> pieces = draw_pieces(std::vector{plane}, 500, 0.05, Seed{1}, {});
  ASSERT_GT(pieces.size(), 200U);
}

}  // namespace
}  // namespace seamount::train
