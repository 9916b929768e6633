#include "seamount/geom/polygon/edge_grid.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

using Pairs = std::set<std::pair<size_t, size_t>>;

RingEdge alone(Vec2 a, Vec2 b, size_t number) { return {a, b, number, 0, SIZE_MAX}; }

Pairs found_pairs(const std::vector<RingEdge>& edges) {
  Pairs pairs;
  const auto any = [](const RingEdge&, const RingEdge&) { return true; };
  EdgeGrid(edges).for_each_meeting(any, [&](const EdgeGrid::Meeting& meeting) {
    pairs.insert(std::minmax(meeting.first, meeting.second));
    return true;
  });
  return pairs;
}

Pairs all_pairs(const std::vector<RingEdge>& edges) {
  Pairs pairs;
  for (size_t i = 0; i < edges.size(); ++i) {
    for (size_t j = i + 1; j < edges.size(); ++j)
      if (segments_meet(edges[i].a, edges[i].b, edges[j].a, edges[j].b)) pairs.insert({i, j});
  }
  return pairs;
}

TEST(EdgeGrid, FindsAllMeetingsThatTestingAllPairsFinds) {
  Rng rng(Seed{7});
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<RingEdge> edges;
    const double reach = rng.chance(0.5) ? 3.0 : 40.0;
    const bool whole = rng.chance(0.5);  // whole numbers: touches and overlaps, edges along the lines between cells
    const auto number = [&](double low, double high) {
      const double value = rng.uniform(low, high);
      return whole ? std::floor(value) : value;
    };
    while (edges.size() < 150) {
      const Vec2 a{number(0, 60), number(0, 60)};
      const Vec2 b = a + Vec2{number(-reach, reach), rng.chance(0.2) ? 0.0 : number(-reach, reach)};
      if (!(a == b)) edges.push_back(alone(a, b, edges.size()));
    }
    EXPECT_EQ(found_pairs(edges), all_pairs(edges)) << "trial " << trial;
  }
}

TEST(EdgeGrid, FindsMeetingsBeyondWhereEdgesStart) {
  // Parts of rings: the last edges end where none starts. Once, the cells reached as far as the starts.
  std::vector<RingEdge> edges;
  for (int i = 0; i < 40; ++i) edges.push_back(alone({i + 0.0, 0}, {i + 0.5, 0}, edges.size()));
  edges.push_back(alone({0, 1}, {40, 61}, 40));
  edges.push_back(alone({40, 1}, {0, 61}, 41));
  EXPECT_EQ(found_pairs(edges), (Pairs{{40, 41}}));
}

}  // namespace
}  // namespace seamount::geom
