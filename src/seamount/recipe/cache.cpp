#include "seamount/recipe/cache.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "seamount/io/atomic_file.h"
#include "seamount/io/private_folder.h"
#include "seamount/recipe/value_bytes.h"

namespace seamount::recipe {
namespace fs = std::filesystem;

namespace {

/// The key that follows the values of an entry: a file that was renamed or copied is no entry of its new name.
void write_key(std::ostream& file, const Digest& key) { file << key.hex(); }

bool has_key(std::istream& file, const Digest& key) {
  std::string found(key.hex().size(), '\0');
  return file.read(found.data(), static_cast<std::streamsize>(found.size())) && found == key.hex() &&
         file.peek() == std::istream::traits_type::eof();
}

}  // namespace

Cache::Cache(std::string folder, uint64_t limit_bytes) : folder_(std::move(folder)), limit_bytes_(limit_bytes) {
  if (!folder_.empty()) io::PrivateFolder::remove_abandoned(folder_);
}

std::string Cache::path_of(const Digest& key) const { return (fs::path(folder_) / (key.hex() + ".step")).string(); }

std::optional<Values> Cache::load(const Digest& key, const std::vector<Port>& ports, const Registry& registry) const {
  if (folder_.empty()) return std::nullopt;
  const std::string path = path_of(key);
  std::error_code ignored;
  std::ifstream file;
  if (fs::is_regular_file(path, ignored)) file.open(path, std::ios::binary);
  if (!file.is_open()) return std::nullopt;
  auto values = read_values(file, registry);
  if (!values || !has_key(file, key)) return std::nullopt;
  for (const Port& port : ports) {
    const auto found = values->find(port.name);
    if (found == values->end() || &found->second.kind() != port.kind) return std::nullopt;
  }
  fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  return values;
}

bool Cache::store(const Digest& key, const Values& values) {
  uint64_t bytes = 0;
  for (const auto& [name, value] : values) bytes += value.bytes();
  if (folder_.empty() || bytes > limit_bytes_ / 2) return false;
  try {
    io::write_atomically(path_of(key), [&](const std::string& temporary) {
      std::ofstream file(temporary, std::ios::binary);
      write_values(file, values);
      write_key(file, key);
      if (!file.flush()) throw WriteError(temporary, "cannot be written");
    });
  } catch (const IoError&) {
    return false;
  }
  trim();
  return true;
}

void Cache::trim() const {
  struct Entry {
    fs::file_time_type used;
    uint64_t bytes;
    fs::path path;
  };
  std::vector<Entry> entries;
  uint64_t total = 0;
  std::error_code ignored;
  for (const auto& item : fs::directory_iterator(folder_, ignored)) {
    if (item.path().extension() != ".step") continue;
    const Entry entry{item.last_write_time(ignored), item.file_size(ignored), item.path()};
    total += entry.bytes;
    entries.push_back(entry);
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
  for (const Entry& entry : entries) {
    if (total <= limit_bytes_) break;
    fs::remove(entry.path, ignored);
    total -= entry.bytes;
  }
}

std::string Cache::default_folder() {
  if (const char* own = std::getenv("SEAMOUNT_CACHE")) return own;
  if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg != nullptr && *xdg != '\0')
    return std::string(xdg) + "/seamount";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return std::string(home) + "/.cache/seamount";
  return "";
}

}  // namespace seamount::recipe
