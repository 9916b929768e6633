#include "seamount/recipe/file_values.h"

#include <filesystem>
#include <fstream>
#include <vector>

#include "seamount/geom/contour/lines.h"
#include "seamount/geom/contour/marching_triangles.h"
#include "seamount/geom/polygon/frame_around.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/io/label_image.h"
#include "seamount/io/raster.h"
#include "seamount/io/tin_file.h"
#include "seamount/io/vector.h"

namespace seamount::recipe {
namespace {

void hash_file(const std::string& path, Hasher& hasher) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError(path, std::filesystem::exists(path) ? "cannot be read" : "no such file");
  std::vector<char> buffer(1 << 20);
  while (file) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    hasher.bytes(std::as_bytes(std::span(buffer.data(), static_cast<size_t>(file.gcount()))));
  }
}

ContourSet read_contour_file(const std::string& path, const GridFrame& frame) {
  try {
    return geom::contours_from_lines(io::read_drawing(path), frame, "contours");
  } catch (const InvalidArgument& error) {
    throw IoError(path, error.what());
  }
}

Tin read_tin_file(const std::string& path, const GridFrame& frame) {
  Tin tin = io::read_tin(path);
  if (tin.frame.cells() == 0) {
    const std::string crs = tin.frame.crs;
    tin.frame = geom::frame_around(tin.nodes, frame);
    if (!crs.empty()) tin.frame.crs = crs;
  }
  if (const auto defect = geom::find_tin_defect(tin)) throw IoError(path, *defect);
  return tin;
}

}  // namespace

Value read_value_file(const std::string& path, ValueKind kind, const GridFrame& frame, const RunContext& run) {
  run.check_cancelled();
  switch (kind) {
    case ValueKind::terrain:
      return Value::terrain(io::read_heights(path));
    case ValueKind::field:
      return Value::field(io::read_field(path));
    case ValueKind::labels:
      if (io::extension_of(path) == ".png" && !std::filesystem::exists(path + ".json"))
        return Value::labels(read_label_picture(path, frame, run));
      return Value::labels(io::read_labels(path));
    case ValueKind::image:
      return Value::image(io::read_image(path));
    case ValueKind::drawing:
      return Value::drawing(io::read_drawing(path));
    case ValueKind::contours:
      return Value::contours(read_contour_file(path, frame));
    case ValueKind::tin:
      return Value::tin(read_tin_file(path, frame));
    case ValueKind::report:
      throw IoError(path, "reports are written, never read");
  }
  throw Error("unknown kind of value");
}

LabelMap read_label_picture(const std::string& path, const GridFrame& domain, const RunContext& run) {
  try {
    return io::decode_labels(io::read_image(path), domain, run).labels;
  } catch (const InvalidArgument& error) {
    throw IoError(path, error.what());
  }
}

Digest file_digest(const std::string& path) {
  namespace fs = std::filesystem;
  Hasher hasher;
  hash_file(path, hasher);
  std::vector<fs::path> companions = {path + ".json"};
  if (fs::path(path).extension() == ".shp") {
    for (const char* extension : {".shx", ".dbf", ".prj", ".cpg"})
      companions.push_back(fs::path(path).replace_extension(extension));
  }
  for (const fs::path& companion : companions) {
    if (fs::is_regular_file(companion)) hash_file(companion.string(), hasher.text(companion.extension().string()));
  }
  return hasher.digest();
}

}  // namespace seamount::recipe
