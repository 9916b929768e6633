// Units of heights as files spell them.
#pragma once

#include <optional>
#include <string_view>

namespace seamount::io {

/// Metres in one unit: "m", "Metre", "ft", "Feet", "US survey foot", "ftUS", "km", "fathom", ... in any letter case and
/// with any spaces; nothing for what is no unit of length that we know.
std::optional<double> metres_in_unit(std::string_view spelled);

}  // namespace seamount::io
