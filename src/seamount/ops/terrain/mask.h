// terrain.mask: where something is to happen: soft selections in [0, 1] by what the ground is like and by what is drawn
// on it, combined. Every operator that takes a mask takes one of these; written as an image it is a mask for other
// tools.
//
// A criterion measures one thing at every cell and lets a soft range of it through: 1 from `low` to `high` (either may
// be absent: no limit), falling smoothly to 0 over `falloff` beyond. Slopes, aspects and curvatures are those of the
// terrain at a scale in metres (geom/grid/surface.h), so that a mask depends on the cell size only in detail.
#pragma once

#include <optional>
#include <tuple>
#include <variant>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"
#include "seamount/model/label_map.h"
#include "seamount/model/reach.h"
#include "seamount/ops/terrain/criteria_ground.h"
#include "seamount/ops/terrain/criteria_place.h"

namespace seamount::terrain {

/// In a recipe a criterion is written {"tool": "slope", "low_deg": 30}.
using Criterion =
    std::variant<ByHeight, ByDepth, BySlope, ByAspect, ByCurvature, ByRegion, ByArea, ByLine, ByNoise, ByValue>;

/// How criteria become one mask: all must hold (product is softer than min where several are in doubt), or any (max).
enum class Combine { product, min, max };

struct MaskParams {
  std::vector<Criterion> criteria;
  Combine combine = Combine::product;
  bool invert = false;
  double low = 0.0;
  double high = 1.0;

  static constexpr auto fields() {
    using P = MaskParams;
    return std::tuple(
        field(&P::criteria, "criteria", "what is selected; none: everything"),
        field(&P::combine, "combine", "how criteria are combined: product or min where all must hold, max where any"),
        field(&P::invert, "invert", "select what would not be"),
        field(&P::low, "low", "", between(-1e6, 1e6),
              "value of ground that is not selected; low 1 and high 10 make a hardness for erosion.run"),
        field(&P::high, "high", "", between(-1e6, 1e6), "value of ground that is selected; soft edges lie between"));
  }
};

/// What criteria may look at.
struct MaskInputs {
  const HeightField& terrain;
  const LabelMap* labels = nullptr;     ///< for `region`
  const Drawing* drawing = nullptr;     ///< for `area` and `line`
  const ScalarField* values = nullptr;  ///< for `value`: any field
  const Mask* mask = nullptr;           ///< one more mask, combined like a criterion
};

/// Height in metres that ground below sea level gets that the sea does not reach: it is no depth.
inline constexpr float kDryGround_m = 9000.0F;

/// The criterion of heights over the sea in metres, with kDryGround_m where the sea does not reach, that selects as
/// `by` does.
ByValue over_the_sea(const ByDepth& by);

/// 1 in [low, high], falling by a smoothstep to 0 at `falloff` beyond; a limit that is absent does not limit.
double soft_range(double x, std::optional<double> low, std::optional<double> high, double falloff);

/// The mask, on the terrain's frame: low + selection * (high - low). Throws InvalidArgument for params out of range,
/// low above high, and criteria whose input is missing; IncompatibleInputs for inputs of another size. Parallel; about
/// 10 ns per cell and criterion, more for scales, distances and noise; at most five grids of memory.
Mask mask(const MaskInputs& in, const MaskParams& params, Seed seed, const RunContext& run);

/// As far as the criterion that looks furthest: slope, aspect and curvature at their scale, region as far as its
/// limits, depth at everything, for what is sea; others at their own place. Those that look further look at everything
/// where ground is unknown.
Reach mask_reach(const MaskParams& params, double cell_m);

}  // namespace seamount::terrain

template <>
struct seamount::Choices<seamount::terrain::Combine> {
  static constexpr std::array<std::string_view, 3> names = {"product", "min", "max"};
};
