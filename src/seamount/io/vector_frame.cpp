#include "seamount/io/vector_frame.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "seamount/base/error.h"

namespace seamount::io {
namespace {

constexpr int kMostCells = 65536;
constexpr double kWidestCell = 1e6;  ///< metres
constexpr double kFarthest = 1e9;

/// The object that begins the text, to its closing brace; nothing if it does not end.
std::optional<std::string_view> first_object(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      quoted = c != '"';
    } else if (c == '"') {
      quoted = true;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return text.substr(0, i + 1);
    }
  }
  return std::nullopt;
}

}  // namespace

std::string frame_text(const GridFrame& frame) {
  return fmt::format("{} {} {} {} {}", frame.width, frame.height, frame.cell_m, frame.west_m, frame.north_m);
}

std::optional<GridFrame> parse_frame(std::string_view text) {
  std::istringstream words{std::string(text)};
  GridFrame frame;
  words >> frame.width >> frame.height >> frame.cell_m >> frame.west_m >> frame.north_m;
  const bool sized = frame.width > 0 && frame.height > 0 && frame.width <= kMostCells && frame.height <= kMostCells;
  const bool placed = std::abs(frame.west_m) <= kFarthest && std::abs(frame.north_m) <= kFarthest;
  if (!words || !sized || !placed || !(frame.cell_m > 0.0 && frame.cell_m <= kWidestCell)) return std::nullopt;
  return frame;
}

std::string frame_member(const GridFrame& frame) {
  const nlohmann::json member = {{"frame", frame_text(frame)}, {"crs", frame.crs}};
  return "\"seamount\":" + member.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::optional<GridFrame> find_frame_member(std::string_view beginning) {
  constexpr std::string_view kName = "\"seamount\":";
  const size_t at = beginning.find(kName);
  // Within a feature it is somebody's attribute.
  if (at == std::string_view::npos || beginning.substr(0, at).find("\"features\"") != std::string_view::npos)
    return std::nullopt;
  const std::string_view rest = beginning.substr(at + kName.size());
  const std::optional<std::string_view> object = first_object(rest);
  const nlohmann::json member = nlohmann::json::parse(object.value_or(""), nullptr, false);
  const bool whole = member.is_object() && member.contains("frame") && member["frame"].is_string() &&
                     member.contains("crs") && member["crs"].is_string();
  std::optional<GridFrame> frame = whole ? parse_frame(member["frame"].get<std::string>()) : std::nullopt;
  if (!frame) throw InvalidArgument("seamount", "is not a frame as it is written here");
  frame->crs = member["crs"].get<std::string>();
  return frame;
}

}  // namespace seamount::io
