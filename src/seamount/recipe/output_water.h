// Rivers and lakes that an output draws without a step of one's own: "rivers": true. Not part of the public interface.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "seamount/recipe/read_sources.h"

namespace seamount::recipe {

/// What an output says of the water that it draws.
struct OutputWater {
  std::map<std::string, Source> given;  ///< by the drawing operator's inputs, "rivers" and "lake"
  std::optional<Json> rivers, lake;     ///< to be found in the output's terrain, with these parameters
};

/// The inputs of water, "rivers" and "lake", of the operator that draws a format; none where nothing draws it.
std::vector<std::string> waters_of(const Registry& registry, const OutputFormat& format);

/// Reads the members that `waters` names. "rivers": true, or an object of hydrology.rivers' parameters,
/// means lakes as well, unless "lake" says otherwise.
OutputWater read_water(const Json& output, const std::vector<std::string>& waters, const ReadPlace& place,
                       const std::vector<DraftStep>& drafts);

/// Adds the steps hydrology.lakes and hydrology.rivers that find the water of an output's terrain, unless the recipe
/// has the same already; all that is drawn, by input.
std::map<std::string, Source> add_water(Recipe& recipe, const Output& output, const OutputWater& water,
                                        const ReadPlace& place);

}  // namespace seamount::recipe
