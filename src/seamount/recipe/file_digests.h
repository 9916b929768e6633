// Digests of the files that steps read, remembered for as long as a file stays as it is: a large elevation model is
// read once, not at every move of a slider.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "seamount/base/hash.h"

namespace seamount::recipe {

class FileDigests {
 public:
  /// Digest of a file's content and of the files that belong to it (file_digest()), read again where size or time of
  /// change of one of them are no longer the same. Throws IoError. May be called from any thread.
  Digest of(const std::string& path);

 private:
  struct Known {
    std::string signature;
    Digest digest;
  };
  std::mutex mutex_;
  std::map<std::string, Known> known_;
};

}  // namespace seamount::recipe
