#include "seamount/io/way.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/text.h"

namespace seamount::io {
namespace {

OGRSpatialReference required(const std::string& crs) {
  if (crs.empty()) throw InvalidArgument("crs", "is not known");
  return *parse_crs(crs);
}

}  // namespace

Way::Way(const OGRSpatialReference& from, const OGRSpatialReference& to)
    : call_("crs"), way_(OGRCreateCoordinateTransformation(&from, &to)) {
  if (!way_) throw InvalidArgument("crs", "no way from '" + crs_text(&from) + "' to '" + crs_text(&to) + "'");
}

Way::Way(const std::string& from, const std::string& to) : Way(required(from), required(to)) {}

void Way::move(std::vector<Vec2>& points) const {
  constexpr size_t kPiece = 1 << 16;
  std::vector<double> x, y;
  std::vector<int> good;
  for (size_t begin = 0; begin < points.size(); begin += kPiece) {
    const size_t count = std::min(kPiece, points.size() - begin);
    x.resize(count), y.resize(count), good.assign(count, 0);
    for (size_t i = 0; i < count; ++i) x[i] = points[begin + i].x, y[i] = points[begin + i].y;
    way_->Transform(static_cast<int>(count), x.data(), y.data(), nullptr, nullptr, good.data());
    for (size_t i = 0; i < count; ++i) {
      Vec2& p = points[begin + i];
      if (good[i] == 0 || !std::isfinite(x[i]) || !std::isfinite(y[i]))
        throw InvalidArgument("crs", "(" + format_number(p.x) + ", " + format_number(p.y) +
                                         ") is outside of the coordinate reference system");
      p = {x[i], y[i]};
    }
  }
}

}  // namespace seamount::io
