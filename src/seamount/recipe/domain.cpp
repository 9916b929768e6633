#include "seamount/recipe/domain.h"

#include <fmt/format.h>

#include <cmath>

#include "seamount/io/projection.h"
#include "seamount/recipe/recipe.h"

namespace seamount::recipe {
namespace {

constexpr double kMostCellsASide = 65536;
constexpr double kMostCells = 1 << 30;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  size_t begin = 0;
  for (size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

/// The member that a path token names: a key, an index, or the id of a step.
Json* descend(Json& json, const std::string& token, bool create) {
  if (json.is_array()) {
    for (Json& item : json) {
      if (item.is_object() && item.contains("id") && item["id"] == token) return &item;
    }
    const bool digits =
        !token.empty() && token.size() < 7 && token.find_first_not_of("0123456789") == std::string::npos;
    if (digits && std::stoul(token) < json.size()) return &json[std::stoul(token)];
    return nullptr;
  }
  if (json.is_null() && create) json = Json::object();
  if (!json.is_object()) return nullptr;
  if (!json.contains(token) && !create) return nullptr;
  return &json[token];
}

void apply_set(Json& root, const std::string& assignment) {
  const size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InvalidArgument("--set", "expected PATH=VALUE, found '" + assignment + "'");
  }
  const std::string path = assignment.substr(0, equals);
  const std::string text = assignment.substr(equals + 1);
  Json* target = &root;
  const auto tokens = split(path, '.');
  bool among_params = false;  // a group that the recipe leaves out may be named
  for (size_t i = 0; i < tokens.size(); ++i) {
    const bool may_create = among_params || i + 1 == tokens.size() || tokens[i] == "params" || tokens[i] == "domain";
    among_params = among_params || tokens[i] == "params" || (tokens[0] == "outputs" && i == 1);
    target = descend(*target, tokens[i], may_create);
    if (target == nullptr) {
      throw InvalidArgument("--set", "'" + path + "' leads nowhere: the recipe has no '" + tokens[i] + "' there");
    }
  }
  const Json value = Json::parse(text, nullptr, false);
  *target = value.is_discarded() ? Json(text) : value;
}

}  // namespace

GridFrame domain_frame(const DomainParams& params) {
  check_params(params);
  const double width = std::round(params.width_m / params.cell_m);
  const double height = std::round(params.height_m / params.cell_m);
  if (width < 1 || height < 1) {
    throw InvalidArgument("cell_m", format_number(params.cell_m) + " is larger than the domain");
  }
  if (width > kMostCellsASide || height > kMostCellsASide || width * height > kMostCells) {
    throw InvalidArgument(
        "cell_m", fmt::format("{} m gives {:.0f} x {:.0f} cells; at most 65536 a side and 2^30 in all are possible",
                              format_number(params.cell_m), width, height));
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

void apply_changes(Json& root, const RecipeChanges& changes) {
  for (const std::string& assignment : changes.sets) apply_set(root, assignment);
  if (!root.is_object()) return;
  if (changes.seed) root["seed"] = *changes.seed;
  if (changes.size) {
    Json& domain = root["domain"];
    if (domain.is_null()) domain = Json::object();
    const auto side = [&](const char* key, double otherwise) {
      return domain.is_object() && domain.contains(key) && domain[key].is_number() ? domain[key].get<double>()
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
