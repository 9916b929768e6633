#include "seamount/tiles/folder_use.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace seamount::tiles {
namespace fs = std::filesystem;

FolderUse::FolderUse(std::string folder) : folder_(std::move(folder)), file_(folder_ + ".lock") {
  std::error_code shown_by_the_first_write;
  fs::create_directories(fs::path(file_).parent_path(), shown_by_the_first_write);
  constexpr int kTries = 1000;  // each time another run removed the file between opening and locking it
  for (int i = 0; i < kTries; ++i) {
    if (open()) return;
  }
}

FolderUse::~FolderUse() {
  std::error_code ignored;
  if (lock_ >= 0 && !fs::exists(folder_, ignored))
    end_and_remove();  // the lock alone
  else
    end();
}

/// False: the file that is locked is no longer the one of that name.
bool FolderUse::open() {
  lock_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH);
  if (lock_ < 0) return true;
  while (::flock(lock_, LOCK_SH) != 0) {
    if (errno != EINTR) return true;
  }
  struct stat mine = {}, there = {};
  if (::fstat(lock_, &mine) == 0 && ::stat(file_.c_str(), &there) == 0 && mine.st_ino == there.st_ino) return true;
  end();
  return false;
}

void FolderUse::end() noexcept {
  if (lock_ >= 0) ::close(lock_);
  lock_ = -1;
}

bool FolderUse::end_and_remove() noexcept {
  if (lock_ >= 0 && ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    end();
    return false;
  }
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  fs::remove(file_, ignored);
  end();
  return true;
}

}  // namespace seamount::tiles
