// Contour sets for tests and benchmarks: hills of noise, wholly within their frame.
#pragma once

#include <algorithm>
#include <vector>

#include "seamount/geom/contour/contour.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/model/contour_set.h"

namespace seamount::contour {

/// Contours every `gap_m` of a hilly island on size x size cells of 20480 m in all.
inline ContourSet noise_contours(uint64_t seed, int size, double gap_m) {
  const GridFrame frame = GridFrame::centred(size, size, 20480.0 / size);
  ScalarField field =
      geom::fbm_grid(frame, Seed{seed}, {.wavelength_m = 6000, .octaves = 5, .cell_m = frame.cell_m}, {});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double r2 = (frame.x(x) * frame.x(x) + frame.y(y) * frame.y(y)) / (9500.0 * 9500.0);
      field(x, y) = std::min(700.0F * field(x, y) + static_cast<float>(900.0 * (1.0 - r2)),
                             static_cast<float>(2000.0 * (1.0 - r2)));
    }
  }
  const auto top = static_cast<double>(*std::max_element(field.cells().begin(), field.cells().end()));
  ContourSet set{frame, {}};
  for (double level = 20.0; level < top; level += gap_m) {
    for (const Polygon& area : geom::trace_areas(field, level)) {
      set.contours.push_back({level, area.outer, -1});
      for (const Ring& hole : area.holes) set.contours.push_back({level, hole, -1});
    }
  }
  geom::nest_contours(set.contours);
  return set;
}

/// Does the set keep all that ContourSet promises?
inline bool is_sound(const ContourSet& set) {
  for (const Contour& contour : set.contours)
    if (contour.ring.size() < 3) return false;
  if (geom::find_contour_crossing(set.contours)) return false;
  const std::vector<int> parents = geom::find_contour_parents(set.contours);
  for (size_t i = 0; i < parents.size(); ++i)
    if (parents[i] != set.contours[i].parent || parents[i] >= static_cast<int>(i)) return false;
  return true;
}

}  // namespace seamount::contour
