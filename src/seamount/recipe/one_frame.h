// Everything that an operator sees lies in one frame: that of the first raster among its inputs, or the document's
// domain.
//
// A domain that states no coordinate system lies nowhere on the Earth yet: it takes the system of what is brought to
// it, and lies around it where the two would not meet.
#pragma once

#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/extent.h"
#include "seamount/recipe/recipe.h"
#include "seamount/recipe/value.h"

namespace seamount::recipe {

/// Inputs as an operator sees them, and the domain that goes with them.
struct Together {
  Values in;
  GridFrame domain;
};

/// Brings the inputs of an operator together as its ports say, and fills cells without a value for ports that do not
/// respect them; both are said. Throws IncompatibleInputs{port} for what lies nowhere on the frame, with both places.
Together bring_together(const Operator& op, Values in, const GridFrame& domain, const RunContext& run);

/// An input that is no raster as bring_together() brings it beside one whose frame is `frame` and which messages call
/// `whose`. Throws as it does.
Value brought_beside(const Port& port, Value value, const GridFrame& frame, const std::string& whose,
                     const RunContext& run);

/// `domain` as it is if it states a system or meets the extent; else moved there, in whole cells.
GridFrame placed_domain(GridFrame domain, const Extent& extent);

/// A drawing that a parameter names, in the system of the domain; a domain without one is placed by it. Throws
/// IoError{path} where the two do not meet.
Drawing bring_drawing(Drawing drawing, GridFrame& domain, const std::string& path);

}  // namespace seamount::recipe
