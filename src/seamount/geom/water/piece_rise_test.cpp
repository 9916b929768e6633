#include "seamount/geom/water/piece_rise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/rng.h"
#include "seamount/geom/water/pieces.h"

namespace seamount::geom {
namespace {

TEST(FloatNumber, CountsFloatsInTheirOrder) {
  EXPECT_EQ(float_number(0.0F), 0);
  EXPECT_EQ(float_number(-0.0F), 0);
  for (const float z : {-8848.0F, -1.0F, -std::numeric_limits<float>::denorm_min(), 0.0F, 1e-40F, 1.0F, 8848.86F}) {
    EXPECT_EQ(float_of_number(float_number(z)), z);
    EXPECT_EQ(float_of_number(float_number(z) + 1), std::nextafter(z, INFINITY));
  }
  EXPECT_EQ(float_of_number(float_number(kNoSea)), kNoSea);
  EXPECT_LT(float_number(kNoSea), float_number(std::numeric_limits<float>::lowest()));
}

/// Of two halves of a raster, from what each says of its rim, as of the whole.
TEST(RimRises, TellHeightsOverABorder) {
  constexpr int kWidth = 40, kHeight = 33, kHalf = 17;
  for (const uint64_t seed : {1, 2, 3}) {
    HeightField terrain(GridFrame::centred(kWidth, kHeight, 10.0));
    Rng rng(Seed{seed});
    for (float& z : terrain.cells()) z = static_cast<float>(rng.integer(-2, 3));
    const HeightField filled = fill_depressions(terrain, kNoSea, {});
    const FlowDirections codes = flow_directions(filled, kNoSea, {});
    HeightField fallen = filled;
    tilt_flats(fallen, codes, {});
    for (const bool eastern : {false, true}) {
      const int x0 = eastern ? kHalf : 0, width = eastern ? kWidth - kHalf : kHalf;
      HeightField piece(filled.frame().window(x0, 0, width, kHeight));
      FlowDirections own(piece.frame());
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < width; ++x) piece(x, y) = filled(x0 + x, y), own(x, y) = codes(x0 + x, y);
      const std::vector<RimRise> rises = rim_rises(piece, own, {});
      for (int32_t rim = 0; rim < rim_size(width, kHeight); ++rim) {
        const RimRise& rise = rises[static_cast<size_t>(rim)];
        int32_t number = rise.least;
        if (rise.exit >= 0) {
          const int32_t cell = rim_cell(rise.exit, width, kHeight);
          const uint8_t code = own.data()[cell];
          const float enters = fallen(x0 + cell % width + kFlowDx[code], cell / width + kFlowDy[code]);
          number = std::max(number, float_number(enters) + rise.steps);
        }
        const int32_t cell = rim_cell(rim, width, kHeight);
        EXPECT_EQ(float_of_number(number), fallen(x0 + cell % width, cell / width));
      }
    }
  }
}

}  // namespace
}  // namespace seamount::geom
