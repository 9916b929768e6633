#include "seamount/geom/scalar/segment.h"

#include <gtest/gtest.h>

namespace seamount::geom {
namespace {

TEST(Segment, NearestPlaceLiesBesideOrAtAnEnd) {
  EXPECT_EQ(nearest_on_segment({3, 5}, {0, 0}, {10, 0}), (Vec2{3, 0}));
  EXPECT_EQ(nearest_on_segment({-3, 5}, {0, 0}, {10, 0}), (Vec2{0, 0}));
  EXPECT_EQ(nearest_on_segment({13, 5}, {0, 0}, {10, 0}), (Vec2{10, 0}));
  EXPECT_EQ(nearest_on_segment({13, 5}, {2, 1}, {2, 1}), (Vec2{2, 1})) << "no length";
  EXPECT_EQ(nearest_share({5, 5}, {0, 0}, {0, 20}), 0.25);
  EXPECT_EQ(squared_distance_to_segment({3, 5}, {0, 0}, {10, 0}), 25.0);
}

}  // namespace
}  // namespace seamount::geom
