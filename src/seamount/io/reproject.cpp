#include "seamount/io/reproject.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/placement.h"
#include "seamount/io/way.h"
#include "seamount/model/sample_known.h"

namespace seamount::io {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

Extent moved_extent(const Extent& extent, const Way& way, const std::string& crs) {
  constexpr int kSteps = 32;
  std::vector<Vec2> rim;
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const double x = extent.west + share * (extent.east - extent.west);
    const double y = extent.south + share * (extent.north - extent.south);
    rim.insert(rim.end(), {{x, extent.north}, {x, extent.south}, {extent.west, y}, {extent.east, y}});
  }
  way.move(rim);
  Extent moved{crs, rim[0].x, rim[0].y, rim[0].x, rim[0].y};
  for (const Vec2& p : rim) moved.include({crs, p.x, p.y, p.x, p.y});
  return moved;
}

/// The upright frame of the same cells around another.
GridFrame moved_frame(const GridFrame& frame, const Way& way, const std::string& crs) {
  const Extent around = moved_extent(Extent::of(frame), way, crs);
  const Vec2 low{around.west, around.south}, high{around.east, around.north};
  constexpr double kRounding = 1e-6, kMostASide = 65536;
  const double columns = std::ceil((high.x - low.x) / frame.cell_m - kRounding);
  const double rows = std::ceil((high.y - low.y) / frame.cell_m - kRounding);
  if (!(columns <= kMostASide) || !(rows <= kMostASide) || columns * rows > (1 << 30))
    throw InvalidArgument("crs", "in '" + crs + "' the raster would have more than 65536 cells a side or 2^30 in all");
  GridFrame moved = frame;
  moved.width = std::max(1, static_cast<int>(columns));
  moved.height = std::max(1, static_cast<int>(rows));
  moved.west_m = 0.5 * (low.x + high.x - moved.width_m());
  moved.north_m = 0.5 * (low.y + high.y + moved.height_m());
  moved.crs = crs;
  return moved;
}

/// Mean of factor x factor cells that have a value, from the north-western corner on; NaN where less than half have.
Grid<float> averaged(const Grid<float>& grid, int factor, const RunContext& run) {
  GridFrame frame = grid.frame();
  frame.width = (frame.width + factor - 1) / factor;
  frame.height = (frame.height + factor - 1) / factor;
  frame.cell_m *= factor;
  Grid<float> means(frame);
  for (int y = 0; y < frame.height; ++y) {
    run.check_cancelled();
    for (int x = 0; x < frame.width; ++x) {
      const int x1 = std::min((x + 1) * factor, grid.width()), y1 = std::min((y + 1) * factor, grid.height());
      double sum = 0;
      int known = 0, all = 0;
      for (int j = y * factor; j < y1; ++j) {
        for (int i = x * factor; i < x1; ++i) {
          ++all;
          if (std::isnan(grid(i, j))) continue;
          sum += grid(i, j);
          ++known;
        }
      }
      means(x, y) = 2 * known >= all && known > 0 ? static_cast<float>(sum / known) : kNone;
    }
  }
  return means;
}

/// Calls visit(x, y, column, row) for each cell of `frame` with its place in a raster of another frame.
template <class Visit>
void for_each_place(const GridFrame& frame, const GridFrame& raster, const RunContext& run, const Visit& visit) {
  const GdalCall call("crs");
  const Placement from = placement_of(frame), to = placement_of(raster);
  CellFinder finder(from, frame.width, to, raster.width, call);
  std::vector<double> columns(static_cast<size_t>(frame.width)), rows(columns.size());
  for (int y = 0; y < frame.height; ++y) {
    run.check_cancelled();
    if (y % 64 == 63) run.report(static_cast<double>(y) / frame.height);
    finder.locate(y, columns, rows);
    for (int x = 0; x < frame.width; ++x) visit(x, y, columns[static_cast<size_t>(x)], rows[static_cast<size_t>(x)]);
  }
}

/// Cells that lie on the lattice of the raster but for rounding are on it.
double on_lattice(double position) {
  constexpr double kRounding = 1e-6;
  const double near = std::round(position);
  return std::abs(position - near) < kRounding ? near : position;
}

}  // namespace

Extent in_system(const Extent& extent, const std::string& crs) {
  return extent.crs == crs ? extent : moved_extent(extent, Way(extent.crs, crs), crs);
}

Drawing in_system(Drawing drawing, const std::string& crs) {
  if (drawing.crs == crs) return drawing;
  const Way way(drawing.crs, crs);
  for (NamedArea& area : drawing.areas) {
    for (Polygon& part : area.parts) {
      way.move(part.outer);
      for (Ring& hole : part.holes) way.move(hole);
    }
  }
  for (ValuedLine& line : drawing.lines) way.move(line.points);
  std::vector<Vec2> places;
  for (const ValuedPoint& point : drawing.points) places.push_back(point.place);
  way.move(places);
  for (size_t i = 0; i < places.size(); ++i) drawing.points[i].place = places[i];
  if (drawing.frame) drawing.frame = moved_frame(*drawing.frame, way, crs);
  drawing.crs = crs;
  return drawing;
}

ContourSet in_system(ContourSet contours, const std::string& crs) {
  if (contours.frame.crs == crs) return contours;
  const Way way(contours.frame.crs, crs);
  for (Contour& contour : contours.contours) way.move(contour.ring);
  contours.frame = moved_frame(contours.frame, way, crs);
  return contours;
}

Tin in_system(Tin tin, const std::string& crs) {
  if (tin.frame.crs == crs) return tin;
  const Way way(tin.frame.crs, crs);
  way.move(tin.nodes);
  for (TinRegion& region : tin.regions) way.move(region.outline);
  tin.frame = moved_frame(tin.frame, way, crs);
  return tin;
}

Grid<float> in_system(const Grid<float>& grid, const std::string& crs, const RunContext& run) {
  if (grid.frame().crs == crs) return grid;
  return on_cells(grid, moved_frame(grid.frame(), Way(grid.frame().crs, crs), crs), run);
}

LabelMap in_system(const LabelMap& labels, const std::string& crs, const RunContext& run) {
  if (labels.frame().crs == crs) return labels;
  return on_cells(labels, moved_frame(labels.frame(), Way(labels.frame().crs, crs), crs), run);
}

Grid<float> on_cells(const Grid<float>& grid, const GridFrame& frame, const RunContext& run) {
  const double ratio = frame.cell_m / grid.cell_m();
  if (ratio >= 2) {
    const auto factor = static_cast<int>(std::min(ratio, 65536.0));
    return on_cells(averaged(grid, factor, run), frame, run);
  }
  Grid<float> out(frame);
  for_each_place(frame, grid.frame(), run, [&](int x, int y, double column, double row) {
    out(x, y) = sample_known(grid, on_lattice(column), on_lattice(row));
  });
  return out;
}

LabelMap on_cells(const LabelMap& labels, const GridFrame& frame, const RunContext& run) {
  LabelMap out(frame, Region::abyss);
  for_each_place(frame, labels.frame(), run, [&](int x, int y, double column, double row) {
    if (!(column >= -0.5 && row >= -0.5 && column < labels.width() - 0.5 && row < labels.height() - 0.5)) return;
    out(x, y) = labels(static_cast<int>(std::lround(column)), static_cast<int>(std::lround(row)));
  });
  return out;
}

}  // namespace seamount::io
