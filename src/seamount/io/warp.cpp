#include "seamount/io/warp.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "seamount/base/text.h"
#include "seamount/io/projection.h"

namespace seamount::io {
namespace {

constexpr double kMostDegrees = 20.0;

/// Metres to places in the stored raster's system, and back. Without transforms both are the same.
struct Mapping {
  TransformPtr to_metres, to_stored;
  std::string crs;

  /// False where a place has no image.
  static bool apply(OGRCoordinateTransformation* transform, std::vector<double>& x, std::vector<double>& y) {
    if (transform == nullptr) return true;
    std::vector<int> good(x.size());
    transform->Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, nullptr, good.data());
    for (size_t i = 0; i < x.size(); ++i)
      if (good[i] == 0 || !std::isfinite(x[i]) || !std::isfinite(y[i])) return false;
    return true;
  }
};

/// Points along an edge, both ends included.
std::vector<double> steps(double from, double to) {
  constexpr int kSteps = 64;
  std::vector<double> values;
  for (int i = 0; i <= kSteps; ++i) values.push_back(from + (to - from) * i / kSteps);
  return values;
}

Mapping make_mapping(const Placement& p, int width, int height, const GdalCall& call) {
  Mapping mapping;
  if (is_metric(p.system)) {
    mapping.crs = crs_text(&p.system);
    return mapping;
  }
  const OGRSpatialReference lonlat = lonlat_system();
  const TransformPtr to_lonlat(OGRCreateCoordinateTransformation(&p.system, &lonlat));
  const double east = p.west + width * p.cell_x, south = p.north - height * p.cell_y;
  std::vector<double> x{0.5 * (p.west + east), p.west, east}, y(3, 0.5 * (p.north + south));
  if (!to_lonlat || !Mapping::apply(to_lonlat.get(), x, y)) call.fail("its coordinate reference system cannot be used");
  const double across = p.system.IsGeographic() ? east - p.west : std::abs(x[2] - x[1]);
  if (across > kMostDegrees)
    call.fail("spans " + format_number(std::round(across * 10) / 10) + " degrees of longitude; cut it to at most " +
              format_number(kMostDegrees));
  const auto rounded = [](double degrees) { return std::round(degrees * 1e4) / 1e4; };
  mapping.crs = local_crs(rounded(x[0]), rounded(y[0]));
  const auto metres = parse_crs(mapping.crs);
  mapping.to_metres.reset(OGRCreateCoordinateTransformation(&p.system, metres.get()));
  mapping.to_stored.reset(OGRCreateCoordinateTransformation(metres.get(), &p.system));
  if (!mapping.to_metres || !mapping.to_stored) call.fail("its coordinate reference system cannot be used");
  return mapping;
}

/// The extreme of one coordinate along an edge of the raster.
double edge_extreme(const Mapping& mapping, std::vector<double> x, std::vector<double> y, bool want_x, bool want_max,
                    const GdalCall& call) {
  if (!Mapping::apply(mapping.to_metres.get(), x, y)) call.fail("lies outside of its coordinate reference system");
  const std::vector<double>& values = want_x ? x : y;
  return want_max ? *std::max_element(values.begin(), values.end()) : *std::min_element(values.begin(), values.end());
}

GridFrame target_frame(const Placement& p, int width, int height, const Mapping& mapping, const GdalCall& call,
                       int64_t max_cells) {
  const double east = p.west + width * p.cell_x, south = p.north - height * p.cell_y;
  const auto across = steps(p.west, east), down = steps(p.north, south);
  const std::vector<double> at_west(down.size(), p.west), at_east(down.size(), east), at_north(across.size(), p.north),
      at_south(across.size(), south);
  const double x0 = edge_extreme(mapping, at_west, down, true, true, call);
  const double x1 = edge_extreme(mapping, at_east, down, true, false, call);
  const double y1 = edge_extreme(mapping, across, at_north, false, false, call);
  const double y0 = edge_extreme(mapping, across, at_south, false, true, call);
  if (!(x1 > x0) || !(y1 > y0)) call.fail("has no upright rectangle inside it");
  const double cell = std::sqrt((x1 - x0) / width * ((y1 - y0) / height));
  GridFrame frame;
  frame.cell_m = std::max(std::round(cell * 1000) / 1000, cell / 2);
  const double columns = (x1 - x0) / frame.cell_m + 1e-6, rows = (y1 - y0) / frame.cell_m + 1e-6;
  if (columns > 1e6 || rows > 1e6 || columns * rows > static_cast<double>(max_cells))
    call.fail("needs more than " + std::to_string(max_cells) + " square cells");
  frame.width = std::max(1, static_cast<int>(columns));
  frame.height = std::max(1, static_cast<int>(rows));
  frame.west_m = 0.5 * (x0 + x1) - 0.5 * frame.width_m();
  frame.north_m = 0.5 * (y0 + y1) + 0.5 * frame.height_m();
  frame.crs = mapping.crs;
  return frame;
}

/// Bilinear over the cells that have a value; NaN where they are less than half of the weight.
float sample(const Grid<float>& grid, double column, double row) {
  if (!std::isfinite(column) || !std::isfinite(row)) return std::nanf("");
  const double x = std::clamp(column, 0.0, grid.width() - 1.0), y = std::clamp(row, 0.0, grid.height() - 1.0);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const double fx = x - x0, fy = y - y0;
  double sum = 0, weight = 0;
  for (int k = 0; k < 4; ++k) {
    const double w = (k % 2 == 0 ? 1 - fx : fx) * (k < 2 ? 1 - fy : fy);
    const float z = grid.clamped(x0 + k % 2, y0 + k / 2);
    if (std::isnan(z)) continue;
    sum += w * z;
    weight += w;
  }
  return weight >= 0.5 ? static_cast<float>(sum / weight) : std::nanf("");
}

}  // namespace

