#include "seamount/io/join.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/io/raster_files.h"
#include "seamount/model/sample_known.h"

namespace seamount::io {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

struct Sheet {
  std::string path;
  Loaded loaded;
  Placement place;
  bool finished = false;  ///< it is in metres already: its side-car said all

  const Grid<float>& values() const { return loaded.stored.values; }
};

bool one_system(const OGRSpatialReference& a, const OGRSpatialReference& b) {
  return a.IsEmpty() || b.IsEmpty() ? a.IsEmpty() == b.IsEmpty() : a.IsSame(&b) != 0;
}

Sheet load_sheet(const std::string& path, const ReadOptions& options) {
  Sheet sheet;
  sheet.path = path;
  sheet.loaded = load_raster(path, options, Meaning::heights);
  Stored& stored = sheet.loaded.stored;
  if (sheet.loaded.sidecar) {
    // Through the common way: it flips and places.
    HeightField placed = finish_raster(std::move(sheet.loaded), path, options, Meaning::heights);
    sheet.place = placement_of(placed.frame());
    sheet.loaded = {Stored{std::move(placed), 0.0, "", ""}, std::nullopt};
    sheet.loaded.stored.crs = crs_text(&sheet.place.system);
    sheet.loaded.stored.placement = sheet.place;
    sheet.finished = true;
    return sheet;
  }
  if (!stored.placement) throw IoError(path, "does not say where it lies, so it cannot be joined to others");
  choose_system(stored, path, options, Meaning::heights);
  sheet.place = *stored.placement;
  return sheet;
}

/// The rectangle of a sheet in the system of the first, in cells of the first from its north-western corner.
struct Box {
  double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
  void include(const Box& other) {
    x0 = std::min(x0, other.x0), y0 = std::min(y0, other.y0);
    x1 = std::max(x1, other.x1), y1 = std::max(y1, other.y1);
  }
};

Box box_of(const Sheet& sheet, const Sheet& first) {
  const GdalCall call(sheet.path);
  constexpr int kSteps = 32;
  const double east = sheet.place.west + sheet.values().width() * sheet.place.cell_x;
  const double south = sheet.place.north - sheet.values().height() * sheet.place.cell_y;
  std::vector<double> x, y;
  for (int i = 0; i <= kSteps; ++i) {
    const double u = static_cast<double>(i) / kSteps;
    const double along = sheet.place.west + u * (east - sheet.place.west),
                 down = south + u * (sheet.place.north - south);
    x.insert(x.end(), {along, along, sheet.place.west, east});
    y.insert(y.end(), {sheet.place.north, south, down, down});
  }
  if (!one_system(sheet.place.system, first.place.system)) {
    const TransformPtr way(OGRCreateCoordinateTransformation(&sheet.place.system, &first.place.system));
    if (sheet.place.system.IsEmpty() || first.place.system.IsEmpty() || !way)
      call.fail("cannot be brought to the coordinate system of '" + first.path + "'");
    if (way->Transform(static_cast<int>(x.size()), x.data(), y.data()) == FALSE)
      call.fail("lies outside of the coordinate system of '" + first.path + "'");
  }
  const double period = period_of(first.place.system);
  const double middle = first.place.west + 0.5 * first.values().width() * first.place.cell_x;
  Box box;
  for (size_t i = 0; i < x.size(); ++i) {
    if (period > 0) x[i] += period * std::round((middle - x[i]) / period);
    const double column = (x[i] - first.place.west) / first.place.cell_x;
    const double row = (first.place.north - y[i]) / first.place.cell_y;
    box.include({column, row, column, row});
  }
  return box;
}

/// Cells by which a sheet is moved against the lattice; nothing if it lies on another.
bool on_lattice(const Sheet& sheet, const Sheet& first, const Box& box) {
  constexpr double kCell = 1e-6, kOffset = 0.01;
  const auto whole = [&](double offset) { return std::abs(offset - std::round(offset)) < kOffset; };
  return one_system(sheet.place.system, first.place.system) &&
         std::abs(sheet.place.cell_x / first.place.cell_x - 1) < kCell &&
         std::abs(sheet.place.cell_y / first.place.cell_y - 1) < kCell && whole(box.x0) && whole(box.y0);
}

void paste(const Grid<float>& values, int column, int row, Grid<float>& all) {
  for (int y = std::max(0, -row); y < values.height() && row + y < all.height(); ++y) {
    for (int x = std::max(0, -column); x < values.width() && column + x < all.width(); ++x) {
      float& z = all(column + x, row + y);
      if (std::isnan(z)) z = values(x, y);
    }
  }
}

/// Reads a sheet of another lattice between its cells.
void sample_into(const Sheet& sheet, const Placement& lattice, const Box& box, int west, int north, Grid<float>& all,
                 const RunContext& run) {
  const GdalCall call(sheet.path);
  CellFinder finder(lattice, all.width(), sheet.place, sheet.values().width(), call);
  std::vector<double> columns(static_cast<size_t>(all.width())), rows(columns.size());
  const int from = std::max(0, static_cast<int>(std::floor(box.y0)) - north);
  const int to = std::min(all.height(), static_cast<int>(std::ceil(box.y1)) - north);
  const int left = std::max(0, static_cast<int>(std::floor(box.x0)) - west);
  const int right = std::min(all.width(), static_cast<int>(std::ceil(box.x1)) - west);
  for (int y = from; y < to; ++y) {
    run.check_cancelled();
    finder.locate(y, columns, rows);
    for (int x = left; x < right; ++x) {
      if (!std::isnan(all(x, y))) continue;
      all(x, y) = sample_known(sheet.values(), columns[static_cast<size_t>(x)], rows[static_cast<size_t>(x)]);
    }
  }
}

}  // namespace

