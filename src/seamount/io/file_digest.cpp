#include "seamount/io/file_digest.h"

#include <time.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "seamount/base/error.h"
#include "seamount/io/input_file.h"

namespace seamount::io {
namespace fs = std::filesystem;
namespace {

constexpr int64_t kSecond = 1'000'000'000;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

template <size_t kCount>
bool is_one_of(std::string_view text, const std::array<std::string_view, kCount>& names) {
  return std::find(names.begin(), names.end(), text) != names.end();
}

/// What follows the whole name: "coast.gpkg-wal", "height.png.json".
bool ends_a_name(std::string_view ending) {
  constexpr std::array<std::string_view, 6> kEndings = {".json", ".aux.xml", ".ovr", ".msk", "-wal", "-journal"};
  return is_one_of(ending, kEndings);
}

/// What stands in place of the extension: "height.tfw", "coast.dbf". World files are named after the extension.
bool replaces_an_extension(const std::string& extension, const std::string& own) {
  constexpr std::array<std::string_view, 15> kExtensions = {".prj", ".qpj", ".wld", ".aux", ".tab",
                                                            ".hdr", ".rrd", ".shx", ".dbf", ".cpg",
                                                            ".qix", ".sbn", ".sbx", ".idm", ".ind"};
  if (extension == own) return false;
  if (is_one_of(extension, kExtensions) || extension == own + "w") return true;
  return own.size() > 2 && extension == std::string(".") + own[1] + own.back() + "w";
}

bool belongs_to(const fs::path& candidate, const fs::path& file) {
  const std::string name = lower(candidate.filename().string()), own = lower(file.filename().string());
  if (name.starts_with(own) && ends_a_name(std::string_view(name).substr(own.size()))) return true;
  const std::string stem = fs::path(own).stem().string();
  if (name == stem + ".aux.xml") return true;
  return fs::path(name).stem() == stem &&
         replaces_an_extension(fs::path(name).extension().string(), fs::path(own).extension().string());
}

void add_companions(const fs::path& file, std::vector<std::string>& found) {
  std::error_code ignored;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
    std::error_code gone;
    if (belongs_to(entry->path(), file) && entry->is_regular_file(gone) && entry->file_size(gone) > 0)
      found.push_back(entry->path().string());
  }
}

void hash_content(const std::string& path, const RunContext& run, Hasher& hasher) {
  InputFile file(path);
  std::vector<std::byte> buffer(1 << 20);
  for (size_t count = buffer.size(); count == buffer.size();) {
    run.check_cancelled();
    count = file.read(buffer);
    hasher.bytes(std::span(buffer).first(count));
  }
}

int64_t nanoseconds(const timespec& time) { return time.tv_sec * kSecond + time.tv_nsec; }

}  // namespace

std::vector<std::string> companions_of(const std::string& path) {
  std::vector<std::string> found;
  add_companions(path, found);
  std::error_code error;
  if (fs::is_symlink(path, error)) {
    const fs::path real = fs::canonical(path, error);
    if (!error) add_companions(real, found);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

FileSnapshot::Identity FileSnapshot::identity_of(const std::string& path) {
  const struct stat now = InputFile(path).status();
  return {path,
          now.st_dev,
          now.st_ino,
          static_cast<uint64_t>(now.st_size),
          nanoseconds(now.st_mtim),
          nanoseconds(now.st_ctim)};
}

std::vector<FileSnapshot::Identity> FileSnapshot::identities() const {
  std::vector<Identity> all = {identity_of(path_)};
  for (const std::string& companion : companions_of(path_)) all.push_back(identity_of(companion));
  return all;
}

FileSnapshot::FileSnapshot(const std::string& path, const RunContext& run) : path_(path) {
  constexpr int kTries = 5;
  for (int i = 0; i < kTries; ++i) {
    try {
      read(run);
      if (identities() == files_) return;
    } catch (const IoError& error) {
      if (error.path() == path_ || i + 1 == kTries) throw;  // else a companion went away just now
    }
  }
  throw IoError(path, "is being written to by another program");
}

void FileSnapshot::read(const RunContext& run) {
  timespec now = {};
  ::clock_gettime(CLOCK_REALTIME, &now);
  files_ = identities();
  Hasher hasher;
  for (const Identity& file : files_) {
    if (file.path != path_) hasher.text(lower(fs::path(file.path).extension().string()));
    hash_content(file.path, run, hasher.number(file.size));
  }
  digest_ = hasher.digest();
  young_ = std::any_of(files_.begin(), files_.end(), [&](const Identity& file) {
    return nanoseconds(now) - std::max(file.written_ns, file.changed_ns) < 2 * kSecond;
  });
}

bool FileSnapshot::still_valid(const RunContext& run) const {
  try {
    if (identities() != files_) return false;
    return !young_ || FileSnapshot(path_, run).digest() == digest_;
  } catch (const IoError&) {
    return false;  // gone
  }
}

Digest content_digest(const std::string& path, const RunContext& run) {
  Hasher hasher;
  hash_content(path, run, hasher);
  return hasher.digest();
}

Digest file_digest(const std::string& path, const RunContext& run) { return FileSnapshot(path, run).digest(); }

}  // namespace seamount::io
