// Triangulated networks as PLY (binary, little endian), for viewers and other programs.
#pragma once

#include <string>

#include "seamount/model/tin.h"

namespace seamount::io {

/// Vertices with x, y (double, metres in the frame's system), z (float, metres; 0 where heights are not assigned yet)
/// and, of a grown network, region (int, -1 outside) and rank (float); triangles counter-clockwise. Throws IoError.
void write_tin(const Tin& tin, const std::string& path);

}  // namespace seamount::io
