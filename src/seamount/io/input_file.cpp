#include "seamount/io/input_file.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "seamount/base/error.h"

namespace seamount::io {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  if (error == ENOENT || error == ENOTDIR) throw IoError(path, "no such file");
  if (error == ENXIO) throw IoError(path, "is not a regular file");
  throw IoError(path, "cannot be read: " + std::generic_category().message(error));
}

bool is_stream(const std::string& path) {
  struct stat there = {};
  const bool opened_before = path == "/dev/stdin" || path.starts_with("/dev/fd/") || path.starts_with("/proc/self/fd/");
  return opened_before && ::stat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode);
}

/// A handle that is closed at the end of a block.
struct Handle {
  int number;
  ~Handle() { ::close(number); }
};

std::string read_stream(const std::string& path, size_t most, const RunContext& run) {
  const Handle stream{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)};
  if (stream.number < 0) fail(path, errno);
  std::string text;
  for (std::array<char, 1 << 16> block{}; text.size() < most;) {
    run.check_cancelled();
    constexpr int kPatienceMs = 50;
    pollfd waiting{stream.number, POLLIN, 0};
    if (::poll(&waiting, 1, kPatienceMs) <= 0) continue;
    const ssize_t count = ::read(stream.number, block.data(), block.size());
    if (count == 0) break;
    if (count > 0) text.append(block.data(), std::min(static_cast<size_t>(count), most - text.size()));
    if (count < 0 && errno != EINTR && errno != EAGAIN) fail(path, errno);
  }
  return text;
}

}  // namespace

InputFile::InputFile(const std::string& path) : path_(path) {
  if (path.empty()) throw IoError("(no name)", "a file name is needed");
  struct stat there = {};
  if (::stat(path.c_str(), &there) != 0) fail(path, errno);
  if (S_ISDIR(there.st_mode)) throw IoError(path, "is a folder, not a file");
  if (!S_ISREG(there.st_mode)) throw IoError(path, "is not a regular file");
  // Whatever may stand there by now: opening it does not wait.
  handle_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (handle_ < 0) fail(path, errno);
  if (::fstat(handle_, &there) == 0 && S_ISREG(there.st_mode)) return;
  ::close(handle_);
  throw IoError(path, "is not a regular file");
}

InputFile::~InputFile() { ::close(handle_); }

size_t InputFile::read(std::span<std::byte> bytes) {
  size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::read(handle_, bytes.data() + done, bytes.size() - done);
    if (count == 0) break;
    if (count > 0) done += static_cast<size_t>(count);
    if (count < 0 && errno != EINTR) fail(path_, errno);
  }
  return done;
}

struct stat InputFile::status() const {
  struct stat now = {};
  if (::fstat(handle_, &now) != 0) fail(path_, errno);
  return now;
}

std::string read_text(const std::string& path, size_t most, const RunContext& run) {
  if (is_stream(path)) return read_stream(path, most, run);
  InputFile file(path);
  std::string text(std::min(most, static_cast<size_t>(file.status().st_size)), '\0');
  text.resize(file.read(std::as_writable_bytes(std::span(text))));
  return text;
}

}  // namespace seamount::io
