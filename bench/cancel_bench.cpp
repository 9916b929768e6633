// How long each operator takes to stop when it is cancelled in the middle of its work, at 1024 x 1024 cells: the time
// of an iteration is that from setting the flag to the operator's end, at nine moments of its run; `worst_ms` is the
// longest.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "seamount/recipe/test_calls.h"

namespace seamount::recipe {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void cancel(benchmark::State& state, const Operator& op) {
  const ExampleCall call(op, {1024, 1024, 50000}, true);
  const auto start = Clock::now();
  call.run(op, Seed{5}, {});
  const double whole = seconds_since(start);
  double worst = 0.0, share = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    share += 0.1;
    std::atomic<bool> cancelled{false};
    std::thread worker([&] {
      try {
        call.run(op, Seed{5}, {.cancelled = &cancelled});
      } catch (const Cancelled&) {
        return;  // wanted
      }
    });
    std::this_thread::sleep_for(std::chrono::duration<double>(share * whole));
    cancelled = true;
    const auto asked = Clock::now();
    worker.join();
    const double seconds = seconds_since(asked);
    state.SetIterationTime(seconds);
    worst = std::max(worst, seconds);
  }
  state.counters["worst_ms"] = 1e3 * worst;
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const auto& op : standard_registry().operators()) {
    benchmark::RegisterBenchmark(("recipe/cancel/" + op->name).c_str(),
                                 [op = op.get()](benchmark::State& state) { cancel(state, *op); })
        ->UseManualTime()
        ->Iterations(9)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace seamount::recipe
