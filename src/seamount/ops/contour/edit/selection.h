// Which contours of a set a tool works on (P2 sec. 6.6).
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/model/contour_set.h"

namespace seamount::contour {

/// Contours that fulfil everything that is given. Nothing given: all of them.
struct Selection {
  std::optional<double> low_m;
  std::optional<double> high_m;
  std::optional<double> min_area_m2;
  std::optional<double> max_area_m2;
  std::vector<Polygon> within;
  Polyline at;
  std::vector<int> index;
  bool inner = false;

  static constexpr auto fields() {
    using P = Selection;
    return std::tuple(field(&P::low_m, "low_m", "m", between(-12000, 9000), "heights from here on"),
                      field(&P::high_m, "high_m", "m", between(-12000, 9000), "heights up to here"),
                      field(&P::min_area_m2, "min_area_m2", "m2", at_least(0), "enclosed areas from here on"),
                      field(&P::max_area_m2, "max_area_m2", "m2", at_least(0), "enclosed areas up to here"),
                      field(&P::within, "within", "those that lie wholly in one of these polygons"),
                      field(&P::at, "at", "the contour nearest to each of these places"),
                      field(&P::index, "index", "", at_least(0), "these, by their number in the set, from 0"),
                      field(&P::inner, "inner", "and everything that lies inside a contour so found"));
  }
};

/// Numbers of the selected contours, ascending. Throws InvalidArgument{name...}: low above high, an index that is not
/// there, a place outside the domain, a polygon that is not sound. Linear in the points and places.
std::vector<size_t> select(const ContourSet& set, const Selection& selection, const std::string& name);

/// Takes contours out, those with gone[i] != 0; what they enclosed belongs to what encloses them.
void remove_contours(ContourSet& set, const std::vector<char>& gone);

/// What the selection asks for, for messages: "heights from 100, nearest to (10, 20)"; "all" if nothing.
std::string describe(const Selection& selection);

}  // namespace seamount::contour
