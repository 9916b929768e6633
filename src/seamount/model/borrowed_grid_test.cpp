#include "seamount/model/borrowed_grid.h"

#include <gtest/gtest.h>

#include <numeric>

#include "seamount/base/background.h"

namespace seamount {
namespace {

std::vector<float> ramp(size_t n) {
  std::vector<float> values(n);
  std::iota(values.begin(), values.end(), 1.0F);
  return values;
}

TEST(BorrowedGrid, LiesWhereTheCellsStandAndFreesNothing) {
  for (const int width : {1, 7, 1500}) {  // below and above the size of huge pages
    const GridFrame frame = GridFrame::centred(width, width, 5.0);
    std::vector<float> cells = ramp(static_cast<size_t>(frame.cells()));
    const std::vector<float> before = cells;
    {
      const auto grid = borrow_cells(frame, cells.data(), nullptr);
      EXPECT_EQ(grid->data(), cells.data());
      EXPECT_EQ(grid->frame(), frame);
      EXPECT_EQ(cells, before);
      cells[0] = -3.0F;
      EXPECT_EQ((*grid)(0, 0), -3.0F);
      cells[0] = before[0];
    }
    EXPECT_EQ(cells, before);
  }
}

TEST(BorrowedGrid, CopiesAreGridsOfTheirOwn) {
  std::vector<float> cells = ramp(6);
  HeightField copy;
  {
    const auto grid = borrow_cells({3, 2, 1.0}, cells.data(), nullptr);
    copy = *grid;
    EXPECT_NE(copy.data(), cells.data());
  }
  cells.assign(6, 0.0F);
  EXPECT_EQ(copy(2, 1), 6.0F);
}

TEST(BorrowedGrid, KeepsItsOwnerUntilItIsGone) {
  auto owner = std::make_shared<std::vector<float>>(ramp(4));
  const std::weak_ptr<const void> watched = owner;
  auto grid = borrow_cells({2, 2, 1.0}, owner->data(), owner);
  owner.reset();
  EXPECT_FALSE(watched.expired());
  const auto also = grid;
  grid.reset();
  EXPECT_FALSE(watched.expired());
  EXPECT_EQ((*also)(1, 1), 4.0F);
}

TEST(BorrowedGrid, MemoryOfAGridCanBeBorrowedTwice) {
  auto own = std::make_shared<const HeightField>(GridFrame::centred(1200, 1200, 1.0), 2.5F);
  const float* cells = own->data();
  auto first = borrow_cells(own->frame(), cells, own);
  auto second = borrow_cells(own->frame(), cells, own);
  own.reset();
  EXPECT_EQ(second->data(), cells);
  first.reset();
  EXPECT_EQ((*second)(1199, 1199), 2.5F);
  second.reset();  // frees the grid's own memory: a leak or a double free is the sanitizers' to find
}

TEST(BorrowedGrid, ThreadsDoNotMeet) {
  const Background threads(4, [] {
    for (int i = 0; i < 2000; ++i) {
      const std::vector<float> cells = ramp(12);
      const auto grid = borrow_cells({4, 3, 1.0}, cells.data(), nullptr);
      const HeightField other({4, 3, 1.0}, 0.0F);
      EXPECT_EQ(grid->data(), cells.data());
      EXPECT_NE(other.data(), cells.data());
    }
  });
}

TEST(BorrowedGrid, OfLabels) {
  const std::vector<Region> cells = {Region::mountain, Region::reef, Region::abyss, Region::beach};
  const auto labels = borrow_cells({2, 2, 1.0}, cells.data(), nullptr);
  EXPECT_EQ(labels->data(), cells.data());
  EXPECT_EQ((*labels)(0, 1), Region::abyss);
}

}  // namespace
}  // namespace seamount
