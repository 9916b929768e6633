// The outputs of a run, side-cars and textures included, appear together: everything is written below a private folder
// inside the output folder, and moved into place when all of it is there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/io/private_folder.h"

namespace seamount::io {

/// Use: write each output to path("maps/height.r16"), then commit(). Without a commit the output folder is left as it
/// was; it is not even there if it was not before. What killed runs left in it is removed.
class StagedFolder {
 public:
  /// Throws WriteError{out_folder} if the folder cannot be made or written to.
  explicit StagedFolder(const std::string& out_folder);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// The place to write a file to whose name in the output folder is `relative`; its folders are made. May be called
  /// from many threads. Throws WriteError if the name is empty, absolute or leads out of the folder.
  std::string path(const std::string& relative) const;

  /// The name that the file has after the commit: the output folder as it was given, and `relative`.
  std::string final_path(const std::string& relative) const;

  /// A message in which staged names are replaced by the final ones: writers name the file that they were given.
  std::string shown(std::string message) const;

  /// Moves all that was written into place: in the order of their names, each file by a rename, which replaces one of
  /// that name and keeps its mode. Waits up to half a minute while another run writes to the folder. Before the first
  /// rename every file is on the disk and every target is checked: throws WriteError{final path} if a folder, a device
  /// or a link stands there, if the file there may not be written (mode 444), or if a link would lead out of the output
  /// folder. If a rename fails, those before it are taken back. Throws Cancelled only before the first rename.
  void commit(const RunContext& run = {});

 private:
  struct Move;

  std::vector<Move> planned_moves() const;
  void check_target(Move& move) const;
  void make_parents(const Move& move);
  void move_all(std::vector<Move>& moves);
  void remove_made_folders() noexcept;

  std::string out_;
  std::vector<std::filesystem::path> made_;  ///< folders that did not exist before, outermost first
  std::optional<PrivateFolder> stage_;
};

}  // namespace seamount::io
