#include "seamount/tiles/ranks.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <mutex>

namespace seamount::tiles {
namespace {

class OneRank : public Ranks {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  int on_this_machine() const override { return 1; }
  int64_t take(int64_t counter) override {
    const std::lock_guard lock(mutex_);
    return next_[counter]++;
  }
  void end(int64_t counter) override {
    const std::lock_guard lock(mutex_);
    next_[counter] = std::numeric_limits<int64_t>::max() / 2;
  }
  std::vector<std::string> gather(std::string mine) override { return {std::move(mine)}; }
  std::string share(std::string of_first) override { return of_first; }

 private:
  std::mutex mutex_;
  std::map<int64_t, int64_t> next_;
};

std::string bytes_of(int64_t number) { return {reinterpret_cast<const char*>(&number), sizeof number}; }

int64_t number_of(const std::string& bytes) {
  int64_t number = 0;
  std::memcpy(&number, bytes.data(), std::min(bytes.size(), sizeof number));
  return number;
}

}  // namespace

std::unique_ptr<Ranks> one_rank() { return std::make_unique<OneRank>(); }

void wait_for_all(Ranks& ranks) {
  ranks.gather("");
  ranks.share("");
}

int64_t lowest(Ranks& ranks, int64_t mine) {
  int64_t found = mine;
  for (const std::string& one : ranks.gather(bytes_of(mine))) found = std::min(found, number_of(one));
  return number_of(ranks.share(bytes_of(found)));
}

bool agreed(Ranks& ranks, bool of_first) { return ranks.share(of_first ? "y" : "n") == "y"; }

void by_first(Ranks& ranks, const std::function<void()>& work) {
  if (ranks.first()) work();
  ranks.share("");
}

}  // namespace seamount::tiles
