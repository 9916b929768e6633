#include "seamount/geom/scalar/bucket_sort.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "seamount/base/rng.h"

namespace seamount::geom {
namespace {

TEST(BucketSort, SortsAsStdSortDoes) {
  for (const size_t count : {0U, 1U, 63U, 64U, 1000U, 20000U}) {
    for (const double power : {1.0, 8.0, 0.0}) {  // evenly, crowded, all alike
      Rng rng(Seed{count}.derive("sort"));
      std::vector<std::pair<double, int>> items;
      for (size_t i = 0; i < count; ++i) {
        const double u = power == 0.0 ? 1.0 : std::pow(rng.uniform(), power);
        items.emplace_back(-50.0 + 100.0 * u, rng.integer(0, 1 << 20));
      }
      std::vector<std::pair<double, int>> expected = items;
      std::sort(expected.begin(), expected.end());
      bucket_sort(
          items, [](const auto& item) { return (item.first + 50.0) / 100.0; }, std::less<>());
      EXPECT_EQ(items, expected) << count << ", " << power;
    }
  }
}

}  // namespace
}  // namespace seamount::geom
