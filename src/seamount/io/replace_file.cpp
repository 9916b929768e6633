#include "seamount/io/replace_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "seamount/base/error.h"

namespace seamount::io {
namespace fs = std::filesystem;
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace

std::optional<mode_t> check_replaceable(const fs::path& target, const std::string& shown) {
  struct stat there = {};
  if (::lstat(target.c_str(), &there) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
    throw WriteError(shown, "cannot be written: " + reason(errno));
  }
  if (S_ISDIR(there.st_mode)) throw WriteError(shown, "is a folder, not a file name");
  if (S_ISLNK(there.st_mode)) throw WriteError(shown, "is a link; name the file that it leads to, or remove it");
  if (!S_ISREG(there.st_mode)) throw WriteError(shown, "is not a regular file");
  if ((there.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0)
    throw WriteError(shown, "is read-only; make it writable, or choose another name");
  if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0)
    throw WriteError(shown, "cannot be written: " + reason(errno));
  return there.st_mode & static_cast<mode_t>(~S_IFMT);
}

void sync_to_disk(const fs::path& place, const std::string& shown) {
  const int file = ::open(place.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) throw WriteError(shown, "cannot be written: " + reason(errno));
  const int failed = ::fsync(file) != 0 ? errno : 0;
  ::close(file);
  if (failed != 0 && failed != EINVAL) throw WriteError(shown, "cannot be written: " + reason(failed));
}

void take_over_mode(const fs::path& finished, std::optional<mode_t> mode, const std::string& shown) {
  if (mode && ::chmod(finished.c_str(), *mode) != 0) throw WriteError(shown, "cannot keep its mode: " + reason(errno));
}

std::vector<fs::path> make_folders(const fs::path& folder, const std::string& shown, const std::string& problem) {
  std::error_code error;
  std::vector<fs::path> missing, made;
  for (fs::path at = fs::absolute(folder, error); !at.empty() && !fs::exists(at, error) && at != at.parent_path();
       at = at.parent_path())
    missing.push_back(at);
  for (auto at = missing.rbegin(); at != missing.rend(); ++at) {
    if (fs::create_directory(*at, error)) made.push_back(*at);
    if (!error) continue;
    remove_empty_folders(made);
    throw WriteError(shown, problem + ": " + error.message());
  }
  if (fs::is_directory(folder, error)) return made;
  throw WriteError(shown, problem + ": " + reason(ENOTDIR));
}

void remove_empty_folders(const std::vector<fs::path>& folders) noexcept {
  std::for_each(folders.rbegin(), folders.rend(), [](const fs::path& folder) { ::rmdir(folder.c_str()); });
}

}  // namespace seamount::io
