#include "seamount/recipe/file_values.h"

#include "seamount/io/atomic_file.h"
#include "seamount/io/file_digest.h"
#include "seamount/io/image_file.h"
#include "seamount/io/label_image.h"

namespace seamount::recipe {
bool is_picture(const std::string& path) {
  const std::string extension = io::extension_of(path);
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

LabelMap read_label_picture(const std::string& path, const GridFrame& domain, const RunContext& run) {
  try {
    return io::decode_labels(io::read_image(path), domain, run).labels;
  } catch (const InvalidArgument& error) {
    throw IoError(path, error.what());
  }
}

Digest file_digest(const std::string& path) { return io::file_digest(path); }

}  // namespace seamount::recipe
