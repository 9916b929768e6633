#include "seamount/geom/grid/upsample_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/grid/resample.h"

namespace seamount::geom {
namespace {

ScalarField waves(const GridFrame& frame) {
  ScalarField field(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x)
      field(x, y) = static_cast<float>(std::sin(frame.x(x) / 300) * std::cos(frame.y(y) / 260));
  }
  return field;
}

TEST(RowUpsampler, AgreeWithTheScalarSampler) {
  const ScalarField lattice = waves(GridFrame::centred(37, 23, 60));
  const GridFrame frame = GridFrame::centred(150, 90, 14);
  RowUpsampler rows(lattice);
  std::vector<float> line(150);
  for (int y = 0; y < frame.height; ++y) {
    rows.read(frame.x(0), frame.cell_m, frame.y(y), line);
    for (int x = 0; x < frame.width; ++x) {
      EXPECT_NEAR(line[static_cast<size_t>(x)],
                  sample_bicubic(lattice, lattice.frame().column(frame.x(x)), lattice.frame().row(frame.y(y))), 2e-5);
    }
  }
}

TEST(RowUpsampler, TheFramesOwnCellsComeBackExactly) {
  const ScalarField field = waves(GridFrame::centred(16, 9, 50));
  RowUpsampler rows(field);
  std::vector<float> line(16);
  for (int y = 0; y < 9; ++y) {
    rows.read(field.frame().x(0), 50, field.frame().y(y), line);
    for (int x = 0; x < 16; ++x) EXPECT_EQ(line[static_cast<size_t>(x)], field(x, y));
  }
}

TEST(CoarserFrame, CoversTheFrameFromItsCorner) {
  const GridFrame frame = GridFrame::centred(1000, 333, 10);
  const GridFrame coarse = coarser_frame(frame, 64);
  EXPECT_DOUBLE_EQ(coarse.cell_m, 64);
  EXPECT_GE(coarse.width * 64, 10000);
  EXPECT_GE(coarse.height * 64, 3330);
  EXPECT_DOUBLE_EQ(coarse.west_m, frame.west_m);
  EXPECT_EQ(coarser_frame(frame, 5), frame);
}

}  // namespace
}  // namespace seamount::geom
