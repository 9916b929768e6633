#include "seamount/io/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "seamount/base/error.h"

namespace seamount::io {
namespace fs = std::filesystem;
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

constexpr const char* kTemporary = ".seamount-";

/// ".seamount-<process>-<count>-<name>" in the folder of `target`.
fs::path temporary_beside(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  const std::string stamp = std::to_string(::getpid()) + "-" + std::to_string(count++);
  return target.parent_path() / (kTemporary + stamp + "-" + target.filename().string());
}

/// Removes the temporary and what a library may have put beside it under a longer name (journals, .aux.xml).
void remove_temporaries(const fs::path& temporary) {
  std::error_code ignored;
  const std::string stem = temporary.filename().string();
  for (const fs::directory_entry& entry : fs::directory_iterator(temporary.parent_path(), ignored)) {
    std::error_code gone;
    if (entry.path().filename().string().starts_with(stem)) fs::remove(entry.path(), gone);
  }
}

/// Makes sure that a file's bytes, or a folder's entries, are on the disk.
void sync(const fs::path& place, const std::string& path) {
  const int file = ::open(place.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throw IoError(path, "cannot be written: " + reason(errno));
  const int failed = ::fsync(file) != 0 ? errno : 0;
  ::close(file);
  if (failed != 0 && failed != EINVAL) throw IoError(path, "cannot be written: " + reason(failed));
}

/// The place to write to: links are followed, folders made, devices and folders refused.
fs::path prepare_target(const std::string& path) {
  if (path.empty()) throw IoError("(no name)", "a file name is needed");
  std::error_code error;
  fs::path target = path;
  if (fs::is_symlink(target, error)) target = fs::weakly_canonical(target, error);
  target = fs::absolute(target, error);
  if (!target.has_filename() || fs::is_directory(target, error)) throw IoError(path, "is a folder, not a file name");
  if (fs::exists(target, error) && !fs::is_regular_file(target, error)) throw IoError(path, "is not a regular file");
  fs::create_directories(target.parent_path(), error);
  if (error) throw IoError(path, "its folder cannot be made: " + error.message());
  return target;
}

}  // namespace

void write_atomically(const std::string& path, const std::function<void(const std::string& temporary)>& write) {
  const fs::path target = prepare_target(path);
  const fs::path temporary = temporary_beside(target);
  try {
    write(temporary.string());
    sync(temporary, path);
    std::error_code error;
    fs::rename(temporary, target, error);
    if (error) throw IoError(path, "cannot be written: " + error.message());
    sync(target.parent_path(), path);
  } catch (...) {
    remove_temporaries(temporary);
    throw;
  }
}

void write_bytes(const std::string& path, std::span<const uint8_t> bytes) {
  write_atomically(path, [&](const std::string& temporary) {
    FileWriter file(temporary, path);
    file.write(bytes);
    file.close();
  });
}

void write_text(const std::string& path, std::string_view text) {
  write_bytes(path, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

FolderLock::FolderLock(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder, "cannot be made: " + error.message());
  handle_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle_ < 0) throw IoError(folder, "cannot be opened: " + reason(errno));
  if (::flock(handle_, LOCK_EX | LOCK_NB) == 0) {
    remove_temporaries(fs::path(folder) / kTemporary);
    return;
  }
  const int failed = errno;
  ::close(handle_);
  throw IoError(folder, failed == EWOULDBLOCK ? "another run is writing to it" : "cannot be locked: " + reason(failed));
}

FolderLock::~FolderLock() { ::close(handle_); }

FileWriter::FileWriter(const std::string& file, std::string shown_path)
    : path_(std::move(shown_path)), file_(std::fopen(file.c_str(), "wb")) {
  if (file_ == nullptr) throw IoError(path_, "cannot be written: " + reason(errno));
}

FileWriter::~FileWriter() {
  if (file_ != nullptr) std::fclose(file_);
}

void FileWriter::write(std::span<const uint8_t> bytes) {
  if (bytes.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
    throw IoError(path_, "cannot be written: " + reason(errno));
}

void FileWriter::close() {
  std::FILE* file = std::exchange(file_, nullptr);
  if (std::fclose(file) != 0) throw IoError(path_, "cannot be written: " + reason(errno));
}

void check_readable(const std::string& path) {
  if (path.empty()) throw IoError("(no name)", "a file name is needed");
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw IoError(path, "no such file");
  if (fs::is_directory(status)) throw IoError(path, "is a folder, not a file");
  if (!fs::is_regular_file(status)) throw IoError(path, "is not a regular file");
  if (::access(path.c_str(), R_OK) != 0) throw IoError(path, "cannot be read: " + reason(errno));
}

std::vector<uint8_t> read_file(const std::string& path, uint64_t max_bytes) {
  check_readable(path);
  std::error_code error;
  const uintmax_t size = fs::file_size(path, error);
  if (error) throw IoError(path, "cannot be read: " + error.message());
  if (size > max_bytes)
    throw IoError(path, "has " + std::to_string(size) + " bytes; at most " + std::to_string(max_bytes) + " are read");
  const auto close = [](std::FILE* file) { std::fclose(file); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
  if (!file) throw IoError(path, "cannot be read: " + reason(errno));
  std::vector<uint8_t> bytes(size);
  if (std::fread(bytes.data(), 1, size, file.get()) != size) throw IoError(path, "cannot be read to its end");
  return bytes;
}

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace seamount::io
