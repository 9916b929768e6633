// seamount_bench: Google Benchmark's flags, the memory settings of the command line.
#include <benchmark/benchmark.h>

#include "seamount/base/large_block.h"

int main(int argc, char** argv) {
  seamount::keep_freed_memory();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
