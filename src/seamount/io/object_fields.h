// What the writer and the reader of objects agree on. Not part of the public interface.
#pragma once

namespace seamount::io {

/// The metadata item of a GeoPackage and the member of a GeoJSON collection with all that features do not hold.
inline constexpr const char* kSceneItem = "seamount_scene";

}  // namespace seamount::io
