// A hidden folder for files under way. Its name is random, so that two containers, or two computers, that share a disk
// do not meet; nobody else may look into it; a lock tells whether its owner still lives.
#pragma once

#include <filesystem>
#include <string>

namespace seamount::io {

/// A new folder ".seamount-<32 hex digits>" inside another, gone with this object and all that is in it.
class PrivateFolder {
 public:
  /// `parent` must exist. Throws WriteError{shown}; empty: the parent's name stands in messages.
  explicit PrivateFolder(const std::filesystem::path& parent, const std::string& shown = {});
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Whether a path's last part is the name of such a folder.
  static bool is_private(const std::filesystem::path& folder);

  /// Removes the private folders inside `parent` whose owners were killed; those of living ones stay. Never throws.
  static void remove_abandoned(const std::filesystem::path& parent) noexcept;

 private:
  bool make();

  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace seamount::io
