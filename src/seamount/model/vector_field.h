// A vector at each cell: currents, winds.
#pragma once

#include "seamount/model/grid.h"

namespace seamount {

/// East and north components of one frame, m/s where it is a current.
struct VectorField {
  ScalarField x, y;

  const GridFrame& frame() const { return x.frame(); }
  bool empty() const { return x.empty(); }
  bool operator==(const VectorField&) const = default;
};

}  // namespace seamount
