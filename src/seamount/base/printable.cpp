#include "seamount/base/printable.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

namespace seamount {
namespace {

struct Character {
  uint32_t code = 0;
  size_t bytes = 0;  ///< 0: the text does not go on with valid UTF-8
};

/// The first character of text that is not empty (RFC 3629): the shortest form, no surrogates, up to U+10FFFF.
Character first_character(std::string_view text) {
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
  const uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  uint32_t code = lead & (0x7FU >> bytes);
  for (size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3FU);
  }
  constexpr std::array<uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[bytes] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {};
  return {code, bytes};
}

bool is_control(uint32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

/// Marks that let a text look like another one, and ends of lines that are not '\n'.
bool is_layout(uint32_t code) {
  return (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069) || code == 0x061C || code == 0xFEFF;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const Character next = first_character(text);
    const size_t bytes = next.bytes == 0 ? 1 : next.bytes;
    if (next.bytes == 0)
      shown += fmt::format("\\x{:02x}", static_cast<uint8_t>(text[0]));
    else if (next.code == '\n')
      shown += "\\n";
    else if (is_control(next.code))
      shown += fmt::format("\\x{:02x}", next.code);
    else if (is_layout(next.code))
      shown += fmt::format("\\u{:04x}", next.code);
    else
      shown += text.substr(0, bytes);
    text.remove_prefix(bytes);
  }
  return shown;
}

}  // namespace seamount
