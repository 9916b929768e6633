#include "seamount/tiles/stored_notes.h"

#include <filesystem>
#include <fstream>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"

namespace seamount::tiles {
namespace fs = std::filesystem;

StoredNotes::StoredNotes(std::string folder, int count)
    : folder_(std::move(folder)), count_(count), use_(std::make_unique<FolderUse>(folder_)) {}

std::string StoredNotes::path_of(int64_t tile) const {
  return (fs::path(folder_) / (std::to_string(tile) + ".note")).string();
}

bool StoredNotes::has(int64_t tile) const {
  std::error_code none_there;
  return fs::is_regular_file(path_of(tile), none_there);
}

bool StoredNotes::complete() const {
  for (int tile = 0; tile < count_; ++tile) {
    if (!has(tile)) return false;
  }
  return true;
}

void StoredNotes::write_bytes(int64_t tile, const std::function<void(recipe::Writer&)>& write) const {
  const std::string path = path_of(tile);
  const auto write_file = [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    recipe::Writer writer(file);
    write(writer);
    writer.finish();
    if (!file.flush()) throw WriteError(path, "cannot be written");
  };
  io::write_atomically(path, write_file, io::Durable::later);
}

void StoredNotes::read_bytes(int64_t tile, const std::function<void(recipe::Reader&)>& read) const {
  const std::string path = path_of(tile);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError(path, "what this run needs of a tile has gone; run again");
  try {
    recipe::Reader reader(file);
    read(reader);
    reader.finish();
  } catch (const recipe::Damaged&) {
    std::error_code gone;
    fs::remove(path, gone);
    throw IoError(path, "what the cache knows of a tile is damaged and was removed; run again");
  }
}

}  // namespace seamount::tiles
