#include "seamount/io/private_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/hash.h"

namespace seamount::io {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPrefix = ".seamount-";
constexpr size_t kDigits = 32;

std::string random_name() {
  Digest random;
  if (::getrandom(&random, sizeof random, 0) != static_cast<ssize_t>(sizeof random))
    throw Error("the system gives no random numbers");
  return std::string(kPrefix) + random.hex();
}

/// A handle of a folder with its lock taken, or -1 if there is none or somebody else holds the lock.
int lock_folder(const fs::path& folder) {
  const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (handle < 0 || ::flock(handle, LOCK_EX | LOCK_NB) == 0) return handle;
  ::close(handle);
  return -1;
}

}  // namespace

PrivateFolder::PrivateFolder(const fs::path& parent, const std::string& shown) {
  constexpr int kTries = 100;  // one that clears up may take a new folder for an abandoned one before it is locked
  for (int i = 0; i < kTries; ++i) {
    path_ = parent / random_name();
    if (::mkdir(path_.c_str(), S_IRWXU) == 0) {
      if (make()) return;
    } else if (errno != EEXIST) {
      const std::string reason = std::generic_category().message(errno);
      throw WriteError(shown.empty() ? parent.string() : shown, "cannot be written: " + reason);
    }
  }
  throw WriteError(shown.empty() ? parent.string() : shown, "no folder for temporary files can be made");
}

/// Takes the lock; false if the folder is gone by then. Where a file system knows no locks, nobody clears up either.
bool PrivateFolder::make() {
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  struct stat mine = {}, there = {};
  const bool taken = ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (lock_ >= 0 && !taken && ::fstat(lock_, &mine) == 0 && ::stat(path_.c_str(), &there) == 0 &&
      mine.st_ino == there.st_ino)
    return true;
  if (lock_ >= 0) ::close(lock_);
  lock_ = -1;
  ::rmdir(path_.c_str());
  return false;
}

PrivateFolder::~PrivateFolder() {
  try {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  } catch (...) {
    // No memory left to remove it with: the next run does.
  }
  if (lock_ >= 0) ::close(lock_);
}

bool PrivateFolder::is_private(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name.starts_with(kPrefix) && name.size() == kPrefix.size() + kDigits &&
         name.find_first_not_of("0123456789abcdef", kPrefix.size()) == std::string::npos;
}

void PrivateFolder::remove_abandoned(const fs::path& parent) noexcept {
  try {
    std::error_code ignored;
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(parent, ignored)) {
      if (is_private(entry.path())) found.push_back(entry.path());
    }
    for (const fs::path& folder : found) {
      const int lock = lock_folder(folder);
      if (lock < 0) continue;
      fs::remove_all(folder, ignored);
      ::close(lock);
    }
  } catch (...) {
    // What is left is removed another time.
  }
}

}  // namespace seamount::io
