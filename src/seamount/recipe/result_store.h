// What is known of results, by key, and the values themselves as far as memory goes. Not safe for threads: the
// scheduler holds its lock.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "seamount/base/hash.h"
#include "seamount/recipe/value.h"

namespace seamount::recipe {

struct DigestOrder {
  bool operator()(const Digest& a, const Digest& b) const { return a.high != b.high ? a.high < b.high : a.low < b.low; }
};

using Keys = std::set<Digest, DigestOrder>;

struct Result {
  bool running = false;
  bool not_on_disk = false;  ///< the cache was asked and has nothing
  bool done = false;         ///< it was finished once; the values may have been let go
  bool cached = false;       ///< they came from the cache on disk then
  double seconds = 0.0;
  std::vector<std::string> notes;
  std::exception_ptr failure;
  std::optional<Values> values;
  uint64_t bytes = 0;  ///< of the values
  uint64_t used = 0;   ///< when the values were last of use, by the store's count
  std::atomic<bool> cancelled{false};
  std::atomic<double> fraction{0.0};
};

class ResultStore {
 public:
  explicit ResultStore(uint64_t limit_bytes) : limit_bytes_(limit_bytes) {}

  /// What is known of a key; made where nothing is. Stays where it is until forget().
  Result& at(const Digest& key) { return results_[key]; }
  const Result* find(const Digest& key) const;

  void keep(Result& result, Values values);
  void touch(Result& result) { result.used = ++clock_; }

  /// Lets go of values that are not among `in_use`, those of longest ago first, until all fits into the limit.
  void shrink(const Keys& in_use);

  /// Forgets all but what is running, in memory or among `keys`.
  void forget_all_but(const Keys& keys);
  void forget_failures();

  uint64_t bytes() const { return bytes_; }
  std::map<Digest, Result, DigestOrder>& all() { return results_; }

 private:
  void let_go(Result& result);

  std::map<Digest, Result, DigestOrder> results_;
  uint64_t limit_bytes_;
  uint64_t bytes_ = 0;
  uint64_t clock_ = 0;
};

}  // namespace seamount::recipe
