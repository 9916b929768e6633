#include "seamount/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <utility>

namespace seamount {
namespace {

/// Counts finished blocks and passes the fraction on, one call at a time.
class BlockProgress {
 public:
  BlockProgress(const RunContext& run, int64_t blocks) : run_(run), blocks_(blocks) {}

  void finished_one() {
    if (!run_.progress) return;
    const std::lock_guard lock(mutex_);
    run_.report(static_cast<double>(++done_) / static_cast<double>(blocks_));
  }

 private:
  const RunContext& run_;
  int64_t blocks_;
  int64_t done_ = 0;
  std::mutex mutex_;
};

/// The failure of the lowest block that failed: the same one on any number of threads.
class FirstFailure {
 public:
  /// Did a block before this one fail? What comes of this one does not matter then.
  bool is_before(int64_t block) const { return block_.load(std::memory_order_relaxed) < block; }

  void add(int64_t block, std::exception_ptr what) {
    const std::lock_guard lock(mutex_);
    if (block_.load(std::memory_order_relaxed) < block) return;
    block_.store(block, std::memory_order_relaxed);
    what_ = std::move(what);
  }
  void rethrow() const {
    if (what_) std::rethrow_exception(what_);
  }

 private:
  std::atomic<int64_t> block_{std::numeric_limits<int64_t>::max()};
  std::exception_ptr what_;
  std::mutex mutex_;
};

}  // namespace

int thread_count(const RunContext& run) { return run.threads > 0 ? run.threads : tbb::info::default_concurrency(); }

void parallel_blocks(const RunContext& run, int64_t count, int64_t grain, const BlockBody& body) {
  if (count <= 0) return;
  const int64_t blocks = (count + grain - 1) / grain;
  BlockProgress progress(run, blocks);
  const auto run_block = [&](int64_t block) {
    run.check_cancelled();
    body(block * grain, std::min(count, (block + 1) * grain));
    progress.finished_one();
  };
  if (run.threads == 1 || blocks == 1) {
    for (int64_t block = 0; block < blocks; ++block) run_block(block);
    return;
  }
  FirstFailure failure;
  const auto try_block = [&](int64_t block) {
    if (failure.is_before(block)) return;
    try {
      run_block(block);
    } catch (...) {
      failure.add(block, std::current_exception());
    }
  };
  const auto run_all = [&] {
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(tbb::blocked_range<int64_t>(0, blocks, 1), [&](const tbb::blocked_range<int64_t>& range) {
        for (int64_t block = range.begin(); block != range.end(); ++block) try_block(block);
      });
    });
  };
  if (run.threads == 0) {
    run_all();
  } else {
    tbb::task_arena(std::min(run.threads, tbb::info::default_concurrency())).execute(run_all);
  }
  failure.rethrow();
}

void parallel_rows(const RunContext& run, int width, int height, const std::function<void(int, int)>& body) {
  constexpr int64_t kCellsPerBlock = 1 << 16;
  const int64_t rows = std::clamp<int64_t>(kCellsPerBlock / std::max(1, width), 1, 64);
  parallel_blocks(run, height, rows,
                  [&](int64_t begin, int64_t end) { body(static_cast<int>(begin), static_cast<int>(end)); });
}

}  // namespace seamount
