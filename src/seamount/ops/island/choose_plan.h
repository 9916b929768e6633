// What an island is built on: the one thing that was given, or a random coast.
#pragma once

#include <functional>
#include <variant>

#include "seamount/model/areas.h"
#include "seamount/ops/island/build.h"

namespace seamount::island {

/// A painted label map laid over the domain.
struct PaintedCoast {
  LabelMap labels;
  ScalarField subsidence = {};  ///< what the brightness says, in [0, 1]; empty: nothing has sunk
};

/// What a coast file holds.
using CoastFile = std::variant<Drawing, PaintedCoast>;

/// What an island can be built on besides what stands in its parameters.
struct BuildInputs {
  const Drawing* outlines = nullptr;                          ///< named areas, or one coast
  const LabelMap* labels = nullptr;                           ///< traced
  const Drawing* summits = nullptr;                           ///< points, values their heights, besides those of params
  std::function<CoastFile(const FilePath&)> read_coast = {};  ///< for `coast`
  bool fit_domain = false;  ///< a domain that does not hold the areas is laid around them
};

/// The plan of the one thing that is given: coast, outlines or areas of the params, the input outlines, the input
/// labels; a random coast where nothing is. Throws InvalidArgument for more than one, and what plans throw (shape.h).
Plan choose_plan(const BuildParams& params, const BuildInputs& inputs, const GridFrame& domain, Seed seed,
                 const RunContext& run);

/// The island of that plan, on the labels' frame if they are given, else on the domain; areas in a coordinate system of
/// their own lend it to the frame. Where a painting says by its brightness that a place has sunk, heights sink by that
/// share of their height over the sea floor (P0 eq. 1.8, sec. 1.5), and labels stay those before. Says what was ignored
/// or fitted. Throws what choose_plan and build throw.
Island build(const BuildInputs& inputs, const BuildParams& params, const GridFrame& domain, Seed seed,
             const RunContext& run);

}  // namespace seamount::island
