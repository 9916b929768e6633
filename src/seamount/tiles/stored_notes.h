// What tiles say of themselves for the passes that follow, on disk: a small file for each, written whole or not at all,
// checksummed. Like the tiles it is of use to the run that goes on after a killed one.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "seamount/recipe/value_stream.h"
#include "seamount/tiles/folder_use.h"

namespace seamount::tiles {

class StoredNotes {
 public:
  /// One of each of `count` tiles, or of other numbers, in `folder`, which belongs to them and is used as long as this
  /// lives.
  StoredNotes(std::string folder, int count);

  bool has(int64_t tile) const;
  bool complete() const;

  /// Lists of plain values. Throws WriteError.
  template <class... T>
  void write(int64_t tile, const std::vector<T>&... lists) const {
    write_bytes(tile, [&](recipe::Writer& writer) { (writer.list(lists), ...); });
  }
  /// The same lists. Throws IoError for a note that is missing or damaged; the latter is removed.
  template <class... T>
  void read(int64_t tile, std::vector<T>&... lists) const {
    read_bytes(tile, [&](recipe::Reader& reader) { ((lists = reader.list<T>()), ...); });
  }

  /// Uses them no longer; removes them, unless another run uses them.
  void let_go() const noexcept { use_->end(); }
  void remove() const noexcept { use_->end_and_remove(); }

 private:
  std::string path_of(int64_t tile) const;
  void write_bytes(int64_t tile, const std::function<void(recipe::Writer&)>& write) const;
  void read_bytes(int64_t tile, const std::function<void(recipe::Reader&)>& read) const;

  std::string folder_;
  int count_;
  std::unique_ptr<FolderUse> use_;
};

}  // namespace seamount::tiles
