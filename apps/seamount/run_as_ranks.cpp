#include <fmt/format.h>

#include "app.h"
#include "seamount/tiles/started_ranks.h"

namespace seamount::app {
namespace {

/// A failure as the exception that it was, as far as exit codes tell them apart.
[[noreturn]] void rethrow_of_other(const tiles::RankFailure& failure, int ranks) {
  cancel_flag() = false;  // it was no wish of the user's
  const std::string who = fmt::format("rank {} of {} ({})", failure.rank, ranks, failure.machine);
  if (failure.kind == kWrongInput) throw InvalidArgument(who, failure.text);
  throw Error(who + ": " + failure.text);
}

void tell(tiles::MessageRanks& ranks) {
  try {
    throw;
  } catch (const InvalidArgument& error) {
    ranks.fail(kWrongInput, error.what());
  } catch (const IncompatibleInputs& error) {
    ranks.fail(kWrongInput, error.what());
  } catch (const std::bad_alloc&) {
    ranks.fail(kFailed, "not enough memory");
  } catch (const std::exception& error) {
    ranks.fail(kFailed, error.what());
  }
}

}  // namespace

void run_as_ranks(const RunFlags& flags, const std::function<void(tiles::Ranks* ranks)>& work) {
  const tiles::StartedAs started = tiles::started_as();
  if (started.size == 1) return work(nullptr);
  if (flags.tiles == 0) {
    if (started.rank != 0) return;
    throw InvalidArgument("--tiles", "is needed where several ranks run one recipe (mpirun, srun): they share tiles");
  }
  std::unique_ptr<tiles::MessageRanks> ranks;
  try {
    ranks = tiles::open_ranks(
        started, [] { cancel_flag() = true; }, &cancel_flag());
  } catch (const std::exception&) {
    if (started.rank == 0) throw;
    return;
  }
  try {
    work(ranks.get());
  } catch (...) {
    tell(*ranks);
    const tiles::RankFailure failure = *ranks->failure();
    ranks->close();
    if (started.rank != 0) return;  // rank 0 says it
    if (failure.rank != 0) rethrow_of_other(failure, started.size);
    throw;
  }
  ranks->close();
}

}  // namespace seamount::app
