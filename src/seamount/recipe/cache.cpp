#include "seamount/recipe/cache.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "seamount/io/atomic_file.h"
#include "seamount/recipe/value_bytes.h"
#include "seamount/recipe/value_stream.h"

namespace seamount::recipe {
namespace fs = std::filesystem;

Cache::Cache(std::string folder, uint64_t limit_bytes) : folder_(std::move(folder)), limit_bytes_(limit_bytes) {}

std::string Cache::path_of(const Digest& key) const { return (fs::path(folder_) / (key.hex() + ".step")).string(); }

std::string Cache::notes_path_of(const Digest& key) const {
  return (fs::path(folder_) / (key.hex() + ".notes")).string();
}

std::optional<Values> Cache::load(const Digest& key, const std::vector<Port>& ports, const Registry& registry) const {
  if (folder_.empty()) return std::nullopt;
  const std::string path = path_of(key);
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  auto values = read_values(file, registry);
  if (!values) return std::nullopt;
  for (const Port& port : ports) {
    const auto found = values->find(port.name);
    if (found == values->end() || &found->second.kind() != port.kind) return std::nullopt;
  }
  std::error_code ignored;
  fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  return values;
}

std::vector<std::string> Cache::notes(const Digest& key) const {
  std::ifstream file(notes_path_of(key), std::ios::binary);
  if (folder_.empty() || !file) return {};
  try {
    Reader reader(file);
    if (reader.text() != key.hex()) return {};
    std::vector<std::string> notes(reader.count(sizeof(uint64_t)));
    for (std::string& note : notes) note = reader.text();
    reader.finish();
    return notes;
  } catch (const Damaged&) {
    return {};
  }
}

bool Cache::store(const Digest& key, const Values& values, const std::vector<std::string>& notes) {
  uint64_t bytes = 0;
  for (const auto& [name, value] : values) bytes += value.bytes();
  if (folder_.empty() || bytes > limit_bytes_ / 2) return false;
  try {
    if (!notes.empty()) {  // before the values: who finds these finds the notes too
      io::write_atomically(notes_path_of(key), [&](const std::string& temporary) {
        std::ofstream file(temporary, std::ios::binary);
        Writer writer(file);
        writer.text(key.hex());
        writer.plain(static_cast<uint64_t>(notes.size()));
        for (const std::string& note : notes) writer.text(note);
        writer.finish();
        if (!file.flush()) throw IoError(temporary, "cannot be written");
      });
    }
    io::write_atomically(path_of(key), [&](const std::string& temporary) {
      std::ofstream file(temporary, std::ios::binary);
      write_values(file, values);
      if (!file.flush()) throw IoError(temporary, "cannot be written");
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
    fs::remove(fs::path(entry.path).replace_extension(".notes"), ignored);
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
