// Parameters that were renamed since a document was written: they are read under their present names, each with a note.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/recipe/read_place.h"

namespace seamount::recipe {

/// "'creep_m2' is now called 'creep_m2_yr'".
std::string renamed_text(const std::string& former, const std::string& now);

/// An object of parameters with every former name replaced. Notes each to `place`; a parameter that is given under both
/// names is a defect. `given`, which must be an object, and `place` must outlive it.
class PresentNames {
 public:
  PresentNames(const Json& given, std::span<const FormerName> former, const ReadPlace& place);

  const Json& object() const { return renamed_ ? *renamed_ : given_; }

  /// Defects that were found under present names since the constructor go where the former ones are written.
  void move_defects();

 private:
  void replace(const FormerName& former);

  const Json& given_;
  const ReadPlace& place_;
  size_t defects_before_;
  std::optional<Json> renamed_;                              ///< absent where nothing was renamed
  std::vector<std::pair<std::string, std::string>> places_;  ///< present and former JSON pointers
};

}  // namespace seamount::recipe
