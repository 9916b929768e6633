// Who uses a folder of the cache: several runs and ranks at once may, and the last one removes it.
#pragma once

#include <string>

namespace seamount::tiles {

/// Marks a folder as used as long as it lives, by a lock on a file beside it ("FOLDER.lock"), which ends with the
/// process however that ends. Where a file system knows no locks, nobody sees the others.
class FolderUse {
 public:
  /// Waits while another run removes the folder. The folder need not be there, its parent is made.
  explicit FolderUse(std::string folder);
  ~FolderUse();
  FolderUse(const FolderUse&) = delete;
  FolderUse& operator=(const FolderUse&) = delete;

  /// Is no longer one that uses it.
  void end() noexcept;
  /// The same, and removes the folder with all that is in it unless others use it. False: they do.
  bool end_and_remove() noexcept;

 private:
  bool open();

  std::string folder_, file_;
  int lock_ = -1;
};

}  // namespace seamount::tiles
