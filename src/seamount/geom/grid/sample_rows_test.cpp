#include "seamount/geom/grid/sample_rows.h"

#include <gtest/gtest.h>

#include "seamount/base/rng.h"
#include "seamount/geom/grid/resample.h"

namespace seamount::geom {
namespace {

TEST(SampleRows, AgreesWithTheScalarSamplersInsideAndBeyondTheEdge) {
  for (const auto& [width, height] : {std::pair{13, 7}, {1, 9}, {9, 1}, {1, 1}}) {
    Grid<float> grid(GridFrame::centred(width, height, 1.0));
    Rng rng(Seed{3}.derive("sample"));
    for (float& v : grid.cells()) v = static_cast<float>(rng.uniform(-100, 100));
    std::vector<float> columns(257), rows(257), linear(257), cubic(257);
    for (size_t i = 0; i < columns.size(); ++i) {
      columns[i] = static_cast<float>(rng.uniform(-3, width + 3));
      rows[i] = static_cast<float>(rng.uniform(-3, height + 3));
    }
    sample_bilinear_rows(grid, columns, rows, linear);
    sample_bicubic_rows(grid, columns, rows, cubic);
    for (size_t i = 0; i < columns.size(); ++i) {
      EXPECT_NEAR(linear[i], sample_bilinear(grid, columns[i], rows[i]), 1e-3);
      if (columns[i] < 0 || rows[i] < 0 || columns[i] > static_cast<float>(width - 1) ||
          rows[i] > static_cast<float>(height - 1))
        continue;
      EXPECT_NEAR(cubic[i], sample_bicubic(grid, columns[i], rows[i]), 1e-3);
    }
  }
}

}  // namespace
}  // namespace seamount::geom
