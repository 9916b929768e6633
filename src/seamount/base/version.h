// The version of Seamount; CMakeLists.txt reads it from here.
#pragma once

namespace seamount {

inline constexpr const char* kVersion = "0.1.0";

}  // namespace seamount
