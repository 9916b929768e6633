// Snapshots of the files that steps read, remembered for as long as a file stays as it is: a large elevation model is
// hashed once, not at every move of a slider.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "seamount/io/file_digest.h"

namespace seamount::recipe {

class FileSnapshots {
 public:
  /// A snapshot of a file and of the files that belong to it; taken anew where one of them is no longer as it was.
  /// Throws IoError. May be called from any thread.
  std::shared_ptr<const io::FileSnapshot> of(const std::string& path);

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const io::FileSnapshot>> known_;
};

}  // namespace seamount::recipe
