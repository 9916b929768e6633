// Was this process started as one of several, by mpirun or srun? MPI itself is a part of the program that is loaded
// only then.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "seamount/tiles/rank_messages.h"

namespace seamount::tiles {

/// As the environment says: Open MPI's, MPICH's, PMIx's or Slurm's. Alone: {0, 1}.
struct StartedAs {
  int rank = 0;
  int size = 1;
};
StartedAs started_as();

/// The ranks, all of which must call it. Throws Error where the program was built without MPI, or with one that knows
/// nothing of how it was started.
std::unique_ptr<MessageRanks> open_ranks(const StartedAs& started, std::function<void()> on_stop,
                                         const std::atomic<bool>* cancelled);

}  // namespace seamount::tiles
