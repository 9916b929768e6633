#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <thread>

#include "seamount/base/parallel.h"
#include "seamount/base/rng.h"

namespace seamount {
namespace {

TEST(Rng, DependsOnSeedPurposeIndexAndDrawOnly) {
  Rng a(Seed{7}.derive("strokes", 3));
  Rng b(Seed{7}.derive("strokes", 3));
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
  EXPECT_NE(Rng(Seed{7}.derive("strokes", 3)).bits(), Rng(Seed{7}.derive("strokes", 4)).bits());
  EXPECT_NE(Rng(Seed{7}.derive("strokes", 3)).bits(), Rng(Seed{7}.derive("outlines", 3)).bits());
  EXPECT_NE(Rng(Seed{7}.derive("strokes", 3)).bits(), Rng(Seed{8}.derive("strokes", 3)).bits());
}

TEST(Rng, UniformAndNormalHaveTheirMoments) {
  Rng rng(Seed{1}.derive("moments"));
  constexpr int kDraws = 200000;
  double sum = 0, sum2 = 0, normal_sum = 0, normal_sum2 = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = rng.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    sum2 += u * u;
    const double n = rng.normal();
    normal_sum += n;
    normal_sum2 += n * n;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 0.003);
  EXPECT_NEAR(sum2 / kDraws, 1.0 / 3.0, 0.003);
  EXPECT_NEAR(normal_sum / kDraws, 0.0, 0.01);
  EXPECT_NEAR(normal_sum2 / kDraws, 1.0, 0.02);
}

TEST(Rng, IntegersCoverTheirRangeWithBothEnds) {
  Rng rng(Seed{2}.derive("integers"));
  std::vector<int> seen(5);
  for (int i = 0; i < 5000; ++i) ++seen[static_cast<size_t>(rng.integer(-2, 2) + 2)];
  for (const int count : seen) EXPECT_NEAR(count, 1000, 150);
}

TEST(Parallel, EveryIndexOnceOnAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 5}) {
    std::vector<int> hits(1003);
    parallel_blocks({.threads = threads}, 1003, 10, [&](int64_t begin, int64_t end) {
      for (int64_t i = begin; i < end; ++i) ++hits[static_cast<size_t>(i)];
    });
    EXPECT_EQ(std::accumulate(hits.begin(), hits.end(), 0), 1003) << threads;
    EXPECT_EQ(*std::max_element(hits.begin(), hits.end()), 1);
  }
}

TEST(Parallel, SumsAreTheSameBitsOnAnyNumberOfThreads) {
  const auto total = [](int threads) {
    return parallel_sum<double>({.threads = threads}, 100000, 64, [](int64_t begin, int64_t end) {
      double sum = 0;
      for (int64_t i = begin; i < end; ++i) sum += 1.0 / static_cast<double>(i + 1);
      return sum;
    });
  };
  EXPECT_EQ(total(1), total(4));
}

TEST(Parallel, PassesExceptionsOnAndStopsWhenCancelled) {
  EXPECT_THROW(parallel_blocks({}, 10, 1, [](int64_t, int64_t) { throw Error("no"); }), Error);
  std::atomic<bool> cancel{false};
  std::atomic<int> blocks{0};
  EXPECT_THROW(parallel_blocks({.threads = 1, .cancelled = &cancel}, 1000, 1,
                               [&](int64_t, int64_t) {
                                 if (++blocks == 10) cancel = true;
                               }),
               Cancelled);
  EXPECT_EQ(blocks, 10);
}

TEST(Parallel, TheFirstFailureIsTheSameOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 4}) {
    for (int round = 0; round < 20; ++round) {
      try {
        parallel_blocks({.threads = threads}, 1000, 1, [](int64_t begin, int64_t) {
          if (begin >= 137) throw Error(std::to_string(begin));
        });
        FAIL();
      } catch (const Error& error) {
        ASSERT_STREQ(error.what(), "137") << threads;
      }
    }
  }
}

TEST(Parallel, AThreadThatWaitsInALoopTakesUpNoOtherWork) {
  const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
  std::atomic<int> taken_up{0};
  tbb::task_arena(4).execute([&] {
    parallel_blocks({}, 64, 1, [&](int64_t step, int64_t) {
      thread_local bool busy = false;
      if (busy) ++taken_up;
      busy = true;
      parallel_blocks({}, 4, 1, [&](int64_t block, int64_t) {
        if (block == step % 4) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      });
      busy = false;
    });
  });
  EXPECT_EQ(taken_up, 0);
}

TEST(Parallel, ProgressRisesToOne) {
  std::vector<double> seen;
  const RunContext whole{.threads = 2, .progress = [&](double f) { seen.push_back(f); }};
  parallel_blocks(whole.part(0.5, 1.0), 8, 1, [](int64_t, int64_t) {});
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_GT(seen.front(), 0.5);
  EXPECT_DOUBLE_EQ(seen.back(), 1.0);
}

}  // namespace
}  // namespace seamount
