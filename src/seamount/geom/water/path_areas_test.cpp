// Areas drained over short ways: those of all ways where ways are short, and the same in a window.
#include "seamount/geom/water/path_areas.h"

#include <gtest/gtest.h>

#include "seamount/base/rng.h"
#include "seamount/geom/water/flow_flats.h"

namespace seamount::geom {
namespace {

/// By following each cell's way.
Grid<uint32_t> plain_path_areas(const FlowDirections& directions, int steps) {
  Grid<uint32_t> areas(directions.frame(), 0);
  for (int y = 0; y < directions.height(); ++y) {
    for (int x = 0; x < directions.width(); ++x) {
      int column = x, row = y;
      for (int k = 0; k < steps; ++k) {
        ++areas(column, row);
        const uint8_t code = directions(column, row);
        if (code >= kOutlet) break;
        column += kFlowDx[code];
        row += kFlowDy[code];
      }
    }
  }
  return areas;
}

HeightField rough(const GridFrame& frame, uint64_t seed) {
  HeightField made(frame);
  Rng rng{Seed(seed)};
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) made(x, y) = static_cast<float>(3 * y + x + rng.uniform(0.0, 9.0));
  return made;
}

TEST(PathAreas, AreThoseOfFollowedWays) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    const FlowDirections directions = steepest_directions(rough({67, 41, 1.0}, seed), 30.0F, {});
    for (const int doublings : {0, 1, 3, 5})
      EXPECT_EQ(path_areas(directions, doublings, {}), plain_path_areas(directions, 1 << doublings));
    EXPECT_EQ(path_areas(directions, 12, {}), flow_accumulation(directions, {}));
    EXPECT_EQ(path_areas(directions, 6, {.threads = 1}), path_areas(directions, 6, {.threads = 4}));
  }
}

TEST(PathAreas, SteepestDirectionsAreThoseOfFlowButOnFlats) {
  const HeightField terrain = rough({40, 30, 1.0}, 5);
  const FlowDirections steepest = steepest_directions(terrain, 20.0F, {}), all = flow_directions(terrain, 20.0F, {});
  for (size_t i = 0; i < terrain.size(); ++i)
    EXPECT_TRUE(steepest.data()[i] == kPit || steepest.data()[i] == all.data()[i]);
  EXPECT_EQ(count_pits(steepest_directions(HeightField({9, 9, 1.0}, 4.0F), 0.0F, {})), 49);
}

}  // namespace
}  // namespace seamount::geom
