#include "seamount/recipe/value_bytes.h"

#include <array>
#include <cstring>
#include <istream>
#include <ostream>
#include <vector>

#include "seamount/base/hash.h"

namespace seamount::recipe {
namespace {

constexpr uint64_t kMagic = 0x31304d5354414d53ULL;  // "SMATSM01"
constexpr uint64_t kMostBytes = uint64_t{1} << 36;

class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}
  void raw(const void* data, size_t bytes) {
    const auto* first = static_cast<const std::byte*>(data);
    hasher_.bytes({first, bytes});
    out_.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  }
  template <class T>
  void plain(const T& value) {
    raw(&value, sizeof value);
  }
  void text(const std::string& value) {
    plain(static_cast<uint64_t>(value.size()));
    raw(value.data(), value.size());
  }
  template <class T>
  void list(const std::vector<T>& items) {
    plain(static_cast<uint64_t>(items.size()));
    raw(items.data(), items.size() * sizeof(T));
  }
  void finish() {
    const Digest digest = hasher_.digest();
    out_.write(reinterpret_cast<const char*>(&digest), sizeof digest);
  }

 private:
  std::ostream& out_;
  Hasher hasher_;
};

struct Damaged {};

class Reader {
 public:
  explicit Reader(std::istream& in) : in_(in) {
    in_.seekg(0, std::ios::end);
    left_ = static_cast<uint64_t>(std::max<std::streamoff>(0, in_.tellg()));
    in_.seekg(0);
  }
  void raw(void* data, uint64_t bytes) {
    if (bytes > left_ || !in_.read(static_cast<char*>(data), static_cast<std::streamsize>(bytes))) throw Damaged();
    left_ -= bytes;
    hasher_.bytes({static_cast<const std::byte*>(data), bytes});
  }
  template <class T>
  T plain() {
    T value;
    raw(&value, sizeof value);
    return value;
  }
  /// A count of items of `size` bytes that the rest of the file can hold.
  uint64_t count(uint64_t size) {
    const auto n = plain<uint64_t>();
    if (n > kMostBytes / size || n * size > left_) throw Damaged();
    return n;
  }
  std::string text() {
    std::string value(count(1), '\0');
    raw(value.data(), value.size());
    return value;
  }
  template <class T>
  std::vector<T> list() {
    std::vector<T> items(count(sizeof(T)));
    raw(items.data(), items.size() * sizeof(T));
    return items;
  }
  void finish() {
    const Digest expected = hasher_.digest();
    Digest found;
    if (!in_.read(reinterpret_cast<char*>(&found), sizeof found) || !(found == expected)) throw Damaged();
  }
  uint64_t left() const { return left_; }

 private:
  std::istream& in_;
  Hasher hasher_;
  uint64_t left_ = 0;
};

void write_frame(Writer& writer, const GridFrame& frame) {
  writer.plain(frame.width);
  writer.plain(frame.height);
  writer.plain(frame.cell_m);
  writer.plain(frame.west_m);
  writer.plain(frame.north_m);
  writer.text(frame.crs);
}

GridFrame read_frame(Reader& reader) {
  GridFrame frame;
  frame.width = reader.plain<int>();
  frame.height = reader.plain<int>();
  frame.cell_m = reader.plain<double>();
  frame.west_m = reader.plain<double>();
  frame.north_m = reader.plain<double>();
  frame.crs = reader.text();
  return frame;
}

template <class T>
void write_grid(Writer& writer, const Grid<T>& grid) {
  write_frame(writer, grid.frame());
  writer.raw(grid.data(), grid.size() * sizeof(T));
}

template <class T>
Grid<T> read_grid(Reader& reader) {
  const GridFrame frame = read_frame(reader);
  if (frame.width < 0 || frame.height < 0 || static_cast<uint64_t>(frame.cells()) * sizeof(T) > reader.left())
    throw Damaged();
  Grid<T> grid(frame);
  reader.raw(grid.data(), grid.size() * sizeof(T));
  return grid;
}

void write_attributes(Writer& writer, const Attributes& attributes) {
  writer.plain(static_cast<uint64_t>(attributes.size()));
  for (const Attribute& attribute : attributes) {
    writer.text(attribute.name);
    writer.plain(attribute.value);
  }
}

Attributes read_attributes(Reader& reader) {
  Attributes attributes(reader.count(16));
  for (Attribute& attribute : attributes) {
    attribute.name = reader.text();
    attribute.value = reader.plain<double>();
  }
  return attributes;
}

void write_drawing(Writer& writer, const Drawing& drawing) {
  writer.text(drawing.crs);
  writer.plain(static_cast<uint64_t>(drawing.areas.size()));
  for (const NamedArea& area : drawing.areas) {
    writer.text(area.name);
    writer.plain(static_cast<uint64_t>(area.parts.size()));
    for (const Polygon& part : area.parts) {
      writer.list(part.outer);
      writer.plain(static_cast<uint64_t>(part.holes.size()));
      for (const Ring& hole : part.holes) writer.list(hole);
    }
    write_attributes(writer, area.attributes);
  }
  writer.plain(static_cast<uint64_t>(drawing.lines.size()));
  for (const ValuedLine& line : drawing.lines) {
    writer.list(line.points);
    writer.plain(line.value);
    writer.plain(static_cast<uint8_t>(line.closed));
    write_attributes(writer, line.attributes);
  }
  writer.plain(static_cast<uint64_t>(drawing.points.size()));
  for (const ValuedPoint& point : drawing.points) {
    writer.plain(point.place);
    writer.plain(point.value);
    write_attributes(writer, point.attributes);
  }
  writer.plain(static_cast<uint8_t>(drawing.heights));
}

