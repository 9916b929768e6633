#include "seamount/io/atomic_file.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "seamount/base/error.h"
#include "seamount/io/input_file.h"
#include "seamount/io/private_folder.h"
#include "seamount/io/replace_file.h"

namespace seamount::io {
namespace fs = std::filesystem;
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace

void write_atomically(const std::string& path, const std::function<void(const std::string& temporary)>& write,
                      Durable durable) {
  if (path.empty()) throw WriteError("(no name)", "a file name is needed");
  const fs::path target = path;
  if (!target.has_filename()) throw WriteError(path, "is a folder, not a file name");
  const fs::path folder = target.has_parent_path() ? target.parent_path() : ".";
  const std::optional<mode_t> mode = check_replaceable(target, path);
  if (!mode) make_folders(folder, path, "its folder cannot be made");
  const PrivateFolder own(folder, path);
  const fs::path temporary = own.path() / target.filename();
  try {
    write(temporary.string());
  } catch (const WriteError&) {
    throw;
  } catch (const IoError& error) {  // of a library that knows one kind only
    throw WriteError(error.path(), std::string(error.what()).substr(error.path().size() + 2));
  }
  take_over_mode(temporary, mode, path);
  if (durable == Durable::at_once) sync_to_disk(temporary, path);
  if (::rename(temporary.c_str(), target.c_str()) != 0) throw WriteError(path, "cannot be written: " + reason(errno));
  if (durable == Durable::at_once) sync_to_disk(folder, path);
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

FileWriter::FileWriter(const std::string& file, std::string shown_path)
    : path_(std::move(shown_path)), file_(std::fopen(file.c_str(), "wb")) {
  if (file_ == nullptr) throw WriteError(path_, "cannot be written: " + reason(errno));
}

FileWriter::~FileWriter() {
  if (file_ != nullptr) std::fclose(file_);
}

void FileWriter::write(std::span<const uint8_t> bytes) {
  if (bytes.empty()) return;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
    throw WriteError(path_, "cannot be written: " + reason(errno));
}

void FileWriter::close() {
  std::FILE* file = std::exchange(file_, nullptr);
  if (std::fclose(file) != 0) throw WriteError(path_, "cannot be written: " + reason(errno));
}

void check_readable(const std::string& path) { const InputFile file(path); }

std::vector<uint8_t> read_file(const std::string& path, uint64_t max_bytes) {
  InputFile file(path);
  const auto size = static_cast<uint64_t>(file.status().st_size);
  if (size > max_bytes)
    throw IoError(path, "has " + std::to_string(size) + " bytes; at most " + std::to_string(max_bytes) + " are read");
  std::vector<uint8_t> bytes(size);
  if (file.read(std::as_writable_bytes(std::span(bytes))) != size) throw IoError(path, "cannot be read to its end");
  return bytes;
}

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace seamount::io
