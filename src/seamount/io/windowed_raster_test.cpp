#include "seamount/io/windowed_raster.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>

#include "seamount/base/error.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

TEST(WindowedRaster, GivesEveryWindowOnceAndReadsARowOfThemTogether) {
  const HeightField heights = test_terrain({90, 70, 4, 100, 200, ""});
  int reads = 0;
  WindowedRaster raster = windows_of(heights);
  raster.window = [&, from = raster.window](int column, int row, int width, int height) {
    ++reads;
    return from(column, row, width, height);
  };
  std::vector<CellWindow> windows;
  for (int y = 0; y < 69; y += 20)
    for (int x = 0; x < 89; x += 30) windows.push_back({x, y, std::min(31, 90 - x), std::min(21, 70 - y)});
  std::vector<int> seen(windows.size(), 0);
  double last = 0;
  std::mutex one;
  for_each_window(raster, windows,
                  {.progress =
                       [&](double f) {
                         const std::lock_guard lock(one);
                         last = std::max(last, f);
                       }},
                  [&](size_t i, const Grid<float>& cells) {
                    ++seen[i];
                    const CellWindow& w = windows[i];
                    ASSERT_EQ(cells.width(), w.width);
                    ASSERT_EQ(cells.height(), w.height);
                    EXPECT_EQ(cells.frame().x(0), heights.frame().x(w.column));
                    EXPECT_EQ(cells.frame().y(0), heights.frame().y(w.row));
                    for (int y = 0; y < w.height; ++y)
                      for (int x = 0; x < w.width; ++x) ASSERT_EQ(cells(x, y), heights(w.column + x, w.row + y));
                  });
  EXPECT_EQ(seen, std::vector<int>(windows.size(), 1));
  EXPECT_EQ(reads, 4) << "one for each row of windows";
  EXPECT_EQ(last, 1.0);
}

TEST(WindowedRaster, StopsWhenCancelled) {
  const HeightField heights = test_terrain({40, 40, 4, 0, 0, ""});
  std::atomic<bool> stop{false};
  const std::vector<CellWindow> windows = {{0, 0, 40, 10}, {0, 10, 40, 10}, {0, 20, 40, 10}};
  int seen = 0;
  EXPECT_THROW(for_each_window(windows_of(heights), windows, {.threads = 1, .cancelled = &stop},
                               [&](size_t, const Grid<float>&) { ++seen, stop = true; }),
               Cancelled);
  EXPECT_EQ(seen, 1);
}

TEST(WindowedRaster, KnowsItsExtremes) {
  HeightField heights(GridFrame{30, 200, 1, 0, 0, ""}, 5.0F);
  heights(29, 199) = -3.0F;
  heights(0, 100) = std::nanf("");
  heights(7, 64) = 9.5F;
  const RasterExtremes extremes = extremes_of(windows_of(heights), {});
  EXPECT_EQ(extremes.range, (HeightRange{-3.0, 9.5}));
  EXPECT_EQ(extremes.unknown_cells, 1);
  EXPECT_EQ(extremes.known_cells, 5999);
  heights(3, 3) = std::numeric_limits<float>::infinity();
  EXPECT_THROW(extremes_of(windows_of(heights), {}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::io
