// Where a stored raster lies, and which of its cells lie at which places of another. Not part of the public interface.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "seamount/io/gdal_call.h"
#include "seamount/model/grid.h"

namespace seamount::io {

/// A north-up affine placement in a system of its own.
struct Placement {
  double west = 0, north = 0;     ///< outer corner of the first cell
  double cell_x = 1, cell_y = 1;  ///< both > 0, in units of the system
  OGRSpatialReference system;     ///< empty: metres without a system

  double x(double column) const { return west + (column + 0.5) * cell_x; }
  double y(double row) const { return north - (row + 0.5) * cell_y; }
};

/// Of a grid that has one in metres. Throws InvalidArgument{"crs"}.
Placement placement_of(const GridFrame& frame);

/// After how many units the system's x comes back to the same place: 360 for degrees, 40 075 017 for Web Mercator; 0
/// for systems that do not go around the Earth.
double period_of(const OGRSpatialReference& system);

/// The largest error of lengths on a raster that are taken for metres, as a share: 1.1 at 61 N in Web Mercator; 0
/// without a system or where it cannot be told.
double scale_error(const Placement& placement, int width, int height);

/// Finds the cells of one raster in another, row by row; serial. The way between two systems is exact on a lattice of
/// every 16th cell and linear between, which is off by less than a hundredth of a cell for cells below a kilometre.
class CellFinder {
 public:
  /// For `width` columns of `from` from `first` on. Throws IoError through `call` where there is no way between the
  /// systems.
  CellFinder(const Placement& from, int width, const Placement& to, int to_width, const GdalCall& call, int first = 0);

  /// Fractional columns and rows in `to` of the cells of row y of `from`; NaN where there is no such place. Rows in
  /// ascending order are fastest.
  void locate(int y, std::span<double> columns, std::span<double> rows);

 private:
  struct Line {
    std::vector<double> columns, rows;
  };
  Line lattice_line(double y);

  const Placement& from_;
  const Placement& to_;
  int width_, first_;
  double middle_x_, period_;
  TransformPtr way_;
  int top_ = -1;
  Line upper_, lower_;
};

}  // namespace seamount::io
