// Results of steps on disk, by content: a key is a hash of everything that a result depends on, so an entry is never
// stale, only unused. Entries are checksummed and know their key; a damaged or swapped one is computed again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "seamount/base/hash.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

class Cache {
 public:
  /// A cache in `folder` (created when first written), kept below about `limit_bytes` by dropping what was used longest
  /// ago. An empty folder name: nothing is kept.
  explicit Cache(std::string folder, uint64_t limit_bytes = uint64_t{4} << 30);

  /// The outputs stored under a key, or nothing if there are none, they are damaged or they lack one of `ports`.
  std::optional<Values> load(const Digest& key, const std::vector<Port>& ports,
                             const Registry& registry = standard_registry()) const;

  /// Stores outputs. A failure to write (a full disk) is not an error of the run: it returns false.
  bool store(const Digest& key, const Values& values);

  /// $SEAMOUNT_CACHE, or $XDG_CACHE_HOME/seamount, or ~/.cache/seamount; empty if there is no home.
  static std::string default_folder();

 private:
  std::string path_of(const Digest& key) const;
  void trim() const;

  std::string folder_;
  uint64_t limit_bytes_;
};

}  // namespace seamount::recipe
