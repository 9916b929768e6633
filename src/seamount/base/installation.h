// Where the files lie that come with Seamount: networks, recipes, data, the studio's page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace seamount {

enum class Shared { models, recipes, data, studio };

/// The program that runs, all links followed; empty where the system does not tell.
std::filesystem::path program_file();

/// The folders in which files of a kind are looked for, the first first, each once:
///   1. those that the environment names, separated by colons: SEAMOUNT_MODELS, SEAMOUNT_STUDIO
///   2. share/KIND beside the shared library that this code is part of: the Python package
///   3. ../share/seamount/KIND of the running program: what is installed, wherever that was moved to
///   4. those of the sources, only for a program that lies in the build folder: what is installed knows no checkout
///   5. share/seamount/KIND of where an installation was meant to go, and of /usr
/// Not all of them need exist.
std::vector<std::string> shared_folders(Shared kind);

/// The first of shared_folders() that is there; empty where none is.
std::string find_shared_folder(Shared kind);

}  // namespace seamount
