#include "seamount/recipe/file_values.h"

#include <filesystem>
#include <fstream>
#include <vector>

#include "seamount/geom/grid/painted_labels.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/image_file.h"
#include "seamount/io/raster.h"

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

LabelMap decode_picture(const std::string& path, const io::PlacedImage& picture, const RunContext& run) {
  try {
    return geom::decode_labels(picture.image, picture.frame, run).labels;
  } catch (const InvalidArgument& error) {
    throw IoError(path, error.what());
  }
}

}  // namespace

bool is_picture(const std::string& path) {
  const std::string extension = io::extension_of(path);
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

LabelMap read_label_picture(const std::string& path, const GridFrame& domain, const RunContext& run) {
  return decode_picture(path, {io::read_image(path), domain}, run);
}

LabelMap read_placed_labels(const std::string& path, const RunContext& run) {
  return decode_picture(path, io::read_placed_image(path), run);
}

std::vector<std::string> companions_of(const std::string& path) {
  namespace fs = std::filesystem;
  std::vector<fs::path> candidates = {path + ".json"};
  if (fs::path(path).extension() == ".shp") {
    for (const char* extension : {".shx", ".dbf", ".prj", ".cpg"})
      candidates.push_back(fs::path(path).replace_extension(extension));
  }
  std::vector<std::string> companions;
  for (const fs::path& candidate : candidates) {
    if (fs::is_regular_file(candidate)) companions.push_back(candidate.string());
  }
  return companions;
}

Digest file_digest(const std::string& path) {
  Hasher hasher;
  hash_file(path, hasher);
  for (const std::string& companion : companions_of(path))
    hash_file(companion, hasher.text(std::filesystem::path(companion).extension().string()));
  return hasher.digest();
}

}  // namespace seamount::recipe
