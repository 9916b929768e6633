#include "seamount/recipe/loaded_networks.h"

#include <deque>
#include <mutex>
#include <utility>

#include "seamount/io/weights.h"
#include "seamount/recipe/file_snapshots.h"

namespace seamount::recipe {
namespace {

constexpr size_t kKept = 4;  ///< some 15 MB each

struct Loaded {
  Digest weights;
  learned::Precision precision;
  std::shared_ptr<const learned::Network> network;
};

struct Shelf {
  std::mutex mutex;
  FileSnapshots snapshots;
  std::deque<Loaded> loaded;  ///< the last one that was asked for first
};

Shelf& shelf() {
  static Shelf one;
  return one;
}

}  // namespace

std::shared_ptr<const learned::Network> loaded_network(const std::string& path, learned::Precision precision) {
  Shelf& kept = shelf();
  const std::shared_ptr<const io::FileSnapshot> file = kept.snapshots.of(path);
  const std::lock_guard lock(kept.mutex);
  for (auto it = kept.loaded.begin(); it != kept.loaded.end(); ++it) {
    if (it->weights != file->digest() || it->precision != precision) continue;
    Loaded found = std::move(*it);
    kept.loaded.erase(it);
    kept.loaded.push_front(std::move(found));
    return kept.loaded.front().network;
  }
  auto network = std::make_shared<const learned::Network>(io::read_weights(path), precision);
  if (!file->still_valid()) return network;  // it may be another file's than the digest's
  kept.loaded.push_front({file->digest(), precision, network});
  if (kept.loaded.size() > kKept) kept.loaded.pop_back();
  return network;
}

}  // namespace seamount::recipe
