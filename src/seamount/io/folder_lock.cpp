#include "seamount/io/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "seamount/base/error.h"
#include "seamount/io/private_folder.h"
#include "seamount/io/replace_file.h"

namespace seamount::io {
namespace {

using Clock = std::chrono::steady_clock;

/// 0, or the error that stayed until the end of the wait.
int lock_within(int handle, std::chrono::milliseconds patience, const RunContext& run) {
  const Clock::time_point end = Clock::now() + patience;
  while (::flock(handle, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK || Clock::now() >= end) return errno;
    run.check_cancelled();
    constexpr timespec kPause{0, 10'000'000};
    ::nanosleep(&kPause, nullptr);
  }
  return 0;
}

}  // namespace

FolderLock::FolderLock(const std::string& folder, std::chrono::milliseconds patience, const RunContext& run) {
  make_folders(folder, folder, "cannot be made");
  handle_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle_ < 0) throw WriteError(folder, "cannot be opened: " + std::generic_category().message(errno));
  int failed = ECANCELED;
  try {
    failed = lock_within(handle_, patience, run);
  } catch (...) {
    ::close(handle_);
    throw;
  }
  if (failed == 0) {
    PrivateFolder::remove_abandoned(folder);
    return;
  }
  ::close(handle_);
  throw WriteError(folder, failed == EWOULDBLOCK ? "another run is writing to it"
                                                 : "cannot be locked: " + std::generic_category().message(failed));
}

FolderLock::~FolderLock() { ::close(handle_); }

}  // namespace seamount::io