bool is_metric(const OGRSpatialReference& system) {
  return system.IsEmpty() || (!system.IsGeographic() && std::abs(system.GetLinearUnits() - 1.0) < 1e-12);
}

Grid<float> warp_to_metres(const Grid<float>& stored, const Placement& p, const GdalCall& call, int64_t max_cells) {
  const Mapping mapping = make_mapping(p, stored.width(), stored.height(), call);
  const GridFrame frame = target_frame(p, stored.width(), stored.height(), mapping, call, max_cells);
  Grid<float> warped(frame);
  // The transform is exact on a lattice of every kStep-th cell and linear between, which is off by less than a
  // hundredth of a cell for cells below a kilometre.
  constexpr int kStep = 16;
  const int nodes = (frame.width - 1) / kStep + 2;
  const auto lattice_row = [&](int row) {
    std::pair<std::vector<double>, std::vector<double>> xy;
    for (int i = 0; i < nodes; ++i) {
      xy.first.push_back(frame.x(i * kStep));
      xy.second.push_back(frame.y(row));
    }
    if (!Mapping::apply(mapping.to_stored.get(), xy.first, xy.second)) call.fail("cannot be projected to metres");
    return xy;
  };
  auto upper = lattice_row(0);
  for (int top = 0; top < frame.height; top += kStep) {
    const auto lower = lattice_row(top + kStep);
    for (int y = top; y < std::min(top + kStep, frame.height); ++y) {
      const double v = static_cast<double>(y - top) / kStep;
      for (int x = 0; x < frame.width; ++x) {
        const auto i = static_cast<size_t>(x / kStep);
        const double u = static_cast<double>(x % kStep) / kStep;
        const auto between = [&](const std::vector<double>& a, const std::vector<double>& b) {
          return (1 - v) * ((1 - u) * a[i] + u * a[i + 1]) + v * ((1 - u) * b[i] + u * b[i + 1]);
        };
        warped(x, y) = sample(stored, (between(upper.first, lower.first) - p.west) / p.cell_x - 0.5,
                              (p.north - between(upper.second, lower.second)) / p.cell_y - 0.5);
      }
    }
    upper = lower;
  }
  return warped;
}

}  // namespace seamount::io
