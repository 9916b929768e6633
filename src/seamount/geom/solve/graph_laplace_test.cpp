#include "seamount/geom/solve/graph_laplace.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/tin/node_graph.h"

namespace seamount::geom {
namespace {

/// A lattice of width x height nodes, in rows.
NodeGraph lattice(int width, int height) {
  std::vector<std::array<int32_t, 3>> triangles;
  for (int y = 0; y + 1 < height; ++y) {
    for (int x = 0; x + 1 < width; ++x) {
      const int a = y * width + x;
      triangles.push_back({a, a + 1, a + width});
      triangles.push_back({a + 1, a + width + 1, a + width});
    }
  }
  return make_node_graph(triangles, static_cast<size_t>(width) * static_cast<size_t>(height));
}

TEST(NodeGraph, ListsNeighboursOnce) {
  const NodeGraph graph = lattice(3, 2);
  const auto around = [&](size_t i) {
    const auto span = graph.around(i);
    return std::vector<int32_t>(span.begin(), span.end());
  };
  EXPECT_EQ(around(0), (std::vector<int32_t>{1, 3}));
  EXPECT_EQ(around(1), (std::vector<int32_t>{0, 2, 3, 4}));
  EXPECT_EQ(around(4), (std::vector<int32_t>{1, 2, 3, 5}));
  EXPECT_TRUE(make_node_graph({}, 4).around(3).empty());
}

/// Number of a place along a Z: neighbours in the order are neighbours in the plane.
int32_t z_order(int x, int y) {
  int32_t z = 0;
  for (int bit = 0; bit < 8; ++bit) z |= ((x >> bit & 1) << (2 * bit)) | ((y >> bit & 1) << (2 * bit + 1));
  return z;
}

TEST(GraphLaplace, RunsEvenlyBetweenTwoSidesOfASquare) {
  const int side = 128;
  std::vector<std::array<int32_t, 3>> triangles;
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const int32_t a = z_order(x, y), b = z_order(x + 1, y), c = z_order(x + 1, y + 1), d = z_order(x, y + 1);
      const bool rising = (x + y) % 2 == 0;  // diagonals either way, so that none leans
      triangles.push_back(rising ? std::array{a, b, c} : std::array{a, b, d});
      triangles.push_back(rising ? std::array{a, c, d} : std::array{b, c, d});
    }
  }
  const NodeGraph graph = make_node_graph(triangles, static_cast<size_t>(side * side));
  std::vector<uint8_t> fixed(static_cast<size_t>(side * side), 0);
  std::vector<double> value(fixed.size(), 0.0);
  for (int y = 0; y < side; ++y) {
    for (const int x : {0, side - 1}) {
      fixed[static_cast<size_t>(z_order(x, y))] = 1;
      value[static_cast<size_t>(z_order(x, y))] = x == 0 ? 10.0 : 20.0;
    }
  }
  solve_graph_laplace(graph.starts, graph.neighbours, fixed, value, {});
  double worst = 0.0;
  double steepest = 0.0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double v = value[static_cast<size_t>(z_order(x, y))];
      if (y >= side / 4 && y < side - side / 4) worst = std::max(worst, std::abs(v - (10.0 + 10.0 * x / (side - 1))));
      if (x > 0) steepest = std::max(steepest, v - value[static_cast<size_t>(z_order(x - 1, y))]);
    }
  }
  EXPECT_LT(worst, 0.35);  // at the free sides diagonals are missing
  EXPECT_LT(steepest, 1.5 * 10.0 / (side - 1));
}

TEST(GraphLaplace, KeepsFixedValuesTheRangeAndWhatNothingReaches) {
  const NodeGraph graph = lattice(30, 30);
  std::vector<uint8_t> fixed(901, 0);
  std::vector<double> value(901, 99.0);
  std::vector<uint32_t> starts = graph.starts;
  starts.push_back(starts.back());  // one node alone
  for (size_t i = 0; i < 900; i += 37) {
    fixed[i] = 1;
    value[i] = std::sin(static_cast<double>(i));
  }
  const std::vector<double> before = value;
  solve_graph_laplace(starts, graph.neighbours, fixed, value, {});
  for (size_t i = 0; i < 900; ++i) {
    EXPECT_TRUE(fixed[i] == 0 || value[i] == before[i]);
    EXPECT_LE(std::abs(value[i]), 1.0);
  }
  EXPECT_EQ(value[900], 99.0);
  std::fill(fixed.begin(), fixed.end(), uint8_t{0});
  std::vector<double> untouched = before;
  solve_graph_laplace(starts, graph.neighbours, fixed, untouched, {});
  EXPECT_EQ(untouched, before);
}

}  // namespace
}  // namespace seamount::geom
