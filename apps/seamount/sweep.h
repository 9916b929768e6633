// --sweep: runs of a recipe with values that change.
#pragma once

#include <string>
#include <vector>

namespace seamount::app {

/// One run of a sweep.
struct SweepRun {
  std::vector<std::string> sets;  ///< "steps.worn.params.years=1000", as for --set
  std::string caption;            ///< "years = 1000, seed = 3"
};

struct Sweep {
  std::vector<SweepRun> runs;
  int columns = 1;  ///< in which they are shown: the values of the last name, or a square
};

/// Reads "NAME=FROM:TO:COUNT" (evenly from one number to another) and "NAME=VALUE,VALUE,..."; several are all their
/// combinations, the last one changes fastest. Throws InvalidArgument{"--sweep"}.
Sweep parse_sweeps(const std::vector<std::string>& texts);

}  // namespace seamount::app
