// Scenes of environmental objects from and to files: JSON, GeoPackage, GeoJSON.
#pragma once

#include <string>

#include "seamount/base/run_context.h"
#include "seamount/model/scene.h"

namespace seamount::recipe {

/// By extension: .json (scene_json.h, exact), .gpkg (exact) and .geojson (a hundredth of a millimetre where a
/// coordinate system is known) for a GIS (io/object_file.h). Throws IoError.
void write_scene(const Scene& scene, const std::string& path);

/// What write_scene() wrote, also after a GIS has edited its features: new ones get numbers. Features without a scene
/// around them become one whose catalogue has their classes without any rule: give a catalogue to grow it. Throws
/// IoError, RecipeError (with places), Cancelled.
Scene read_scene(const std::string& path, const RunContext& run);

/// Is it a file that write_scene() wrote, or that a GIS has since edited? Features without a scene are drawings. Throws
/// IoError for one that cannot be read at all.
bool is_scene_file(const std::string& path);

}  // namespace seamount::recipe
