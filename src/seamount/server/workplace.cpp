#include "seamount/server/workplace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <span>

#include "seamount/base/error.h"
#include "seamount/base/hash.h"
#include "seamount/io/atomic_file.h"

namespace seamount::server {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 3;
constexpr size_t kLongestName = 1024;

bool is_control(char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }

/// A name that is fit for any file system: what else was in it is a dash.
std::string plain_name(const std::string& name) {
  std::string plain;
  for (const char c : fs::path(name).filename().string()) {
    const bool fits = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
    plain += fits ? c : '-';
  }
  while (!plain.empty() && plain.front() == '.') plain.erase(0, 1);
  return plain.size() > 80 ? plain.substr(plain.size() - 80) : plain;
}

}  // namespace

Workplace::Workplace(const std::string& folder) {
  std::error_code error;
  folder_ = fs::canonical(folder, error).string();
  if (error || !fs::is_directory(folder_, error)) throw IoError(folder, "is no folder");
}

std::string Workplace::resolve(const std::string& name) const {
  const fs::path relative(name);
  if (name.empty() || name.size() > kLongestName || relative.is_absolute() ||
      std::any_of(name.begin(), name.end(), is_control))
    throw InvalidArgument("path", "is no name of a file in the studio's folder");
  for (const fs::path& part : relative) {
    if (part == "..") throw InvalidArgument("path", "leads out of the studio's folder");
  }
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::path(folder_) / relative, error);
  const std::string text = whole.string();
  const std::string inside = folder_ == "/" ? "/" : folder_ + "/";
  if (error || text.compare(0, inside.size(), inside) != 0 || text.size() == inside.size())
    throw InvalidArgument("path", "leads out of the studio's folder");
  return text;
}

std::vector<FileEntry> Workplace::list(const std::vector<std::string>& endings, size_t most) const {
  std::vector<FileEntry> files;
  std::error_code error;
  fs::recursive_directory_iterator walk(folder_, fs::directory_options::skip_permission_denied, error);
  constexpr size_t kMostSeen = 20000;
  size_t seen = 0;
  for (; !error && walk != fs::recursive_directory_iterator() && ++seen < kMostSeen; walk.increment(error)) {
    const fs::path& path = walk->path();
    std::error_code ignored;
    const bool hidden = path.filename().string().front() == '.';
    if (walk->is_directory(ignored) && (hidden || walk.depth() + 1 >= kDeepest || walk->is_symlink(ignored)))
      walk.disable_recursion_pending();
    if (hidden || walk->is_symlink(ignored) || !walk->is_regular_file(ignored)) continue;
    const std::string ending = io::extension_of(path.string());
    if (std::find(endings.begin(), endings.end(), ending) == endings.end()) continue;
    const auto age = fs::file_time_type::clock::now() - walk->last_write_time(ignored);
    const auto time = std::chrono::system_clock::now() - age;
    files.push_back({path.lexically_relative(folder_).generic_string(), walk->file_size(ignored),
                     std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count()});
  }
  std::sort(files.begin(), files.end(), [](const FileEntry& a, const FileEntry& b) {
    return a.modified != b.modified ? a.modified > b.modified : a.path < b.path;
  });
  files.resize(std::min(files.size(), most));
  return files;
}

std::string Workplace::keep(const std::string& folder, const std::string& name,
                            const std::function<bool(const std::function<bool(const char*, size_t)>&)>& receive) const {
  const std::string plain = plain_name(name);
  if (plain.empty() || io::extension_of(plain).empty())
    throw InvalidArgument("name", "needs an ending that says what the file is");
  const fs::path target = resolve(folder);
  Hasher hasher;
  // Under a name of its own first: the right one is known when all is there.
  const fs::path arriving = target / fmt::format(".arriving-{}-{}", fmt::ptr(&hasher), plain);
  io::write_atomically(arriving.string(), [&](const std::string& temporary) {
    io::FileWriter file(temporary, plain);
    const bool whole = receive([&](const char* data, size_t size) {
      const std::span<const uint8_t> piece(reinterpret_cast<const uint8_t*>(data), size);
      hasher.bytes(std::as_bytes(piece));
      file.write(piece);
      return true;
    });
    if (!whole) throw InvalidArgument("the body", "did not arrive as a whole");
    file.close();
  });
  const fs::path kept = target / fmt::format("{}-{}", hasher.digest().hex().substr(0, 12), plain);
  std::error_code error;
  fs::rename(arriving, kept, error);
  if (error) {
    fs::remove(arriving, error);
    throw WriteError(kept.string(), "cannot be written");
  }
  return kept.lexically_relative(folder_).generic_string();
}

}  // namespace seamount::server
