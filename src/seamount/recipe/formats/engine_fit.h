// How a terrain becomes the samples of an engine: sizes and fits that engine outputs, splat maps and bundles share.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/io/engine.h"
#include "seamount/recipe/param_json.h"
#include "seamount/recipe/read_place.h"
#include "seamount/recipe/registry.h"

namespace seamount::recipe {

/// How a terrain that is no square is fitted. by_engine: crop for those that read squares only, else whole.
enum class Fit { by_engine, crop, pad, whole };

/// Meaning of the parameter "fit".
inline constexpr const char* kFitMeaning =
    "a terrain that is no square: crop takes its middle, pad adds its repeated edge, whole leaves it as long as it is; "
    "by_engine: crop for unreal and unity, which read squares, else whole";

/// Parameters that complete() made: nothing is wrong with them.
template <class Params>
Params read_complete(const Json& complete_params) {
  Diagnostics none;
  return read_params<Params>(complete_params, {"", none});
}

/// The params of the terrain.samples that make it; `sizes`: those that the engine reads, empty: any.
Json samples_params(int size, Fit fit, const std::vector<int>& sizes);

/// Reports a size that the engine does not read, and a fit that makes no square for one that wants squares.
void check_fit(int size, Fit fit, const std::vector<int>& sizes, std::string_view engine, const ReadPlace& place);

}  // namespace seamount::recipe

template <>
struct seamount::Choices<seamount::recipe::Fit> {
  static constexpr std::array<std::string_view, 4> names = {"by_engine", "crop", "pad", "whole"};
};
