#include "seamount/io/placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

namespace seamount::io {
namespace {

constexpr int kStep = 16;
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

bool is_geographic(const OGRSpatialReference& system) { return !system.IsEmpty() && system.IsGeographic() != 0; }

/// Transforms in place; NaN where a place has no image.
void transform(OGRCoordinateTransformation* way, std::vector<double>& x, std::vector<double>& y) {
  if (way == nullptr) return;
  std::vector<int> good(x.size());
  way->Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, nullptr, good.data());
  for (size_t i = 0; i < x.size(); ++i)
    if (good[i] == 0 || !std::isfinite(x[i]) || !std::isfinite(y[i])) x[i] = y[i] = kNowhere;
}

/// Metres east and north of a step of (dlon, dlat) degrees at a latitude, on WGS 84.
std::array<double, 2> metres_of(double dlon, double dlat, double latitude) {
  constexpr double kDegree = std::numbers::pi / 180, kAxis = 6378137.0, kFlat = 0.00669437999014;
  const double sine = std::sin(latitude * kDegree), w = 1 - kFlat * sine * sine;
  const double across = kAxis / std::sqrt(w), along = kAxis * (1 - kFlat) / (w * std::sqrt(w));
  return {dlon * kDegree * across * std::cos(latitude * kDegree), dlat * kDegree * along};
}

}  // namespace

Placement placement_of(const GridFrame& frame) {
  Placement placement;
  placement.west = frame.west_m;
  placement.north = frame.north_m;
  placement.cell_x = placement.cell_y = frame.cell_m;
  if (const auto system = parse_crs(frame.crs)) placement.system = *system;
  return placement;
}

double period_of(const OGRSpatialReference& system) {
  if (is_geographic(system)) return 2 * std::numbers::pi / system.GetAngularUnits();
  const char* name = system.IsEmpty() ? nullptr : system.GetAttrValue("PROJECTION");
  if (name == nullptr) return 0.0;
  const std::string_view projection(name);
  const bool around = projection == SRS_PT_MERCATOR_1SP || projection == SRS_PT_MERCATOR_2SP ||
                      projection == SRS_PT_EQUIRECTANGULAR || projection == SRS_PT_CYLINDRICAL_EQUAL_AREA ||
                      projection == SRS_PT_MILLER_CYLINDRICAL || projection.starts_with("Popular_Visualisation");
  return around ? 2 * std::numbers::pi * system.GetSemiMajor() * system.GetNormProjParm(SRS_PP_SCALE_FACTOR, 1.0) /
                      system.GetLinearUnits()
                : 0.0;
}

double scale_error(const Placement& p, int width, int height) {
  if (p.system.IsEmpty() || is_geographic(p.system)) return 0.0;
  const OGRSpatialReference lonlat = lonlat_system();
  const TransformPtr way(OGRCreateCoordinateTransformation(&p.system, &lonlat));
  if (!way) return 0.0;
  constexpr double kMetres = 100.0;  // far above rounding, far below the curvature of any projection
  double worst = 0.0;
  for (const double u : {0.0, 0.5, 1.0}) {
    for (const double v : {0.0, 0.5, 1.0}) {
      const double x0 = p.west + u * width * p.cell_x, y0 = p.north - v * height * p.cell_y;
      std::vector<double> x{x0 - kMetres, x0 + kMetres, x0, x0}, y{y0, y0, y0 - kMetres, y0 + kMetres};
      transform(way.get(), x, y);
      for (const size_t i : {size_t{0}, size_t{2}}) {
        const double turn = 360.0 * std::round((x[i + 1] - x[i]) / 360.0);
        const auto step = metres_of(x[i + 1] - x[i] - turn, y[i + 1] - y[i], 0.5 * (y[i] + y[i + 1]));
        const double true_length = std::hypot(step[0], step[1]);
        if (std::isfinite(true_length) && true_length > 0)
          worst = std::max(worst, std::abs(2 * kMetres / true_length - 1));
      }
    }
  }
  return worst;
}

CellFinder::CellFinder(const Placement& from, int width, const Placement& to, int to_width, const GdalCall& call,
                       int first)
    : from_(from),
      to_(to),
      width_(width),
      first_(first),
      middle_x_(to.west + 0.5 * to_width * to.cell_x),
      period_(period_of(to.system)) {
  const bool none = from.system.IsEmpty() || to.system.IsEmpty();
  if (none || from.system.IsSame(&to.system) != 0) return;
  way_.reset(OGRCreateCoordinateTransformation(&from.system, &to.system));
  if (!way_) call.fail("its coordinate reference system cannot be used");
}

CellFinder::Line CellFinder::lattice_line(double row) {
  Line line;
  for (int i = first_ / kStep; i < (first_ + width_ - 1) / kStep + 2; ++i) {
    line.columns.push_back(from_.x(i * kStep));
    line.rows.push_back(from_.y(row));
  }
  transform(way_.get(), line.columns, line.rows);
  for (size_t i = 0; i < line.columns.size(); ++i) {
    double& x = line.columns[i];
    if (period_ > 0) x += period_ * std::round((middle_x_ - x) / period_);
    x = (x - to_.west) / to_.cell_x - 0.5;
    line.rows[i] = (to_.north - line.rows[i]) / to_.cell_y - 0.5;
  }
  return line;
}

void CellFinder::locate(int y, std::span<double> columns, std::span<double> rows) {
  const int top = y / kStep * kStep;
  if (top != top_) {
    upper_ = top == top_ + kStep && top_ >= 0 ? std::move(lower_) : lattice_line(top);
    lower_ = lattice_line(top + kStep);
    top_ = top;
  }
  const double v = static_cast<double>(y - top) / kStep;
  for (int x = first_; x < first_ + width_; ++x) {
    const auto i = static_cast<size_t>(x / kStep - first_ / kStep);
    const double u = static_cast<double>(x % kStep) / kStep;
    const auto between = [&](const std::vector<double>& a, const std::vector<double>& b) {
      return (1 - v) * ((1 - u) * a[i] + u * a[i + 1]) + v * ((1 - u) * b[i] + u * b[i + 1]);
    };
    columns[static_cast<size_t>(x - first_)] = between(upper_.columns, lower_.columns);
    rows[static_cast<size_t>(x - first_)] = between(upper_.rows, lower_.rows);
  }
}

}  // namespace seamount::io
