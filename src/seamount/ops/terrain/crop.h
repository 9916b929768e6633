// terrain.crop: a part of a terrain, cell by cell: a rectangle around a place, its middle or its summit.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"

namespace seamount::terrain {

/// What a crop is cut around where no place is given.
enum class Around { middle, highest, lowest };

struct CropParams {
  double width_m = 10000.0;
  std::optional<double> height_m;
  Around around = Around::middle;
  std::optional<double> x_m;
  std::optional<double> y_m;
  std::optional<double> longitude_deg;
  std::optional<double> latitude_deg;

  static constexpr auto fields() {
    using P = CropParams;
    return std::tuple(
        field(&P::width_m, "width_m", "m", between(1e-3, 1e7), "extent from west to east"),
        field(&P::height_m, "height_m", "m", between(1e-3, 1e7), "extent from south to north; by default the same"),
        field(&P::around, "around", "what is in the middle: the terrain's middle, its highest or its lowest cell"),
        field(&P::x_m, "x_m", "m", {}, "with y_m: the place in the middle instead, east"),
        field(&P::y_m, "y_m", "m", {}, "with x_m: the place in the middle, north"),
        field(&P::longitude_deg, "longitude_deg", "deg", between(-540, 540),
              "with latitude_deg: the place in the middle, on WGS 84; the terrain must have a coordinate system"),
        field(&P::latitude_deg, "latitude_deg", "deg", between(-90, 90),
              "with longitude_deg: the place in the middle"));
  }
};

/// Cells of a terrain that a crop keeps, and their frame.
struct CropCells {
  int column = 0, row = 0;
  GridFrame frame;
};

/// Those of crop(). `extreme`: the middle of the highest or lowest cell, where that is asked for. Says and throws what
/// crop() does.
CropCells crop_cells(const GridFrame& terrain, const CropParams& params, Vec2 extreme, const RunContext& run);

/// Is it cut around the highest or the lowest cell?
inline bool around_extreme(const CropParams& params) { return !params.x_m && params.around != Around::middle; }

/// The cells whose middles lie in the rectangle, at least one, unchanged and where they lay; of equally high or low
/// cells the first. What reaches beyond the terrain is cut off, which is said. Longitude and latitude are not for this
/// function: callers turn them into x_m and y_m. Throws InvalidArgument for params out of range, one coordinate without
/// the other, or a rectangle beside the terrain. Linear in the cells.
HeightField crop(const HeightField& terrain, const CropParams& params, const RunContext& run);

}  // namespace seamount::terrain

template <>
struct seamount::Choices<seamount::terrain::Around> {
  static constexpr std::array<std::string_view, 3> names = {"middle", "highest", "lowest"};
};
