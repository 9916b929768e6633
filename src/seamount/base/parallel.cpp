#include "seamount/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>

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
  const auto run_all = [&] {
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(tbb::blocked_range<int64_t>(0, blocks, 1), [&](const tbb::blocked_range<int64_t>& range) {
        for (int64_t block = range.begin(); block != range.end(); ++block) run_block(block);
      });
    });
  };
  if (run.threads == 0) {
    run_all();
  } else {
    tbb::task_arena(std::min(run.threads, tbb::info::default_concurrency())).execute(run_all);
  }
}

void parallel_rows(const RunContext& run, int width, int height, const std::function<void(int, int)>& body) {
  constexpr int64_t kCellsPerBlock = 1 << 16;
  const int64_t rows = std::clamp<int64_t>(kCellsPerBlock / std::max(1, width), 1, 64);
  parallel_blocks(run, height, rows,
                  [&](int64_t begin, int64_t end) { body(static_cast<int>(begin), static_cast<int>(end)); });
}

}  // namespace seamount
