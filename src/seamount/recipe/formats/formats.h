// The formats that terrains are written to, a file each. Those of other kinds are with their kinds (kinds/*.cpp).
#pragma once

#include <optional>

#include "seamount/io/sidecar.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

void add_raster_format(Registry& registry);
void add_engine_formats(Registry& registry);
void add_tiles_format(Registry& registry);
void add_gazebo_format(Registry& registry);
void add_mesh_format(Registry& registry);
void add_mesh_tiles_format(Registry& registry);
void add_splat_format(Registry& registry);
void add_bundle_format(Registry& registry);  ///< a folder: height map, layers, texture
void add_picture_formats(Registry& registry);
void add_things_formats(Registry& registry);

/// Heights of the lowest and the highest code of 16-bit files. Throws InvalidArgument{"low_m"} unless both or none are
/// given, in their order.
std::optional<io::HeightRange> height_range(const std::optional<double>& low_m, const std::optional<double>& high_m);

}  // namespace seamount::recipe
