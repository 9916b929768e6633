// Frames, grids and attributes as bytes for the cache: what several kinds of values are made of.
#pragma once

#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/recipe/value_stream.h"

namespace seamount::recipe {

void write_frame(Writer& writer, const GridFrame& frame);
GridFrame read_frame(Reader& reader);

void write_attributes(Writer& writer, const Attributes& attributes);
Attributes read_attributes(Reader& reader);

template <class T>
void write_grid(Writer& writer, const Grid<T>& grid) {
  write_frame(writer, grid.frame());
  writer.raw(grid.data(), grid.size() * sizeof(T));
}

/// Throws Damaged for a frame that the rest of the bytes cannot fill.
template <class T>
Grid<T> read_grid(Reader& reader) {
  const GridFrame frame = read_frame(reader);
  if (frame.width < 0 || frame.height < 0 || static_cast<uint64_t>(frame.cells()) * sizeof(T) > reader.left())
    throw Damaged();
  Grid<T> grid(frame);
  reader.raw(grid.data(), grid.size() * sizeof(T));
  return grid;
}

}  // namespace seamount::recipe
