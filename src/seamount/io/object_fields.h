// What the writer and the reader of objects agree on. Not part of the public interface.
#pragma once

namespace seamount::io {

/// The metadata item of a GeoPackage and the member of a GeoJSON collection with all that features do not hold.
inline constexpr const char* kSceneItem = "seamount_scene";

/// What GeoPackage calls a plane without a place on the Earth.
inline constexpr const char* kLocalMetres =
    "ENGCRS[\"Undefined Cartesian "
    "SRS\",EDATUM[\"\"],CS[Cartesian,2],AXIS[\"(E)\",east,ORDER[1],LENGTHUNIT[\"metre\",1]],"
    "AXIS[\"(N)\",north,ORDER[2],LENGTHUNIT[\"metre\",1]]]";

}  // namespace seamount::io
