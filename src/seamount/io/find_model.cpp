#include "seamount/io/find_model.h"

#include <filesystem>

#include "seamount/base/error.h"
#include "seamount/base/installation.h"
#include "seamount/base/printable.h"

namespace seamount::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".safetensors";

bool is_file(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

}  // namespace

std::string find_model(const std::string& name) {
  if (name.find('/') != std::string::npos || name.ends_with(kEnding)) {
    if (!is_file(name)) throw IoError(name, "is no file");
    return name;
  }
  std::string looked;
  for (const std::string& folder : shared_folders(Shared::models)) {
    std::string path = (fs::path(folder) / (name + kEnding)).string();
    if (!name.empty() && is_file(path)) return path;
    looked += (looked.empty() ? "" : ", ") + printable(folder);
  }
  throw IoError(printable(name), "is no model: there is no " + printable(name) + kEnding + " in " + looked +
                                     " (SEAMOUNT_MODELS names more folders)");
}

}  // namespace seamount::io
