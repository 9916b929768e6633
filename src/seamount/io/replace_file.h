// The small steps of putting a finished file in the place of another. Not part of the public interface.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace seamount::io {

/// Throws WriteError{shown} unless `target` is free or a regular file that may be written. A link is refused: what it
/// leads to was not named. Returns the mode of the file that is there.
std::optional<mode_t> check_replaceable(const std::filesystem::path& target, const std::string& shown);

/// Makes sure that a file's bytes, or a folder's entries, are on the disk. Throws WriteError{shown}.
void sync_to_disk(const std::filesystem::path& place, const std::string& shown);

/// Gives a finished file the mode of the one that it is going to replace. Throws WriteError{shown}.
void take_over_mode(const std::filesystem::path& finished, std::optional<mode_t> mode, const std::string& shown);

/// Makes a folder and those above it; returns the new ones, outermost first. Throws WriteError{shown}:
/// "problem: reason".
std::vector<std::filesystem::path> make_folders(const std::filesystem::path& folder, const std::string& shown,
                                                const std::string& problem);

/// Removes folders if they are empty, innermost first.
void remove_empty_folders(const std::vector<std::filesystem::path>& folders) noexcept;

}  // namespace seamount::io
