// Which samples of a stored set are never learned from.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"

namespace seamount::train {

struct Split {
  std::vector<size_t> learned, held_out;
};

/// Every fifth sample by chance, after the number that samples have which show the same (`group`): all of these are on
/// one side. Throws InvalidArgument{"--set"} where there are too few samples to have both sides.
inline Split split_samples(size_t count, Seed seed, const std::function<uint64_t(size_t)>& group) {
  Split split;
  for (size_t i = 0; i < count; ++i) {
    Rng rng(seed.derive("held out", group(i)));
    (rng.chance(0.2) ? split.held_out : split.learned).push_back(i);
  }
  if (split.learned.empty() || split.held_out.empty())
    throw InvalidArgument("--set", "holds too few samples: about a fifth of them is not learned from");
  return split;
}

}  // namespace seamount::train
