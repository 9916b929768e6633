// The processes that run one recipe in tiles together: ranks, as MPI calls them, on one machine or on several that
// share a folder. Results go through that folder's tiles; what is said here is small: who takes the next tile, what has
// been decided, that one has failed.
//
// All ranks walk through the recipe in the same way: whatever hangs on the state of the disk or on one machine is
// decided by rank 0 and shared.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace seamount::tiles {

class Ranks {
 public:
  virtual ~Ranks() = default;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  bool first() const { return rank() == 0; }
  /// How many of them share this machine, itself among them.
  virtual int on_this_machine() const = 0;

  // Each may throw Cancelled: the user has asked for it, or another rank has failed.
  /// The next number, from 0 on, of a counter: each goes to one rank. May be called by many threads.
  virtual int64_t take(int64_t counter) = 0;
  /// From now on a counter gives numbers above all that anybody asks for.
  virtual void end(int64_t counter) = 0;
  /// Everybody's message, by rank, at rank 0; elsewhere nothing. Every rank calls gather() and share() in the same
  /// order as all others.
  virtual std::vector<std::string> gather(std::string mine) = 0;
  /// The message of rank 0, everywhere.
  virtual std::string share(std::string of_first) = 0;

  /// A counter that nobody has used. Every rank asks for as many.
  int64_t new_counter() { return counters_++; }

 private:
  int64_t counters_ = 0;
};

/// One process alone.
std::unique_ptr<Ranks> one_rank();

/// Returns when every rank has called it.
void wait_for_all(Ranks& ranks);

/// The lowest of all ranks' numbers, and what rank 0 has decided, everywhere.
int64_t lowest(Ranks& ranks, int64_t mine);
bool agreed(Ranks& ranks, bool of_first);

/// Rank 0 does it and the others wait. What it throws, others do not: they are stopped.
void by_first(Ranks& ranks, const std::function<void()>& work);

}  // namespace seamount::tiles
