// The area that a tool makes anew: an outline among the contours of a set, on a lattice.
#pragma once

#include <string>
#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/grid.h"
#include "seamount/ops/contour/edit/patch.h"

namespace seamount::contour {

/// The different heights of a set, ascending.
std::vector<double> levels_of(const ContourSet& set);

/// The least difference between levels; 1 if there is only one.
double min_gap(const std::vector<double>& levels);

/// Levels continued at either end by its last gap until they cover [low, high]. Throws InvalidArgument{name} where
/// that would be more than 10000.
std::vector<double> levels_covering(std::vector<double> levels, double low, double high, const std::string& name);

/// Height of the innermost contour around a place, moved a little into the band that it bounds (up in a hill, down in a
/// basin); one gap below the lowest level if no contour holds the place.
double height_around(const ContourSet& set, Vec2 place);

/// A cell size for an outline of this extent among lines with edges of this mean length.
double lattice_cell(double extent_m, double mean_edge_m);
double mean_edge(const ContourSet& set, const std::vector<size_t>& contours);

struct EditArea {
  Patch patch;
  ScalarField inward;  ///< distance of each node to the outline, metres; below 0 outside
  ScalarField ground;  ///< between the contours of the set
};

/// Ground around an outline that is looked at to find out where water comes from and goes.
double surroundings(const Polygon& outline);

/// The lattice of an outline, with at least `margin_m` around it. Its patch holds every square with a node in the
/// outline, so that it is a little larger than that; or, strictly inside, only squares with a node at least 3.5 cells
/// in. Throws InvalidArgument{name}: outline not sound or not wholly in the domain, set without contours.
EditArea make_edit_area(const ContourSet& set, const Polygon& outline, bool strictly_inside, double margin_m,
                        const std::string& name, const RunContext& run);

}  // namespace seamount::contour
