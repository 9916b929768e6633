// A file that is read. Only regular files are: a device without end, a pipe that nobody writes to and a loop of links
// are refused at once.
#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <span>
#include <string>

#include "seamount/base/run_context.h"

namespace seamount::io {

class InputFile {
 public:
  /// Throws IoError{path}: missing, a folder, not a regular file, not to be read.
  explicit InputFile(const std::string& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Fills `bytes` as far as the file goes; returns how many there were. Throws IoError.
  size_t read(std::span<std::byte> bytes);

  /// Size, times and number of the open file. Throws IoError.
  struct stat status() const;

 private:
  std::string path_;
  int handle_;
};

/// The text of a regular file, or of a stream that was opened before the program started: /dev/stdin, /dev/fd/N. At
/// most `most` bytes; what is longer is cut there. Throws IoError; Cancelled, also while it waits for a stream.
std::string read_text(const std::string& path, size_t most, const RunContext& run = {});

}  // namespace seamount::io
