#include "seamount/io/elevation_coding.h"

#include <array>
#include <cmath>
#include <numbers>

namespace seamount::io {

float coded_height(ElevationCoding coding, float red, float green, float blue) {
  if (coding == ElevationCoding::terrarium) return red * 256 + green + blue / 256 - 32768;
  return static_cast<float>(-10000 + (double{red} * 65536 + double{green} * 256 + blue) * 0.1);
}

std::optional<Placement> slippy_placement(const std::string& path, int side) {
  constexpr int kDeepest = 24;
  std::array<int64_t, 3> zxy{};
  size_t end = path.rfind('.');
  if (end == std::string::npos) return std::nullopt;
  if (path.substr(0, end).ends_with("@2x")) end -= 3;
  for (size_t i = 3; i-- > 0;) {
    size_t begin = end;
    while (begin > 0 && path[begin - 1] >= '0' && path[begin - 1] <= '9') --begin;
    const size_t digits = end - begin;
    if (digits == 0 || digits > 9) return std::nullopt;
    zxy[i] = std::stoll(path.substr(begin, digits));
    const bool joined = begin > 0 && (path[begin - 1] == '/' || path[begin - 1] == '_' || path[begin - 1] == '-');
    if (i > 0 && !joined) return std::nullopt;
    end = i > 0 ? begin - 1 : begin;
  }
  if (zxy[0] > kDeepest || zxy[1] >= int64_t{1} << zxy[0] || zxy[2] >= int64_t{1} << zxy[0]) return std::nullopt;
  constexpr double kHalf = std::numbers::pi * 6378137.0;
  const double width = 2 * kHalf / static_cast<double>(int64_t{1} << zxy[0]);
  Placement placement{-kHalf + static_cast<double>(zxy[1]) * width, kHalf - static_cast<double>(zxy[2]) * width,
                      width / side, width / side, *parse_crs("EPSG:3857")};
  return placement;
}

}  // namespace seamount::io
