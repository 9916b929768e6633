// What is wrong is an exception with a line to show; what takes too long can be stopped from another thread.
#include <atomic>
#include <cstdio>

#include "seamount/ops/terrain/noise.h"

int main() {
  using namespace seamount;
  int as_expected = 0;
  const GridFrame frame = GridFrame::centred(256, 256, 30.0);
  try {
    terrain::noise({.octaves = 99}, frame, Seed{1}, {});
  } catch (const InvalidArgument& error) {
    std::printf("%s\n", error.what());  // octaves: 99 is outside [...]
    as_expected += error.field() == "octaves" ? 1 : 0;
  }

  std::atomic<bool> stop{false};
  RunContext run;
  run.cancelled = &stop;
  run.progress = [&](double fraction) { stop = fraction > 0.1; };  // somebody presses a button
  try {
    terrain::noise({}, frame, Seed{1}, run);
  } catch (const Cancelled&) {
    std::printf("stopped\n");
    as_expected += 1;
  }
  return as_expected == 2 ? 0 : 1;
}
