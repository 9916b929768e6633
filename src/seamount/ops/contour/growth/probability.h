// The probability map of growth, per node (P2 sec. 4.2, fig. 11).
#pragma once

#include <span>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/image.h"

namespace seamount::contour {

/// Fractal noise from 1/4 to 1, even in its logarithm (fronts run as fast as P is high, so that heights vary evenly),
/// raised to a power. Parallel.
std::vector<float> noise_probability(std::span<const Vec2> places, const geom::Fbm& shape, double exponent, Seed seed,
                                     const RunContext& run);

/// A field read bilinearly, clamped at its edge, raised to a power. Throws IncompatibleInputs{place, value} where it is
/// not in [0, 1]. Parallel.
std::vector<float> field_probability(std::span<const Vec2> places, const ScalarField& field, double exponent,
                                     const RunContext& run);

/// A picture stretched over the domain: black 0, white 1, colours by their mean. REQUIRES: not empty.
ScalarField painted_probability(const Image& picture, const GridFrame& domain);

}  // namespace seamount::contour
