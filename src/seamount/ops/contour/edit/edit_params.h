// Parameters of contour.edit (edit.h): the tools of a session, and what to do where contours would cross.
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/ops/contour/edit/tools.h"

namespace seamount::contour {

enum class OnCrossing { limit, refuse };

struct EditParams {
  std::vector<Edit> edits;
  OnCrossing on_crossing = OnCrossing::limit;

  static constexpr auto fields() {
    using P = EditParams;
    return std::tuple(field(&P::edits, "edits", "the tools, in the order of their use"),
                      field(&P::on_crossing, "on_crossing",
                            "of an edit that would make contours cross: limit its strength and say so, or refuse it"));
  }
};

}  // namespace seamount::contour

template <>
struct seamount::Choices<seamount::contour::OnCrossing> {
  static constexpr std::array<std::string_view, 2> names = {"limit", "refuse"};
};
