#include "seamount/recipe/frame_bytes.h"

namespace seamount::recipe {

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

}  // namespace seamount::recipe
