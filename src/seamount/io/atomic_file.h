// Files that appear whole or not at all: written in a private folder beside their place, synced, then renamed. Every
// writer of this module goes through here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace seamount::io {

/// Is a file on the disk when it appears, or soon after? The latter is for files of the cache with checksums, which may
/// be damaged when the machine's power fails, not when the program is killed.
enum class Durable { at_once, later };

/// Calls write(temporary) and renames what it wrote to `path`. Missing parent folders are created. The temporary file
/// has the same name, in a private folder beside it (private_folder.h). A file that is replaced hands its mode on.
/// Whatever fails (write() itself, a full disk, a folder or a link in the way, an earlier file that is read-only), no
/// temporary stays, the earlier file stays as it was, and WriteError{path} is thrown; other exceptions of write() pass
/// through.
void write_atomically(const std::string& path, const std::function<void(const std::string& temporary)>& write,
                      Durable durable = Durable::at_once);

/// The same for bytes at hand.
void write_bytes(const std::string& path, std::span<const uint8_t> bytes);
void write_text(const std::string& path, std::string_view text);

/// A file that is written piece by piece inside write_atomically(); every call that fails throws
/// WriteError{shown_path}.
class FileWriter {
 public:
  FileWriter(const std::string& file, std::string shown_path);
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  void write(std::span<const uint8_t> bytes);
  /// A plain value or an array of them as they are in memory.
  template <class T>
  void write_raw(std::span<const T> values) {
    write({reinterpret_cast<const uint8_t*>(values.data()), values.size_bytes()});
  }
  void close();

 private:
  std::string path_;
  std::FILE* file_;
};

/// Throws IoError unless `path` is a regular file that may be read.
void check_readable(const std::string& path);

/// The whole file. Throws IoError if it is missing, not a regular file, or larger than max_bytes.
std::vector<uint8_t> read_file(const std::string& path, uint64_t max_bytes = uint64_t{4} << 30);

/// Lower-case extension with its dot: ".tif"; empty if there is none.
std::string extension_of(const std::string& path);

}  // namespace seamount::io
