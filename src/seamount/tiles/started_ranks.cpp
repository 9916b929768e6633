#include "seamount/tiles/started_ranks.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/base/shared_library.h"

namespace seamount::tiles {
namespace {

constexpr const char* kLibrary = "seamount_ranks.so";

/// What says the rank and how many there are, for those that start processes.
struct Names {
  const char* rank;
  const char* size;
};
constexpr Names kStarters[] = {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                               {"PMI_RANK", "PMI_SIZE"},
                               {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"}};

std::optional<int> number_in(const char* variable) {
  const char* const text = std::getenv(variable);
  if (text == nullptr) return std::nullopt;
  const std::string_view all(text);
  int number = 0;
  const auto [end, error] = std::from_chars(all.data(), all.data() + all.size(), number);
  return error == std::errc() && end == all.data() + all.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

StartedAs started_as() {
  for (const Names& names : kStarters) {
    const auto rank = number_in(names.rank), size = number_in(names.size);
    if (rank && size && *size > 1 && *rank >= 0 && *rank < *size) return {*rank, *size};
  }
  return {};
}

std::unique_ptr<MessageRanks> open_ranks(const StartedAs& started, std::function<void()> on_stop,
                                         const std::atomic<bool>* cancelled) {
  const std::optional<std::string> library = find_part(kLibrary);
  if (!library) {
    throw Error(
        "this program was built without MPI, which several ranks need: install libopenmpi-dev, configure and build "
        "again");
  }
  using Open = RankLink* (*)();
  std::unique_ptr<RankLink> link(reinterpret_cast<Open>(load_function(*library, "seamount_open_ranks"))());
  if (link->size() != started.size) {
    const int found = link->size();
    link->close();
    throw Error(
        fmt::format("it was started {} times, but MPI knows of {}: start it by the mpirun of the MPI that it was built "
                    "with, or by srun --mpi=pmix",
                    started.size, found));
  }
  return std::make_unique<MessageRanks>(std::move(link), std::move(on_stop), cancelled);
}

}  // namespace seamount::tiles
