#include "seamount/recipe/domain.h"

#include <fmt/format.h>

#include <cmath>

#include "seamount/io/projection.h"
#include "seamount/recipe/recipe.h"
#include "seamount/recipe/set_value.h"
#include "seamount/recipe/variables.h"

namespace seamount::recipe {
namespace {

constexpr double kMostCellsASide = 65536;

}  // namespace

GridFrame domain_frame(const DomainParams& params, int64_t most) {
  check_params(params);
  const double width = std::round(params.width_m / params.cell_m);
  const double height = std::round(params.height_m / params.cell_m);
  if (width < 1 || height < 1) {
    throw InvalidArgument("cell_m", format_number(params.cell_m) + " is larger than the domain");
  }
  if (width > kMostCellsASide || height > kMostCellsASide || width * height > static_cast<double>(most)) {
    throw InvalidArgument(
        "cell_m", fmt::format("{} m gives {:.0f} x {:.0f} cells; at most 65536 a side and {} in all are possible",
                              format_number(params.cell_m), width, height, most == kMostCells ? "2^30" : "2^32"));
  }
  GridFrame frame = GridFrame::centred(static_cast<int>(width), static_cast<int>(height), params.cell_m);
  frame.west_m += params.x_m;
  frame.north_m += params.y_m;
  frame.crs = io::metric_crs(params.crs);
  if (const double error = io::length_error(frame); error > io::kMostLengthError)
    throw InvalidArgument("crs", fmt::format("lengths in '{}' are off by up to {:.1f} % there; state a system that is "
                                             "true to scale at x_m, y_m, such as UTM",
                                             params.crs, 100 * error));
  return frame;
}

void apply_changes(Json& root, const RecipeChanges& changes, const Registry& registry) {
  for (const std::string& assignment : changes.sets) set_value(root, assignment, registry);
  if (!root.is_object()) return;
  if (changes.seed) root["seed"] = *changes.seed;
  if (changes.size) {
    Json& domain = root["domain"];
    if (domain.is_null()) domain = Json::object();
    Diagnostics reported_later;
    const VariablesApplied filled(root, {"", reported_later});
    const Json& stated = filled.root()["domain"];
    const auto side = [&](const char* key, double otherwise) {
      return stated.is_object() && stated.contains(key) && stated[key].is_number() ? stated[key].get<double>()
                                                                                   : otherwise;
    };
    const DomainParams defaults;
    if (domain.is_object()) {
      domain["cell_m"] =
          std::max(side("width_m", defaults.width_m), side("height_m", defaults.height_m)) / *changes.size;
    }
  }
}

}  // namespace seamount::recipe
