// Text from outside (file names, attributes, messages of libraries) as it may be shown: on a terminal, in a log.
#pragma once

#include <string>
#include <string_view>

namespace seamount {

/// The text in one line of valid UTF-8. What a terminal would act upon is shown instead: a line end as \n, other
/// control characters and bytes that are no UTF-8 as \x1b, marks that turn the direction of text as \u202e.
std::string printable(std::string_view text);

}  // namespace seamount
