#include "seamount/geom/grid/closing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

TEST(Closing, ThinDarkLinesVanishAndEdgesStay) {
  ScalarField field(GridFrame::centred(40, 30, 1));
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) field(x, y) = x < 20 ? 1.0F : 0.5F;
  ScalarField seamed = field;
  for (int y = 0; y < 30; ++y) seamed(8, y) = seamed(9, y) = 0.2F;
  for (int x = 0; x < 40; ++x) seamed(x, 15) = 0.1F;
  EXPECT_EQ(closing(seamed, 3, {}), field);
}

TEST(Closing, NeverDarkerAndTwiceIsOnce) {
  Rng rng(Seed{3});
  ScalarField field(GridFrame::centred(23, 17, 1));
  for (float& value : field.cells()) value = static_cast<float>(rng.uniform(0, 1));
  const ScalarField once = closing(field, 2, {});
  for (size_t i = 0; i < field.cells().size(); ++i) EXPECT_GE(once.cells()[i], field.cells()[i]);
  EXPECT_EQ(closing(once, 2, {}), once);
  EXPECT_EQ(closing(field, 0, {}), field);
  EXPECT_EQ(closing(field, 2, {.threads = 1}), closing(field, 2, {.threads = 3}));
}

}  // namespace
}  // namespace seamount::geom
