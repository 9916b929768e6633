#include "seamount/io/glb_number.h"

#include <cmath>

namespace seamount::io {

size_t natural(const nlohmann::json& number) {
  constexpr size_t kMost = size_t{1} << 53;
  if (number.is_number_unsigned()) {
    if (const auto whole = number.get<size_t>(); whole <= kMost) return whole;
  } else if (number.is_number_float()) {
    const auto value = number.get<double>();
    if (value >= 0.0 && value <= static_cast<double>(kMost) && std::floor(value) == value)
      return static_cast<size_t>(value);
  }
  throw nlohmann::json::type_error::create(302, "no whole number from 0 up", &number);
}

size_t natural(const nlohmann::json& object, const char* member, size_t otherwise) {
  const auto found = object.find(member);
  return found == object.end() ? otherwise : natural(*found);
}

}  // namespace seamount::io
