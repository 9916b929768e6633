#include "seamount/io/find_model.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "seamount/base/error.h"
#include "seamount/base/printable.h"

namespace seamount::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".safetensors";

void add(std::vector<std::string>& folders, const std::string& folder) {
  if (!folder.empty() && std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
}

/// share/seamount/models beside the bin/ that this program lies in; empty where that is not known.
std::string beside_program() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error || program.parent_path().filename() != "bin") return "";
  return (program.parent_path().parent_path() / "share/seamount/models").string();
}

/// share/models beside the shared library that this code is in, as in the Python package; empty in a program.
std::string beside_library() {
  Dl_info library = {};
  if (dladdr(reinterpret_cast<void*>(&beside_program), &library) == 0 || library.dli_fname == nullptr) return "";
  return (fs::path(library.dli_fname).parent_path() / "share/models").string();
}

bool is_file(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

}  // namespace

std::vector<std::string> model_folders() {
  std::vector<std::string> folders;
  if (const char* own = std::getenv("SEAMOUNT_MODELS")) {
    const std::string list = own;
    for (size_t begin = 0; begin <= list.size();) {
      const size_t end = std::min(list.find(':', begin), list.size());
      add(folders, list.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  add(folders, beside_program());
  add(folders, beside_library());
  add(folders, SEAMOUNT_SOURCE_MODELS);
  add(folders, SEAMOUNT_INSTALLED_MODELS);
  return folders;
}

std::string find_model(const std::string& name) {
  if (name.find('/') != std::string::npos || name.ends_with(kEnding)) {
    if (!is_file(name)) throw IoError(name, "is no file");
    return name;
  }
  std::string looked;
  for (const std::string& folder : model_folders()) {
    std::string path = (fs::path(folder) / (name + kEnding)).string();
    if (!name.empty() && is_file(path)) return path;
    looked += (looked.empty() ? "" : ", ") + printable(folder);
  }
  throw IoError(printable(name), "is no model: there is no " + printable(name) + kEnding + " in " + looked +
                                     " (SEAMOUNT_MODELS names more folders)");
}

}  // namespace seamount::io
