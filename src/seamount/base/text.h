// Text for people: numbers as short as they can be read back, ranges, and the name somebody probably meant.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace seamount {

/// Shortest decimal text that reads back to the same double: 0.1, 2500, 1e-05.
std::string format_number(double value);

/// The text as it may stand in XML and HTML, between tags or in double quotes; control characters are left out.
std::string xml_escaped(std::string_view text);

/// "[0, 1]", or "[0, inf)" where an end is open.
std::string format_range(double min, double max);

/// The candidate that is most like `name` (edit distance with swaps), if it is close enough to be a likely slip.
std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> candidates);

/// ", did you mean 'X'?" or, where no candidate is near, ", known are: A, B, C" (at most twelve); empty without
/// candidates.
std::string suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace seamount
