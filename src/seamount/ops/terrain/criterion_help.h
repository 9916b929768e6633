// What the field tables of terrain.mask's criteria say alike.
#pragma once

#include <string_view>

namespace seamount::terrain {

inline constexpr std::string_view kLowHelp = "lowest that is fully selected; no limit if absent";
inline constexpr std::string_view kHighHelp = "highest that is fully selected; no limit if absent";
inline constexpr std::string_view kFalloffHelp = "over which the selection fades beyond the limits";
inline constexpr std::string_view kInvertHelp = "select the rest";

}  // namespace seamount::terrain
