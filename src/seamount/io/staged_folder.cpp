#include "seamount/io/staged_folder.h"

#include <fcntl.h>
#include <stdio.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <set>
#include <system_error>

#include "seamount/base/error.h"
#include "seamount/io/folder_lock.h"
#include "seamount/io/replace_file.h"

namespace seamount::io {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFolderProblem = "its folder cannot be made";

/// Whether a name leads to a place inside the folder that it is relative to.
bool stays_inside(const fs::path& relative) {
  const fs::path plain = relative.lexically_normal();
  return !plain.empty() && plain.is_relative() && *plain.begin() != ".." && plain.has_filename() && plain != ".";
}

}  // namespace

/// A file's way from the stage to its target.
struct StagedFolder::Move {
  std::string name;  ///< relative to both folders
  fs::path from, to;
  std::optional<mode_t> mode;  ///< of the file that is replaced
  bool swapped = false;        ///< the earlier file lies in the stage now

  /// 0 or an error. The earlier file is kept where the file system can swap two names.
  int make() {
    swapped = mode && ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0;
    return swapped || ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
  }
  void take_back() const noexcept {
    if (swapped)
      ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE);
    else if (!mode)
      ::rename(to.c_str(), from.c_str());
  }
};

StagedFolder::StagedFolder(const std::string& out_folder) : out_(out_folder.empty() ? "." : out_folder) {
  made_ = make_folders(out_, out_, "cannot be made");
  try {
    PrivateFolder::remove_abandoned(out_);
    stage_.emplace(out_);
  } catch (...) {
    remove_made_folders();
    throw;
  }
}

StagedFolder::~StagedFolder() {
  stage_.reset();
  remove_made_folders();
}

void StagedFolder::remove_made_folders() noexcept {
  remove_empty_folders(made_);
  made_.clear();
}

std::string StagedFolder::path(const std::string& relative) const {
  if (!stays_inside(relative)) throw WriteError(final_path(relative), "is not a file name inside the output folder");
  const fs::path place = stage_->path() / fs::path(relative).lexically_normal();
  make_folders(place.parent_path(), final_path(relative), kFolderProblem);
  return place.string();
}

std::string StagedFolder::final_path(const std::string& relative) const { return (fs::path(out_) / relative).string(); }

std::string StagedFolder::shown(std::string message) const {
  const std::string staged = (stage_->path() / "").string(), final = (fs::path(out_) / "").string();
  for (size_t at = message.find(staged); at != std::string::npos; at = message.find(staged, at + final.size()))
    message.replace(at, staged.size(), final);
  return message;
}

std::vector<StagedFolder::Move> StagedFolder::planned_moves() const {
  std::vector<Move> moves;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(stage_->path(), error), end; !error && entry != end;
       entry.increment(error)) {
    if (PrivateFolder::is_private(entry->path())) entry.disable_recursion_pending();
    if (entry->is_symlink() || !entry->is_regular_file()) continue;
    const std::string name = entry->path().lexically_relative(stage_->path()).string();
    moves.push_back({name, entry->path(), {}, {}});
  }
  if (error) throw WriteError(out_, "cannot be written: " + error.message());
  std::sort(moves.begin(), moves.end(), [](const Move& a, const Move& b) { return a.name < b.name; });
  return moves;
}

void StagedFolder::check_target(Move& move) const {
  const std::string shown_path = final_path(move.name);
  std::error_code error;
  const fs::path root = fs::canonical(out_, error);
  const fs::path parent =
      error ? fs::path() : fs::weakly_canonical(root / fs::path(move.name).parent_path(), error).lexically_normal();
  if (error) throw WriteError(shown_path, "cannot be written: " + error.message());
  const fs::path way = parent.lexically_relative(root);
  if (way.empty() || *way.begin() == "..") throw WriteError(shown_path, "a link leads out of the output folder");
  move.to = parent / fs::path(move.name).filename();
  move.mode = check_replaceable(move.to, shown_path);
}

void StagedFolder::make_parents(const Move& move) {
  const std::vector<fs::path> made = make_folders(move.to.parent_path(), final_path(move.name), kFolderProblem);
  made_.insert(made_.end(), made.begin(), made.end());
}

void StagedFolder::move_all(std::vector<Move>& moves) {
  for (size_t i = 0; i < moves.size(); ++i) {
    const int failed = moves[i].make();
    if (failed == 0) continue;
    for (size_t done = i; done-- > 0;) moves[done].take_back();
    throw WriteError(final_path(moves[i].name), "cannot be written: " + std::generic_category().message(failed));
  }
}

void StagedFolder::commit(const RunContext& run) {
  constexpr std::chrono::seconds kPatience{30};
  const FolderLock lock(out_, kPatience, run);
  std::vector<Move> moves = planned_moves();
  for (Move& move : moves) {
    check_target(move);
    take_over_mode(move.from, move.mode, final_path(move.name));
    sync_to_disk(move.from, final_path(move.name));
    run.check_cancelled();
  }
  for (const Move& move : moves) make_parents(move);
  move_all(moves);
  made_.clear();
  std::set<fs::path> folders = {out_};
  for (const Move& move : moves) folders.insert(move.to.parent_path());
  for (const fs::path& folder : folders) sync_to_disk(folder, out_);
}

}  // namespace seamount::io
