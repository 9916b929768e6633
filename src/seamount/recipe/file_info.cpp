#include "seamount/recipe/file_info.h"

#include <algorithm>

#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/recipe/terrain_info.h"

namespace seamount::recipe {

namespace {

/// The first kind that knows a file, and what it says of it.
std::pair<const Kind*, io::FileInfo> look_at(const std::string& path, const Registry& registry) {
  io::check_readable(path);
  std::vector<std::string> known;
  for (const Kind* kind : registry.kinds()) {
    if (!kind->info) continue;
    if (auto told = kind->info(path)) return {kind, std::move(*told)};
    known.insert(known.end(), kind->reads.begin(), kind->reads.end());
  }
  const std::string extension = io::extension_of(path);
  throw IoError(path, "'" + extension + "' is not a format that can be described" + suggestion(extension, known));
}

}  // namespace

io::FileInfo describe_file(const std::string& path, const Registry& registry) {
  io::FileInfo told = look_at(path, registry).second;
  told.insert(told.begin(), {"file", path});
  const io::FileInfo more = describe_terrain(path);
  told.insert(told.end(), more.begin(), more.end());
  return told;
}

const Kind& kind_of_file(const std::string& path, const Registry& registry) { return *look_at(path, registry).first; }

}  // namespace seamount::recipe
