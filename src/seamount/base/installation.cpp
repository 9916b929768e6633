#include "seamount/base/installation.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace seamount {
namespace {

namespace fs = std::filesystem;

struct Place {
  const char* variable;    ///< of the environment; nullptr: none
  const char* folder;      ///< below share/seamount
  const char* of_sources;  ///< below the checkout
};

constexpr Place kPlaces[] = {{"SEAMOUNT_MODELS", "models", "models"},
                             {nullptr, "recipes", "recipes"},
                             {nullptr, "data", "data"},
                             {"SEAMOUNT_STUDIO", "studio", "studio/dist/page"}};

/// The shared library that this code is in; empty in a program, which the loader names as its caller did.
fs::path library_file() {
  Dl_info library = {};
  if (dladdr(reinterpret_cast<void*>(&program_file), &library) == 0 || library.dli_fname == nullptr) return {};
  const fs::path file = library.dli_fname;
  std::error_code error;
  const bool is_program = !file.has_parent_path() || fs::equivalent(file, program_file(), error);
  return is_program ? fs::path() : file;
}

bool lies_in(const fs::path& file, const fs::path& of) {
  std::error_code error;
  const fs::path folder = fs::canonical(of, error);  // program_file() has no links either
  return !error && std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

}  // namespace

fs::path program_file() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

std::vector<std::string> shared_folders(Shared kind) {
  const Place& place = kPlaces[static_cast<int>(kind)];
  std::vector<std::string> folders;
  const auto add = [&](const std::string& folder) {
    if (!folder.empty() && std::find(folders.begin(), folders.end(), folder) == folders.end())
      folders.push_back(folder);
  };
  if (const char* own = place.variable != nullptr ? std::getenv(place.variable) : nullptr) {
    const std::string list = own;
    for (size_t begin = 0; begin <= list.size();) {
      const size_t end = std::min(list.find(':', begin), list.size());
      add(list.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  if (const fs::path library = library_file(); !library.empty())
    add((library.parent_path() / "share" / place.folder).string());
  const fs::path program = program_file();
  if (program.parent_path().filename() == "bin")
    add((program.parent_path().parent_path() / "share/seamount" / place.folder).string());
  if (lies_in(program, SEAMOUNT_BUILD_FOLDER)) add((fs::path(SEAMOUNT_SOURCE_FOLDER) / place.of_sources).string());
  for (const fs::path share : {SEAMOUNT_INSTALLED_SHARE, "/usr/share"})
    add((share / "seamount" / place.folder).string());
  return folders;
}

std::string find_shared_folder(Shared kind) {
  for (const std::string& folder : shared_folders(kind)) {
    std::error_code error;
    if (fs::is_directory(folder, error)) return folder;
  }
  return "";
}

}  // namespace seamount
