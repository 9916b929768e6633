// What a file is, for people.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace seamount::io {

/// (what, value) lines in reading order: {"size", "2017 x 2017"}, {"heights", "-812.4 m to 1903.2 m"}, and from a
/// side-car the numbers to type into an engine. Any file that this module reads. Throws IoError.
using FileInfo = std::vector<std::pair<std::string, std::string>>;
FileInfo describe_file(const std::string& path);

}  // namespace seamount::io
