#include "seamount/ops/contour/edit/selection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/text.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/segment.h"
#include "seamount/ops/contour/move/places.h"

namespace seamount::contour {
namespace {

double squared_distance(const Ring& ring, Vec2 p) {
  double best = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < ring.size(); ++i) {
    best = std::min(best, geom::squared_distance_to_segment(p, ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]));
  }
  return best;
}

/// Marks the contour nearest to each place.
std::vector<char> nearest(const ContourSet& set, const Polyline& places) {
  std::vector<char> marked(set.contours.size(), 0);
  for (const Vec2 place : places) {
    size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < set.contours.size(); ++i) {
      const double squared = squared_distance(set.contours[i].ring, place);
      if (!(squared < least)) continue;
      least = squared;
      best = i;
    }
    if (!marked.empty()) marked[best] = 1;
  }
  return marked;
}

bool lies_within(const Ring& ring, const std::vector<Polygon>& polygons) {
  return std::any_of(polygons.begin(), polygons.end(), [&](const Polygon& polygon) {
    if (!std::all_of(ring.begin(), ring.end(), [&](Vec2 p) { return geom::contains(polygon, p); })) return false;
    if (geom::find_crossing(ring, polygon.outer)) return false;
    return std::none_of(polygon.holes.begin(), polygon.holes.end(), [&](const Ring& hole) {
      return geom::find_crossing(ring, hole).has_value() || geom::contains(ring, hole[0]);
    });
  });
}

void check(const ContourSet& set, const Selection& selection, const std::string& name) {
  if (selection.low_m && selection.high_m && *selection.low_m > *selection.high_m)
    throw InvalidArgument(name + ".low_m",
                          format_number(*selection.low_m) + " is above high_m = " + format_number(*selection.high_m));
  if (selection.min_area_m2 && selection.max_area_m2 && *selection.min_area_m2 > *selection.max_area_m2)
    throw InvalidArgument(name + ".min_area_m2", format_number(*selection.min_area_m2) + " is above max_area_m2 = " +
                                                     format_number(*selection.max_area_m2));
  for (const int i : selection.index) {
    if (static_cast<size_t>(i) >= set.contours.size())
      throw InvalidArgument(name + ".index", "there is no contour " + std::to_string(i) + "; the set has " +
                                                 std::to_string(set.contours.size()) + ", numbered from 0");
  }
  check_inside(selection.at, set.frame, name + ".at");
  for (const Polygon& polygon : selection.within) {
    if (const auto defect = geom::find_defect(polygon)) throw InvalidArgument(name + ".within", *defect);
  }
}

}  // namespace

std::vector<size_t> select(const ContourSet& set, const Selection& selection, const std::string& name) {
  check(set, selection, name);
  const std::vector<char> near = selection.at.empty() ? std::vector<char>() : nearest(set, selection.at);
  std::vector<char> listed(selection.index.empty() ? 0 : set.contours.size(), 0);
  for (const int i : selection.index) listed[static_cast<size_t>(i)] = 1;
  std::vector<char> chosen(set.contours.size(), 0);
  std::vector<size_t> result;
  for (size_t i = 0; i < set.contours.size(); ++i) {
    const Contour& contour = set.contours[i];
    const auto holds = [&] {
      const double height = contour.height_m;
      if (height < selection.low_m.value_or(height) || height > selection.high_m.value_or(height)) return false;
      if (!near.empty() && near[i] == 0) return false;
      if (!listed.empty() && listed[i] == 0) return false;
      if (selection.min_area_m2 || selection.max_area_m2) {
        const double area = std::abs(geom::signed_area(contour.ring));
        if (area < selection.min_area_m2.value_or(area) || area > selection.max_area_m2.value_or(area)) return false;
      }
      return selection.within.empty() || lies_within(contour.ring, selection.within);
    };
    const bool inherited = selection.inner && contour.parent >= 0 && chosen[static_cast<size_t>(contour.parent)] != 0;
    chosen[i] = inherited || holds() ? 1 : 0;
    if (chosen[i] != 0) result.push_back(i);
  }
  return result;
}

void remove_contours(ContourSet& set, const std::vector<char>& gone) {
  std::vector<int> place(set.contours.size(), -1);  // of what stands for the contour: itself or what encloses it
  std::vector<Contour> left;
  for (size_t i = 0; i < set.contours.size(); ++i) {
    Contour& contour = set.contours[i];
    contour.parent = contour.parent < 0 ? -1 : place[static_cast<size_t>(contour.parent)];
    place[i] = gone[i] != 0 ? contour.parent : static_cast<int>(left.size());
    if (gone[i] == 0) left.push_back(std::move(contour));
  }
  set.contours = std::move(left);
}

std::string describe(const Selection& selection) {
  std::vector<std::string> parts;
  if (selection.low_m) parts.push_back("heights from " + format_number(*selection.low_m) + " m");
  if (selection.high_m) parts.push_back("heights up to " + format_number(*selection.high_m) + " m");
  if (selection.min_area_m2) parts.push_back("areas from " + format_number(*selection.min_area_m2) + " m2");
  if (selection.max_area_m2) parts.push_back("areas up to " + format_number(*selection.max_area_m2) + " m2");
  if (!selection.within.empty()) parts.emplace_back("within the polygons");
  if (!selection.at.empty()) parts.push_back("nearest to " + place_text(selection.at[0]));
  if (!selection.index.empty()) parts.push_back("number " + std::to_string(selection.index[0]));
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? "all" : text;
}

}  // namespace seamount::contour
