#include "seamount/server/page.h"

#include <filesystem>
#include <span>

#include "seamount/base/error.h"
#include "seamount/base/hash.h"
#include "seamount/base/installation.h"
#include "seamount/io/atomic_file.h"

namespace seamount::server {
namespace {

namespace fs = std::filesystem;

std::string type_of(const std::string& name) {
  static const std::map<std::string, std::string> kTypes = {{".html", "text/html; charset=utf-8"},
                                                            {".js", "text/javascript; charset=utf-8"},
                                                            {".css", "text/css; charset=utf-8"},
                                                            {".svg", "image/svg+xml"},
                                                            {".png", "image/png"},
                                                            {".txt", "text/plain; charset=utf-8"}};
  const auto found = kTypes.find(io::extension_of(name));
  return found == kTypes.end() ? "application/octet-stream" : found->second;
}

std::string read(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return "";
  const std::vector<uint8_t> bytes = io::read_file(path.string(), uint64_t{64} << 20);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

Page::Page(const std::string& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const std::string ending = io::extension_of(name);
    if (!entry.is_regular_file() || ending == ".br" || ending == ".gz") continue;
    File file{type_of(name), read(entry.path()), read(entry.path().string() + ".br"),
              read(entry.path().string() + ".gz"), ""};
    file.version = hash_bytes(std::as_bytes(std::span(file.bytes))).hex();
    files_["/" + name] = std::move(file);
  }
  if (!files_.contains("/index.html")) throw IoError(folder, "holds no page of the studio");
}

const Page::File* Page::find(const std::string& path) const {
  const auto found = files_.find(path == "/" ? "/index.html" : path);
  return found == files_.end() ? nullptr : &found->second;
}

std::string find_page() {
  const std::vector<std::string> folders = shared_folders(Shared::studio);
  std::error_code error;
  for (const std::string& folder : folders) {
    if (fs::is_regular_file(fs::path(folder) / "index.html", error)) return folder;
  }
  throw IoError(folders.front(), "the studio's page is not built: './run studio' does it (needs nodejs and npm)");
}

}  // namespace seamount::server
