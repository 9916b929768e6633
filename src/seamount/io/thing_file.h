// A mesh of the user's as the model of a thing: Wavefront OBJ, glTF 2.0 binary (GLB).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "seamount/base/run_context.h"
#include "seamount/model/things.h"

namespace seamount::io {

/// By extension, .glb or .obj; both are y up, in metres, and come with x east, y north, z up. Read are triangles (OBJ:
/// polygons, as fans), normals where there are some, colours at vertices, base colours of materials (OBJ: the .mtl
/// beside it), nodes with their transforms. Not read, and said: textures. Surfaces of double-sided materials are
/// leaves. Triangles without area are left out. Throws IoError{path}: missing, damaged, no triangles, numbers that lead
/// nowhere, compressed or sparse data, more than 256 MB or two million triangles.
ThingMesh read_thing(const std::string& path, const RunContext& run = {});

/// The same of bytes; `name` stands in messages and says the format. An OBJ's materials are not looked for.
ThingMesh read_thing(std::span<const uint8_t> bytes, const std::string& name, const RunContext& run = {});

}  // namespace seamount::io
