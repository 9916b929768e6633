#include "seamount/base/background.h"

#include <gtest/gtest.h>

#include <atomic>

namespace seamount {
namespace {

TEST(Background, RunsEveryBodyOnceAndWaitsForThem) {
  std::atomic<int> begun{0};
  std::atomic<bool> stop{false};
  {
    const Background background(3, [&] {
      ++begun;
      while (!stop) {
      }
    });
    while (begun < 3) {
    }
    stop = true;
  }
  EXPECT_EQ(begun, 3);
}

}  // namespace
}  // namespace seamount
