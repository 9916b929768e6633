// hydrology.fill: a terrain on which water runs everywhere to the edge or to the sea.
//
// Filling raises depressions to their lowest pass, as priority-flood does (Barnes, Lehman and Mulla 2014;
// geom/water/flow.h). Breaching cuts the cheapest way out instead (least-cost breaching, Lindsay and Dhun 2015): from
// each pit the way to lower ground along which the least ground is removed; what would need a cut longer or deeper than
// allowed is filled. The lakes are what filling covered.
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/areas.h"
#include "seamount/model/grid.h"

namespace seamount::hydrology {

enum class Depressions { fill, breach };

struct FillParams {
  Depressions depressions = Depressions::fill;
  bool descend = true;
  bool sea = true;
  std::optional<double> min_sea_m2;
  double max_cut_m = 50.0;
  double max_length_m = 5000.0;
  double min_lake_m2 = 20000.0;

  static constexpr auto fields() {
    using P = FillParams;
    return std::tuple(
        field(&P::depressions, "depressions", "fill: raise them to their outlets; breach: cut the cheapest way out"),
        field(&P::descend, "descend",
              "let filled ground fall towards its outlet by the least step that a float can make"),
        field(&P::sea, "sea", "flow ends in cells at or below sea level; otherwise only at the terrain's edge"),
        field(&P::min_sea_m2, "min_sea_m2", "m2", between(0, 1e15), geom::kLeastSeaMeaning),
        field(&P::max_cut_m, "max_cut_m", "m", between(0, 10000), "breach: deepest cut; what needs more is filled"),
        field(&P::max_length_m, "max_length_m", "m", between(0, 1e6), "breach: longest cut; what needs more is filled"),
        field(&P::min_lake_m2, "min_lake_m2", "m2", between(0, 1e12), "smaller lakes are not traced"));
  }

  static constexpr std::array kFormerNames = {FormerName{"least_sea_m2", "min_sea_m2"}};
};

struct Filled {
  HeightField terrain;
  ScalarField change_m;  ///< terrain - input: positive where filled, negative where cut
  Drawing lakes;  ///< areas "lake 1", ... from the largest on, with level_m, depth_m (greatest), area_m2, volume_m3
};

/// Throws InvalidArgument for params out of range. Parallel as geom::fill_depressions(); breaching is not, and costs
/// about the cells within reach of each pit times their logarithm. 13 bytes per cell besides the results.
Filled fill(const HeightField& terrain, const FillParams& params, const RunContext& run);

}  // namespace seamount::hydrology

template <>
struct seamount::Choices<seamount::hydrology::Depressions> {
  static constexpr std::array<std::string_view, 2> names = {"fill", "breach"};
};