Drawing read_drawing(Reader& reader) {
  Drawing drawing;
  drawing.crs = reader.text();
  drawing.areas.resize(reader.count(8));
  for (NamedArea& area : drawing.areas) {
    area.name = reader.text();
    area.parts.resize(reader.count(8));
    for (Polygon& part : area.parts) {
      part.outer = reader.list<Vec2>();
      part.holes.resize(reader.count(8));
      for (Ring& hole : part.holes) hole = reader.list<Vec2>();
    }
    area.attributes = read_attributes(reader);
  }
  drawing.lines.resize(reader.count(8));
  for (ValuedLine& line : drawing.lines) {
    line.points = reader.list<Vec2>();
    line.value = reader.plain<double>();
    line.closed = reader.plain<uint8_t>() != 0;
    line.attributes = read_attributes(reader);
  }
  drawing.points.resize(reader.count(8));
  for (ValuedPoint& point : drawing.points) {
    point.place = reader.plain<Vec2>();
    point.value = reader.plain<double>();
    point.attributes = read_attributes(reader);
  }
  drawing.heights = reader.plain<uint8_t>() != 0;
  return drawing;
}

void write_tin(Writer& writer, const Tin& tin) {
  write_frame(writer, tin.frame);
  writer.list(tin.nodes);
  writer.list(tin.triangles);
  writer.plain(static_cast<uint64_t>(tin.regions.size()));
  for (const TinRegion& region : tin.regions) {
    writer.text(region.name);
    writer.plain(region.parent);
    writer.list(region.outline);
    writer.plain(static_cast<uint8_t>(region.height_m.has_value()));
    writer.plain(region.height_m.value_or(0.0));
    writer.plain(static_cast<uint8_t>(region.basin));
  }
  writer.list(tin.region);
  writer.list(tin.rank);
  writer.list(tin.bed_m);
  writer.list(tin.height_m);
}

Tin read_tin(Reader& reader) {
  Tin tin;
  tin.frame = read_frame(reader);
  tin.nodes = reader.list<Vec2>();
  tin.triangles = reader.list<std::array<int32_t, 3>>();
  tin.regions.resize(reader.count(8));
  for (TinRegion& region : tin.regions) {
    region.name = reader.text();
    region.parent = reader.plain<int>();
    region.outline = reader.list<Vec2>();
    const bool has_height = reader.plain<uint8_t>() != 0;
    const auto height = reader.plain<double>();
    if (has_height) region.height_m = height;
    region.basin = reader.plain<uint8_t>() != 0;
  }
  tin.region = reader.list<int32_t>();
  tin.rank = reader.list<float>();
  tin.bed_m = reader.list<float>();
  tin.height_m = reader.list<float>();
  return tin;
}

void write_contours(Writer& writer, const ContourSet& set) {
  write_frame(writer, set.frame);
  writer.plain(static_cast<uint64_t>(set.contours.size()));
  for (const Contour& contour : set.contours) {
    writer.plain(contour.height_m);
    writer.list(contour.ring);
    writer.plain(contour.parent);
  }
}

ContourSet read_contours(Reader& reader) {
  ContourSet set;
  set.frame = read_frame(reader);
  set.contours.resize(reader.count(8));
  for (Contour& contour : set.contours) {
    contour.height_m = reader.plain<double>();
    contour.ring = reader.list<Vec2>();
    contour.parent = reader.plain<int>();
  }
  return set;
}

void write_value(Writer& writer, const Value& value) {
  writer.plain(static_cast<uint8_t>(value.kind()));
  switch (value.kind()) {
    case ValueKind::terrain:
    case ValueKind::field:
      return write_grid(writer, value.heights());
    case ValueKind::labels:
      return write_grid(writer, value.regions());
    case ValueKind::image:
      writer.plain(value.picture().width);
      writer.plain(value.picture().height);
      return writer.list(value.picture().rgb);
    case ValueKind::drawing:
      return write_drawing(writer, value.shapes());
    case ValueKind::tin:
      return write_tin(writer, value.network());
    case ValueKind::contours:
      return write_contours(writer, value.contour_set());
  }
}

Value read_value(Reader& reader) {
  switch (static_cast<ValueKind>(reader.plain<uint8_t>())) {
    case ValueKind::terrain:
      return Value::terrain(read_grid<float>(reader));
    case ValueKind::field:
      return Value::field(read_grid<float>(reader));
    case ValueKind::labels:
      return Value::labels(read_grid<Region>(reader));
    case ValueKind::image: {
      Image image;
      image.width = reader.plain<int>();
      image.height = reader.plain<int>();
      image.rgb = reader.list<uint8_t>();
      return Value::image(std::move(image));
    }
    case ValueKind::drawing:
      return Value::drawing(read_drawing(reader));
    case ValueKind::tin:
      return Value::tin(read_tin(reader));
    case ValueKind::contours:
      return Value::contours(read_contours(reader));
  }
  throw Damaged();
}

}  // namespace

void write_values(std::ostream& out, const Values& values) {
  Writer writer(out);
  writer.plain(kMagic);
  writer.plain(static_cast<uint64_t>(values.size()));
  for (const auto& [name, value] : values) {
    writer.text(name);
    write_value(writer, value);
  }
  writer.finish();
}

std::optional<Values> read_values(std::istream& in) {
  try {
    Reader reader(in);
    if (reader.plain<uint64_t>() != kMagic) return std::nullopt;
    Values values;
    const uint64_t count = reader.count(8);
    for (uint64_t i = 0; i < count; ++i) {
      std::string name = reader.text();
      values.insert_or_assign(std::move(name), read_value(reader));
    }
    reader.finish();
    return values;
  } catch (const Damaged&) {
    return std::nullopt;
  }
}

}  // namespace seamount::recipe
