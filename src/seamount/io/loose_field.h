// A field from a file that may not say where it lies: a picture that was painted as a mask.
#pragma once

#include <string>

#include "seamount/io/read_options.h"
#include "seamount/model/grid.h"

namespace seamount::io {

struct LooseField {
  ScalarField values;  ///< NaN where none is known
  bool placed = true;  ///< false: the file says nothing of its place; cells of 1 m around the origin
};

/// As read_field() where the file says where it lies. Otherwise 8- and 16-bit codes, and pictures (.png, .jpg, .jpeg)
/// by their brightness, become 0 (black) to 1 (white), transparent pixels 0, real values stay. What was taken for
/// granted is said. Throws IoError.
LooseField read_loose_field(const std::string& path, const ReadOptions& options = {});

}  // namespace seamount::io
