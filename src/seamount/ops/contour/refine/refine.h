// contour.refine: a network made finer pass by pass, each pass held by the contours of the one before.
//
// Source: P2 sec. 6.6, which names it as future work: coarse growth for the large structures, then passes with smaller
// discs that refine the terrain and enrich the hierarchy of contours. How we do it: a pass takes contours from the
// coarse network, at more heights each time, gives these polygons of coarse triangles the detail that they lack
// (held_contours.h), and grows a finer network between them (contour.grow) whose heights follow the coarse ones' own
// distribution (contour.heights). Held contours stay where they are in all later passes; so do the given outlines that
// are finer than the network to come. Summits and basins inside the last contour keep their heights.
// Laws: each held contour is an outline of the result, of the height that the coarse network has there; nodes within it
// are not lower, nodes outside it not higher, to a millimetre; each node but those outside and a basin's deepest has a
// lower neighbour. The ground on held contours is theirs to within a hundredth of the relief on average, more only
// where they lie closer than nodes. A contour taken from a network moves by about a quarter of its spacing times
// `roughness`.
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/contour_set.h"
#include "seamount/model/tin.h"
#include "seamount/ops/contour/growth/grow_params.h"

namespace seamount::contour {

struct RefineParams {
  int passes = 2;
  std::optional<double> spacing_m;
  int contours = 0;
  double roughness = 1.0;
  ProbabilityKind probability = ProbabilityKind::noise;
  std::vector<double> feature_m;
  std::vector<double> exponent = {2.0};
  int octaves = 5;
  std::vector<RiverLine> rivers;
  double shore_slope_deg = 12.0;

  static constexpr auto fields() {
    using P = RefineParams;
    return std::tuple(
        field(&P::passes, "passes", "", between(1, 6), "how often the spacing shrinks, by the same factor"),
        field(&P::spacing_m, "spacing_m", "m", between(1e-3, 1e6),
              "least distance between nodes at the end; absent: each pass halves it"),
        field(&P::contours, "contours", "", between(0, 200),
              "heights whose contours the first pass holds, besides the given outlines; each further pass doubles "
              "them; 0: as many as lie five spacings apart. Many keep the coarse layout, few leave room for detail"),
        field(&P::roughness, "roughness", "", between(0, 2),
              "detail that contours of coarse triangles are given; 0: they are only smoothed"),
        field(&P::probability, "probability",
              "where growth runs ahead and cuts valleys between the contours; the input 'probability' replaces it"),
        field(&P::feature_m, "feature_m", "m", between(1e-3, 1e7),
              "size of the noise's largest forms, one a pass, the last for all further ones; none: twelve times the "
              "spacing that the pass refines"),
        field(&P::exponent, "exponent", "", between(0.05, 20),
              "power to which probabilities are raised, one a pass as well: higher values carve narrower valleys"),
        field(&P::octaves, "octaves", "", between(1, 16), "layers of detail of the noise, each of half the size"),
        field(&P::rivers, "rivers", "the rivers that the network was grown with, laid into each pass again"),
        field(&P::shore_slope_deg, "shore_slope_deg", "deg", between(0.1, 60),
              "how steeply the sea floor falls away from the coast, ever less below 1200 m"));
  }
};

/// What passes read besides the network: contour.grow's `probability` and `rivers`.
struct RefineInputs {
  const ScalarField* probability = nullptr;
  std::vector<RiverLine> rivers;
};

/// The network at its final spacing, with ranks, heights and the held contours as regions, in the coarse one's frame. A
/// network without regions is bounded by its frame. Throws InvalidArgument for params out of range, a network without
/// triangles or heights or of one height, a spacing that is not finer, what contour.grow throws for too many nodes.
/// REQUIRES: geom::find_tin_defect() finds nothing. About 6 us and 300 bytes per node of the result.
Tin refine(const Tin& coarse, const RefineInputs& inputs, const RefineParams& params, Seed seed, const RunContext& run);

/// The same from contours, which the first pass holds in place of ones of its own; they count as about as coarse as
/// half their mean distance. Throws InvalidArgument for a set without contours as well.
Tin refine(const ContourSet& coarse, const RefineInputs& inputs, const RefineParams& params, Seed seed,
           const RunContext& run);

/// Of the one that is given. Throws IncompatibleInputs for none or both.
Tin refine(const Tin* tin, const ContourSet* contours, const RefineInputs& inputs, const RefineParams& params,
           Seed seed, const RunContext& run);

}  // namespace seamount::contour
