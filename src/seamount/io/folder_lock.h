// One process at a time in a folder.
#pragma once

#include <chrono>
#include <string>

#include "seamount/base/run_context.h"

namespace seamount::io {

/// A folder (made if missing) that one process at a time works in; the lock goes with the process, however it ends.
/// Temporaries that a killed process left there are removed.
class FolderLock {
 public:
  /// Waits up to `patience` for another process. Throws WriteError if the folder cannot be made or the other one still
  /// holds it then, Cancelled.
  explicit FolderLock(const std::string& folder, std::chrono::milliseconds patience = {}, const RunContext& run = {});
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int handle_;
};

}  // namespace seamount::io
