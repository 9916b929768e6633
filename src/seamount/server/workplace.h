// The folder that the studio works in: every file that a window names lies in it. Names are relative, and no name, link
// or ".." leads out.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace seamount::server {

struct FileEntry {
  std::string path;  ///< relative, with "/"
  uint64_t bytes = 0;
  int64_t modified = 0;  ///< seconds since 1970
};

class Workplace {
 public:
  /// Throws IoError unless it is a folder.
  explicit Workplace(const std::string& folder);

  /// Canonical.
  const std::string& folder() const { return folder_; }

  /// The absolute path of a relative name, whether it exists or not. Throws InvalidArgument{"path"} for a name that is
  /// empty, absolute, has control characters or leads out of the folder.
  std::string resolve(const std::string& name) const;

  /// Files with one of these endings, three folders deep, no hidden ones; at most `most`, the newest first.
  std::vector<FileEntry> list(const std::vector<std::string>& endings, size_t most) const;

  /// Keeps a file that is sent, under `folder` (relative) and the hash of its content: the relative path. `receive`
  /// calls its argument with each piece; what it throws, or a false answer (the sender went away), leaves nothing
  /// behind. Throws InvalidArgument{"name"}, IoError, WriteError.
  std::string keep(const std::string& folder, const std::string& name,
                   const std::function<bool(const std::function<bool(const char*, size_t)>&)>& receive) const;

 private:
  std::string folder_;
};

}  // namespace seamount::server
