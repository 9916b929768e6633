#include "seamount/geom/water/skeleton.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

using Mask = Grid<uint8_t>;

Mask mask_of(const std::vector<std::string>& rows) {
  Mask mask(GridFrame::centred(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1), 0);
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < mask.width(); ++x)
      mask(x, y) = rows[static_cast<size_t>(y)][static_cast<size_t>(x)] == '#' ? 1 : 0;
  return mask;
}

Mask blobs(int width, int height, uint64_t seed) {
  const ScalarField noise =
      fbm_grid(GridFrame::centred(width, height, 1), Seed{seed}, {.wavelength_m = 14, .octaves = 3}, {});
  Mask mask(noise.frame());
  for (size_t i = 0; i < mask.size(); ++i) mask.data()[i] = std::abs(noise.data()[i]) < 0.1F ? 1 : 0;
  return mask;
}

/// Number of pieces of cells with this value; set cells hang together over corners, clear ones do not, and beyond the
/// grid all is clear.
int pieces(const Mask& mask, int value) {
  GridFrame wider = mask.frame();
  wider.width += 2;
  wider.height += 2;
  Mask padded(wider, 0);
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < mask.width(); ++x) padded(x + 1, y + 1) = mask(x, y) != 0 ? 1 : 0;
  int count = 0;
  std::vector<std::pair<int, int>> stack;
  for (int y = 0; y < padded.height(); ++y) {
    for (int x = 0; x < padded.width(); ++x) {
      if (padded(x, y) != value) continue;
      ++count;
      stack.assign(1, {x, y});
      padded(x, y) = 9;
      while (!stack.empty()) {
        const auto at = stack.back();
        stack.pop_back();
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            if (value == 0 && dx != 0 && dy != 0) continue;
            const int nx = at.first + dx, ny = at.second + dy;
            if (!padded.contains(nx, ny) || padded(nx, ny) != value) continue;
            padded(nx, ny) = 9;
            stack.emplace_back(nx, ny);
          }
        }
      }
    }
  }
  return count;
}

/// Squares of four set cells: only where four lines meet over the corners does thinning have to leave one.
int squares(const Mask& mask) {
  int count = 0;
  for (int y = 0; y + 1 < mask.height(); ++y)
    for (int x = 0; x + 1 < mask.width(); ++x)
      if (mask(x, y) + mask(x + 1, y) + mask(x, y + 1) + mask(x + 1, y + 1) == 4) ++count;
  return count;
}

TEST(Thin, KeepsPiecesAndHolesAndLeavesOneCell) {
  for (uint64_t seed = 0; seed < 40; ++seed) {
    const Mask before = blobs(60, 47, seed);
    Mask after = before;
    thin(after, {});
    EXPECT_EQ(pieces(after, 1), pieces(before, 1)) << seed;
    EXPECT_EQ(pieces(after, 0), pieces(before, 0)) << seed;
    EXPECT_LE(squares(after), 1) << seed;
    for (size_t i = 0; i < before.size(); ++i) ASSERT_LE(after.data()[i], before.data()[i]);
    Mask again = after;
    thin(again, {});
    EXPECT_EQ(again, after);
  }
}

TEST(Thin, ABarBecomesItsMiddle) {
  Mask bar =
      mask_of({"..........", ".########.", ".########.", ".########.", ".########.", ".########.", ".........."});
  thin(bar, {});
  for (int x = 3; x < 7; ++x) EXPECT_EQ(bar(x, 3), 1) << x;
  int count = 0;
  for (const uint8_t cell : bar.cells()) count += cell;
  EXPECT_LE(count, 8);
}

TEST(TraceSkeleton, TakesEveryStepOnce) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Mask mask = blobs(50, 40, seed);
    thin(mask, {});
    Mask seen(mask.frame(), 0);
    for (const CellChain& chain : trace_skeleton(mask)) {
      for (size_t i = 0; i < chain.size(); ++i) {
        seen.data()[chain[i]] = 1;
        ASSERT_NE(mask.data()[chain[i]], 0);
        if (i == 0) continue;
        EXPECT_LE(std::abs(chain[i] % 50 - chain[i - 1] % 50), 1);
        EXPECT_LE(std::abs(chain[i] / 50 - chain[i - 1] / 50), 1);
      }
    }
    EXPECT_EQ(seen, mask);
  }
}

TEST(PruneSkeleton, DropsTwigsAndCrumbs) {
  Mask mask = mask_of({"....#.....#.", "....#.......", "############", "............", "##.........."});
  prune_skeleton(mask, 3, 4, {});
  EXPECT_EQ(mask, mask_of({"............", "............", "############", "............", "............"}));
}

TEST(SmoothChain, StaysInItsCells) {
  const GridFrame frame = GridFrame::centred(40, 40, 10);
  Rng rng(Seed{3});
  CellChain chain{0};
  for (int i = 1; i < 40; ++i) {
    const int row = chain.back() / 40, step = rng.integer(row > 0 ? -1 : 0, row < 39 ? 1 : 0);
    chain.push_back((row + step) * 40 + i);
  }
  const Polyline line = smooth_chain(chain, frame);
  EXPECT_LT(line.size(), chain.size() + 1);
  for (const Vec2& p : line) {
    const auto x = static_cast<int>(std::lround(frame.column(p.x)));
    EXPECT_EQ(std::lround(frame.row(p.y)), chain[static_cast<size_t>(x)] / 40);
  }
}

}  // namespace
}  // namespace seamount::geom
