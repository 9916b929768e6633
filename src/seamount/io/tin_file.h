// Triangulated networks as PLY, for viewers and other programs, and from them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "seamount/model/tin.h"

namespace seamount::io {

/// What stands for Tin::kNoBed in files.
inline constexpr float kNoBedInFiles = -1e9F;

/// Binary, little endian. Vertices with x, y (double, metres in the frame's system), z (float, metres; 0 where heights
/// are not assigned yet) and, of a grown network, region (int, -1 outside), rank and, with rivers, bed (float);
/// triangles counter-clockwise. Comments carry the frame and the regions, so that read_tin() gives the same network.
/// Throws IoError.
void write_tin(const Tin& tin, const std::string& path);

/// Any PLY of triangles, text or binary little endian, with x, y, z and perhaps region and rank; triangles are turned
/// counter-clockwise. The frame is empty where the file does not carry one. Throws IoError{path}: not a PLY, big
/// endian, truncated, missing coordinates, polygons of more than three corners, corners that are not there, more values
/// than the file can hold. Whether triangles overlap is the caller's to find (geom::find_tin_defect). Linear.
Tin read_tin(const std::string& path);
/// The same from bytes; `name` stands in messages.
Tin read_tin(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace seamount::io
