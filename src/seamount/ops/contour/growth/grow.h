// contour.grow: from regions to a network whose nodes know in which order they rise.
//
// Source: P2 sec. 4.2, 4.3 (Poisson discs over the region widened by 4 r, Delaunay triangulation), 4.5 (several
// regions). Growth itself is in growth.h, the tree of regions in regions.h. Departures: the least distance of nodes,
// 2 r, is the parameter; sampling is maximal, so that a count of particles is met within a few per cent by
// spacing = 0.835 sqrt(area / count) where the authors' looser discs have 0.763; ground at the domain's edge goes on
// beyond it for two spacings, so that it has no coast there.
#pragma once

#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/drawn.h"
#include "seamount/model/grid.h"
#include "seamount/model/tin.h"
#include "seamount/ops/contour/growth/regions.h"

namespace seamount::contour {

enum class ProbabilityKind { uniform, noise };

}  // namespace seamount::contour

template <>
struct seamount::Choices<seamount::contour::ProbabilityKind> {
  static constexpr std::array<std::string_view, 2> names = {"uniform", "noise"};
};

namespace seamount::contour {

struct GrowParams {
  std::vector<RegionOutline> outlines;
  FilePath regions;
  std::string feature;
  std::vector<RiverLine> rivers;
  bool darkest_is_land = false;
  double irregularity = 0.0;
  std::optional<double> spacing_m;
  int particles = 50000;
  ProbabilityKind probability = ProbabilityKind::noise;
  FilePath probability_picture;
  std::optional<double> feature_m;
  int octaves = 5;
  double exponent = 2.0;

  static constexpr auto fields() {
    using P = GrowParams;
    return std::tuple(
        field(
            &P::outlines, "outlines", "m", between(-12000, 9000),
            "nested regions, each with a name, a ring, the height of its outline if wanted, and whether it is a basin"),
        field(&P::regions, "regions",
              "the regions instead as a GeoJSON, GeoPackage or Shapefile, or as a picture whose grey levels are nested "
              "regions"),
        field(&P::feature, "feature", "only the areas of this name in the file `regions`"),
        field(&P::rivers, "rivers",
              "rivers from source to mouth, each with its bed at all points, at source and mouth, at the mouth, or "
              "none, and the width of its valley floor"),
        field(&P::darkest_is_land, "darkest_is_land",
              "the darkest grey of a picture is the lowest region instead of the world outside"),
        field(&P::irregularity, "irregularity", "", between(0, 1),
              "detail given to outlines drawn with few points: round corners, bays and headlands smaller than their "
              "sides; 0 keeps every point"),
        field(&P::spacing_m, "spacing_m", "m", between(1e-3, 1e6),
              "least distance between nodes; absent: what gives `particles`"),
        field(&P::particles, "particles", "", between(1, 16e6),
              "number of nodes in the regions, within a few per cent"),
        field(&P::probability, "probability",
              "where growth runs ahead and cuts valleys: uniform: nowhere, rings that follow the outline; noise: along "
              "fractal noise; the input 'probability' replaces it"),
        field(&P::probability_picture, "probability_picture",
              "the probability as a picture laid over the domain, black 0 to white 1"),
        field(&P::feature_m, "feature_m", "m", between(1e-3, 1e7),
              "size of the noise's largest forms; absent: a third of the regions' size"),
        field(&P::octaves, "octaves", "", between(1, 16), "layers of detail of the noise, each of half the size"),
        field(&P::exponent, "exponent", "", between(0.05, 20),
              "power to which probabilities are raised: higher values carve narrower, deeper valleys"));
  }
};

/// The network of the regions in the part of the domain that they cover, with a rim of two spacings around it and
/// beyond the domain's edge; rank per node, no heights. `probability`: in [0, 1] wherever nodes lie, read bilinearly,
/// over any frame (clamped at its edge); null: params.probability. `rivers`: laid into the network (rivers.h), besides
/// params.rivers. Throws InvalidArgument for params out of range, more than kMostNodes nodes (with the estimate of
/// memory and the spacing that would do), a region into which no node falls (with the spacing that would do), what
/// prepare_rivers throws, IncompatibleInputs for probabilities that are not numbers in [0, 1].
/// Growth of one region is serial, the rest parallel; about 1.5 us and 200 bytes per node.
Tin grow(RegionTree tree, const GridFrame& domain, const ScalarField* probability, std::vector<RiverLine> rivers,
         GrowParams params, Seed seed, const RunContext& run);

// Its two halves, for networks whose regions are not a person's own (refine.h). Params are not checked.

/// Nodes, triangles, beds and the region of each node; regions may be without nodes.
Tin scatter_nodes(const RegionTree& tree, const GridFrame& domain, std::vector<RiverLine> rivers,
                  const GrowParams& params, Seed seed, const RunContext& run);
/// Ranks for them.
void grow_nodes(Tin& tin, const ScalarField* probability, const GrowParams& params, Seed seed, const RunContext& run);

/// Throws InvalidArgument{"spacing_m"} for more than kMostNodes nodes.
void check_spacing(const RegionTree& tree, const GridFrame& domain, double spacing_m);

/// Spacing that gives params.particles or is given. Metres. REQUIRES: a region in the domain.
double node_spacing(const RegionTree& tree, const GridFrame& domain, const GrowParams& params);

/// An outline of its own making, for when nobody drew one: a coast about the domain's middle.
RegionTree random_region(const GridFrame& domain, Seed seed);

}  // namespace seamount::contour
