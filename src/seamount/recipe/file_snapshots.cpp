#include "seamount/recipe/file_snapshots.h"

namespace seamount::recipe {

std::shared_ptr<const io::FileSnapshot> FileSnapshots::of(const std::string& path) {
  std::shared_ptr<const io::FileSnapshot> known;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = known_.find(path); found != known_.end()) known = found->second;
  }
  if (known && known->still_valid()) return known;
  auto taken = std::make_shared<const io::FileSnapshot>(path);
  const std::lock_guard lock(mutex_);
  return known_[path] = std::move(taken);
}

}  // namespace seamount::recipe
