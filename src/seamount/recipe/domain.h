// The domain of a document, and changes that the command line makes to a document before it is read.
#pragma once

#include "seamount/recipe/param_json.h"

namespace seamount {
struct GridFrame;
}

namespace seamount::recipe {

struct RecipeChanges;
class Registry;

/// "domain" of a recipe: a rectangle of square cells around a place.
struct DomainParams {
  double width_m = 10240;
  double height_m = 10240;
  double cell_m = 10;
  std::string crs;
  double x_m = 0;
  double y_m = 0;

  static constexpr auto fields() {
    return std::tuple(
        field(&DomainParams::width_m, "width_m", "m", between(1e-3, 1e8), "width of the terrain, west to east"),
        field(&DomainParams::height_m, "height_m", "m", between(1e-3, 1e8), "height of the terrain, south to north"),
        field(&DomainParams::cell_m, "cell_m", "m", between(1e-4, 1e6), "cell size"),
        field(&DomainParams::crs, "crs",
              "coordinate system in metres, such as EPSG:32604, into which all that has a place is brought; empty: "
              "local metres, or the system of what is brought"),
        field(&DomainParams::x_m, "x_m", "m", between(-1e8, 1e8), "where the middle lies, eastwards"),
        field(&DomainParams::y_m, "y_m", "m", between(-1e8, 1e8), "where the middle lies, northwards"));
  }
};

/// Cells of a domain in memory, and of one that is run in tiles.
inline constexpr int64_t kMostCells = int64_t{1} << 30, kMostCellsInTiles = int64_t{1} << 32;

/// The frame of a domain. Throws InvalidArgument for more than 65536 cells a side or `most` in all, and for a system
/// that is unknown, not in metres, or off by more than 1 % in length there.
GridFrame domain_frame(const DomainParams& params, int64_t most = kMostCells);

/// Applies --set, --seed and --size to a document. Throws InvalidArgument{"--set"} for a path that leads nowhere.
void apply_changes(Json& root, const RecipeChanges& changes, const Registry& registry);

}  // namespace seamount::recipe
