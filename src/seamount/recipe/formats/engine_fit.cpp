#include "seamount/recipe/formats/engine_fit.h"

#include <fmt/format.h>

#include <algorithm>

namespace seamount::recipe {

Json samples_params(int size, Fit fit, const std::vector<int>& sizes) {
  const bool whole = fit == Fit::whole || (fit == Fit::by_engine && sizes.empty());
  return {{"layout", whole ? "whole" : "square"},
          {"fit", fit == Fit::pad ? "pad" : "crop"},
          {"samples", size},
          {"choices", sizes}};
}

void check_fit(int size, Fit fit, const std::vector<int>& sizes, std::string_view engine, const ReadPlace& place) {
  if (sizes.empty()) return;
  if (size > 0 && std::find(sizes.begin(), sizes.end(), size) == sizes.end())
    place.at("size").fail(
        fmt::format("{} is not a size that {} reads; allowed are {}", size, engine, fmt::join(sizes, ", ")));
  if (fit == Fit::whole) place.at("fit").fail(fmt::format("{} reads squares only", engine));
}

}  // namespace seamount::recipe
