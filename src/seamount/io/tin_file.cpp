#include "seamount/io/tin_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <vector>

#include "seamount/io/atomic_file.h"
#include "seamount/io/vector_frame.h"

namespace seamount::io {
namespace {

/// Bytes of plain values one after another.
class Bytes {
 public:
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) {
    const size_t size = bytes_.size();
    bytes_.resize(size + sizeof(T));
    std::memcpy(bytes_.data() + size, &value, sizeof(T));
  }

  /// Passes a full piece, or the last one, on to the file.
  void pass(FileWriter& file, bool last = false) {
    constexpr size_t kPiece = 1 << 20;
    if (!last && bytes_.size() < kPiece) return;
    file.write(bytes_);
    bytes_.clear();
  }

 private:
  std::vector<uint8_t> bytes_;
};

/// Lines that read_tin() understands and other programs pass over. Names and systems go to the end of their line.
std::string comments(const Tin& tin) {
  const auto one_line = [](std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
    return text;
  };
  const GridFrame& f = tin.frame;
  std::string text = "comment seamount frame " + frame_text(f) + "\n";
  if (!f.crs.empty()) text += "comment seamount crs " + one_line(f.crs) + "\n";
  if (tin.height_m.empty()) text += "comment seamount no heights\n";
  for (const TinRegion& region : tin.regions) {
    text += fmt::format("comment seamount region {} {} {} {}\n", region.parent,
                        region.height_m ? fmt::format("{}", *region.height_m) : "-", region.basin ? "basin" : "hill",
                        one_line(region.name));
    if (region.peak_m) text += fmt::format("comment seamount peak {}\n", *region.peak_m);
    if (region.outline.empty()) continue;
    text += "comment seamount outline";
    for (const Vec2 p : region.outline) text += fmt::format(" {} {}", p.x, p.y);
    text += "\n";
  }
  return text;
}

std::string header(const Tin& tin) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment metres, z up, sea level at z = 0\n" +
                     comments(tin) + "element vertex " + std::to_string(tin.nodes.size()) +
                     "\nproperty double x\nproperty double y\nproperty float z\n";
  if (!tin.region.empty()) text += "property int region\n";
  if (!tin.rank.empty()) text += "property float rank\n";
  if (!tin.bed_m.empty()) text += "property float bed\n";
  return text + "element face " + std::to_string(tin.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

}  // namespace

void write_tin(const Tin& tin, const std::string& path) {
  write_atomically(path, [&](const std::string& temporary) {
    FileWriter file(temporary, path);
    file.write_raw<char>(header(tin));
    Bytes bytes;
    for (size_t i = 0; i < tin.nodes.size(); ++i) {
      bytes.add(tin.nodes[i].x);
      bytes.add(tin.nodes[i].y);
      bytes.add(tin.height_m.empty() ? 0.0F : tin.height_m[i]);
      if (!tin.region.empty()) bytes.add(tin.region[i]);
      if (!tin.rank.empty()) bytes.add(tin.rank[i]);
      if (!tin.bed_m.empty()) bytes.add(tin.bed_m[i] == Tin::kNoBed ? kNoBedInFiles : tin.bed_m[i]);
      bytes.pass(file);
    }
    for (const auto& [a, b, c] : tin.triangles) {
      bytes.add(uint8_t{3});
      bytes.add(a);
      bytes.add(b);
      bytes.add(c);
      bytes.pass(file);
    }
    bytes.pass(file, true);
    file.close();
  });
}

}  // namespace seamount::io
