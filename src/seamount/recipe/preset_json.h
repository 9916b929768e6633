// Presets (base/presets.h) in documents and in what describes parameters.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "seamount/recipe/json_document.h"
#include "seamount/recipe/read_place.h"

namespace seamount::recipe {

/// A preset without its C++ types.
struct PresetInfo {
  std::string name;
  std::string about;  ///< one line, no full stop
  Json sets;          ///< the parameters that it gives another value than their default, those of groups in objects
};

/// Members of `now` that differ from those of `before`, those of groups in objects.
Json changed_members(const Json& before, const Json& now);

/// Which of these an object's "preset" names; none if it has no such member or after a defect, which is reported.
std::optional<size_t> read_preset(const Json& object, const std::vector<std::string>& names, const ReadPlace& place);

/// "years 20000, slopes.creep_m2_yr 0.001"
std::string sets_text(const Json& sets, const std::string& group = "");

}  // namespace seamount::recipe
