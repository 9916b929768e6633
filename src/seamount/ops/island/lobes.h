// The lobes of a plan: the parts of its land that would be islands of their own, were the sea a little higher.
//
// They are found as the largest discs in the land that do not overlap, so a chain of them follows an elongated island,
// a peninsula has one behind its isthmus, and every island of several has at least one. Heights follow them
// (summits.h): a lobe rises as high as an island of its width would.
#pragma once

#include <vector>

#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"

namespace seamount::island {

/// A disc in the land that touches its border.
struct Lobe {
  Vec2 centre;
  double radius_m = 0;
};

/// Largest first, none smaller than an eighth of the largest in its polygon, at most 48. Exact to about a hundredth of
/// a polygon's extent; empty where there are no areas. A few ms.
std::vector<Lobe> find_lobes(const std::vector<Polygon>& land, const RunContext& run = {});

/// Height in metres that suits an island of compact form with this width (NATURE: shields stand as high as a twentieth
/// of their width, small and worn ones steeper): 110 m (w sqrt(pi) / 2 / 1 km)^0.78, at most 4200 m.
double natural_height(double width_m);

}  // namespace seamount::island
