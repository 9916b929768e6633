#include "seamount/io/warp.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "seamount/base/text.h"
#include "seamount/io/projection.h"
#include "seamount/model/sample_known.h"

namespace seamount::io {
namespace {

constexpr double kMostDegrees = 20.0;

/// Transforms in place; false where a place has no image.
bool apply(OGRCoordinateTransformation* way, std::vector<double>& x, std::vector<double>& y) {
  if (way == nullptr) return true;
  std::vector<int> good(x.size());
  way->Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, nullptr, good.data());
  for (size_t i = 0; i < x.size(); ++i)
    if (good[i] == 0 || !std::isfinite(x[i]) || !std::isfinite(y[i])) return false;
  return true;
}

/// Points along an edge, both ends included.
std::vector<double> steps(double from, double to) {
  constexpr int kSteps = 64;
  std::vector<double> values;
  for (int i = 0; i <= kSteps; ++i) values.push_back(from + (to - from) * i / kSteps);
  return values;
}

/// The extreme of one coordinate along an edge of the raster.
double edge_extreme(OGRCoordinateTransformation* way, std::vector<double> x, std::vector<double> y, bool want_x,
                    bool want_max, const GdalCall& call) {
  if (!apply(way, x, y)) call.fail("lies outside of its coordinate reference system");
  const std::vector<double>& values = want_x ? x : y;
  return want_max ? *std::max_element(values.begin(), values.end()) : *std::min_element(values.begin(), values.end());
}

/// The rectangle that a warped raster is laid on.
struct Rectangle {
  double x0, x1, y0, y1;
  double area() const { return x1 > x0 && y1 > y0 ? (x1 - x0) * (y1 - y0) : 0.0; }
};

/// The largest upright rectangle inside a raster, or the one around it.
Rectangle rectangle_of(const Placement& p, int width, int height, OGRCoordinateTransformation* way, bool cover,
                       const GdalCall& call) {
  const double east = p.west + width * p.cell_x, south = p.north - height * p.cell_y;
  const auto across = steps(p.west, east), down = steps(p.north, south);
  const std::vector<double> at_west(down.size(), p.west), at_east(down.size(), east), at_north(across.size(), p.north),
      at_south(across.size(), south);
  if (!cover)
    return {edge_extreme(way, at_west, down, true, true, call), edge_extreme(way, at_east, down, true, false, call),
            edge_extreme(way, across, at_south, false, true, call),
            edge_extreme(way, across, at_north, false, false, call)};
  Rectangle around{INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (const auto& [xs, ys] : {std::pair(at_west, down), {at_east, down}, {across, at_south}, {across, at_north}}) {
    around.x0 = std::min(around.x0, edge_extreme(way, xs, ys, true, false, call));
    around.x1 = std::max(around.x1, edge_extreme(way, xs, ys, true, true, call));
    around.y0 = std::min(around.y0, edge_extreme(way, xs, ys, false, false, call));
    around.y1 = std::max(around.y1, edge_extreme(way, xs, ys, false, true, call));
  }
  return around;
}

/// The side in metres of a square as large as the raster's middle cell.
double middle_cell(const Placement& p, int width, int height, OGRCoordinateTransformation* way, const GdalCall& call) {
  const double x0 = p.x(0.5 * (width - 1)), y0 = p.y(0.5 * (height - 1));
  std::vector<double> x{x0 - 0.5 * p.cell_x, x0 + 0.5 * p.cell_x, x0, x0};
  std::vector<double> y{y0, y0, y0 - 0.5 * p.cell_y, y0 + 0.5 * p.cell_y};
  if (!apply(way, x, y)) call.fail("lies outside of its coordinate reference system");
  return std::sqrt(std::hypot(x[1] - x[0], y[1] - y[0]) * std::hypot(x[3] - x[2], y[3] - y[2]));
}

/// The lattice's cells around a rectangle.
GridFrame cells_around(const Rectangle& r, const GridFrame& lattice) {
  constexpr double kRounding = 1e-6;
  GridFrame frame = lattice;
  const double cell = lattice.cell_m;
  const double first = std::floor((r.x0 - lattice.west_m) / cell + kRounding);
  const double last = std::ceil((r.x1 - lattice.west_m) / cell - kRounding);
  const double top = std::floor((lattice.north_m - r.y1) / cell + kRounding);
  const double bottom = std::ceil((lattice.north_m - r.y0) / cell - kRounding);
  frame.west_m += first * cell;
  frame.north_m -= top * cell;
  frame.width = static_cast<int>(std::clamp(last - first, 1.0, 1e6));
  frame.height = static_cast<int>(std::clamp(bottom - top, 1.0, 1e6));
  return frame;
}

void check_count(double columns, double rows, const Layout& layout, const GdalCall& call) {
  if (columns > 1e6 || rows > 1e6 || columns * rows > static_cast<double>(layout.max_cells))
    call.fail("needs more than " + std::to_string(layout.max_cells) + " square cells");
}

GridFrame target_frame(const Placement& p, int width, int height, const std::string& crs,
                       OGRCoordinateTransformation* way, const Layout& layout, const GdalCall& call, bool& turned) {
  constexpr double kMostLost = 0.4, kAlike = 1.5;
  bool cover = layout.cover;
  Rectangle r = rectangle_of(p, width, height, way, cover, call);
  const double middle = middle_cell(p, width, height, way, call);
  // Near the poles north is anywhere: of a raster that comes out turned, what is upright inside is little or nothing.
  if (!cover && r.area() < (1 - kMostLost) * middle * middle * width * height) {
    cover = turned = true;
    r = rectangle_of(p, width, height, way, true, call);
  }
  if (!(r.area() > 0)) call.fail("has no area in metres");
  if (cover && layout.lattice != nullptr) {
    const double ratio = layout.lattice->cell_m / middle;
    if (ratio < kAlike && ratio > 1 / kAlike) {
      check_count((r.x1 - r.x0) / layout.lattice->cell_m, (r.y1 - r.y0) / layout.lattice->cell_m, layout, call);
      return cells_around(r, *layout.lattice);
    }
  }
  const double cell = cover ? middle : std::sqrt((r.x1 - r.x0) / width * ((r.y1 - r.y0) / height));
  GridFrame frame;
  frame.cell_m = std::max(std::round(cell * 1000) / 1000, cell / 2);
  const double columns = (r.x1 - r.x0) / frame.cell_m + 1e-6, rows = (r.y1 - r.y0) / frame.cell_m + 1e-6;
  check_count(columns, rows, layout, call);
  frame.width = std::max(1, static_cast<int>(cover ? std::ceil(columns - 2e-6) : columns));
  frame.height = std::max(1, static_cast<int>(cover ? std::ceil(rows - 2e-6) : rows));
  frame.west_m = 0.5 * (r.x0 + r.x1) - 0.5 * frame.width_m();
  frame.north_m = 0.5 * (r.y0 + r.y1) + 0.5 * frame.height_m();
  frame.crs = crs;
  return frame;
}

}  // namespace

bool is_metric(const OGRSpatialReference& system) {
  return system.IsEmpty() || (!system.IsGeographic() && std::abs(system.GetLinearUnits() - 1.0) < 1e-12);
}

Settlement settle(const Placement& p, int width, int height, const GdalCall& call) {
  constexpr double kSquare = 1e-9;
  const bool square = std::abs(p.cell_x - p.cell_y) <= kSquare * p.cell_x;
  const bool metric = is_metric(p.system);
  const double error = metric ? scale_error(p, width, height) : 0.0;
  const std::string own = metric ? crs_text(&p.system) : std::string();
  if (metric && error <= kMostLengthError) return {square, own, {}};
  const OGRSpatialReference lonlat = lonlat_system();
  const TransformPtr to_lonlat(OGRCreateCoordinateTransformation(&p.system, &lonlat));
  const double east = p.west + width * p.cell_x, south = p.north - height * p.cell_y;
  std::vector<double> x{0.5 * (p.west + east), p.west, east}, y(3, 0.5 * (p.north + south));
  if (!to_lonlat || !apply(to_lonlat.get(), x, y)) call.fail("its coordinate reference system cannot be used");
  const auto around = [](double degrees) { return degrees - 360 * std::round(degrees / 360); };
  const double across = p.system.IsGeographic() ? east - p.west : std::abs(around(x[2] - x[1]));
  const std::string percent = format_number(std::round(1000 * error) / 10) + " %";
  if (across > kMostDegrees && metric)
    return {square, own,
            "its coordinate system is not true to scale: lengths are off by up to " + percent +
                "; it is too large to be brought to one that is, cut it to at most " + format_number(kMostDegrees) +
                " degrees of longitude"};
  if (across > kMostDegrees)
    call.fail("spans " + format_number(std::round(across * 10) / 10) + " degrees of longitude; cut it to at most " +
              format_number(kMostDegrees));
  Settlement settlement{false, local_crs(x[0], y[0]), {}};
  if (metric)
    settlement.note =
        "lengths in its coordinate system are off by up to " + percent + ": brought to a system that is true to scale";
  return settlement;
}

GridFrame warped_frame(const Placement& p, int width, int height, const Settlement& settlement, const Layout& layout,
                       const GdalCall& call, bool& turned) {
  const auto metres = parse_crs(settlement.crs);
  TransformPtr way;
  if (metres && metres->IsSame(&p.system) == 0) {
    way.reset(OGRCreateCoordinateTransformation(&p.system, metres.get()));
    if (!way) call.fail("its coordinate reference system cannot be used");
  }
  return target_frame(p, width, height, settlement.crs, way.get(), layout, call, turned);
}

Warped warp_to_metres(const Grid<float>& stored, const Placement& p, const Settlement& settlement, const Layout& layout,
                      const GdalCall& call, const RunContext& run) {
  bool turned = false;
  const GridFrame frame = warped_frame(p, stored.width(), stored.height(), settlement, layout, call, turned);
  Grid<float> warped(frame);
  const Placement target = placement_of(frame);
  CellFinder finder(target, frame.width, p, stored.width(), call);
  std::vector<double> columns(static_cast<size_t>(frame.width)), rows(columns.size());
  for (int y = 0; y < frame.height; ++y) {
    run.check_cancelled();
    if (y % 64 == 63) run.report(static_cast<double>(y) / frame.height);
    finder.locate(y, columns, rows);
    const std::span<float> out = warped.row(y);
    for (size_t x = 0; x < out.size(); ++x) out[x] = sample_known(stored, columns[x], rows[x]);
  }
  return {std::move(warped), turned};
}

}  // namespace seamount::io