HeightField read_joined_heights(const std::vector<std::string>& paths, const ReadOptions& options) {
  if (paths.empty()) throw InvalidArgument("files", "names no file");
  std::vector<Sheet> sheets;
  std::vector<Box> boxes;
  Box all_of;
  for (size_t i = 0; i < paths.size(); ++i) {
    ReadOptions own = options;
    own.run = options.run.part(0.5 * static_cast<double>(i) / static_cast<double>(paths.size()),
                               0.5 * static_cast<double>(i + 1) / static_cast<double>(paths.size()));
    sheets.push_back(load_sheet(paths[i], own));
    boxes.push_back(box_of(sheets.back(), sheets.front()));
    all_of.include(boxes.back());
  }
  constexpr double kRounding = 0.01;
  const double west = std::floor(all_of.x0 + kRounding), north = std::floor(all_of.y0 + kRounding);
  const double width = std::ceil(all_of.x1 - kRounding) - west, height = std::ceil(all_of.y1 - kRounding) - north;
  if (!(width * height <= static_cast<double>(options.max_cells)))
    throw IoError(paths[0], "joined to the others it would have more than " + std::to_string(options.max_cells) +
                                " cells; do they lie side by side?");
  Stored& first = sheets.front().loaded.stored;
  Stored joined{Grid<float>(GridFrame{static_cast<int>(width), static_cast<int>(height)}, kNone), first.code_max,
                first.format, first.type};
  joined.placement = sheets.front().place;
  joined.placement->west += west * joined.placement->cell_x;
  joined.placement->north -= north * joined.placement->cell_y;
  joined.crs = first.crs;
  for (size_t i = 0; i < sheets.size(); ++i) {
    const Sheet& sheet = sheets[i];
    const bool alike =
        (sheet.loaded.stored.code_max > 0) == (first.code_max > 0) && sheet.finished == sheets.front().finished;
    if (!alike && options.range)
      throw IoError(sheet.path, "holds other numbers than '" + paths[0] + "': codes and heights cannot be joined");
    const Box& box = boxes[i];
    if (on_lattice(sheet, sheets.front(), box))
      paste(sheet.values(), static_cast<int>(std::lround(box.x0 - west)), static_cast<int>(std::lround(box.y0 - north)),
            joined.values);
    else
      sample_into(sheet, *joined.placement, box, static_cast<int>(west), static_cast<int>(north), joined.values,
                  options.run);
  }
  ReadOptions rest = options;
  rest.crs.clear();  // was heeded for each of them
  if (sheets.front().finished) rest.range.reset();
  rest.run = options.run.part(0.5, 1.0);
  return finish_raster({std::move(joined), std::nullopt}, paths[0] + " and the files joined to it", rest,
                       Meaning::heights);
}

}  // namespace seamount::io
