// Whole numbers of a glTF file that nobody vouches for. Not part of the public interface.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

namespace seamount::io {

/// A count, place or index. 3.0 is 3; a negative number, a fraction or more than 2^53 throws nlohmann::json::exception,
/// as does what is no number: the library's own conversion of -3.0 or 1e30 has no meaning in C++.
size_t natural(const nlohmann::json& number);

/// That of a member, or `otherwise` where there is none.
size_t natural(const nlohmann::json& object, const char* member, size_t otherwise);

}  // namespace seamount::io
