// A step that can be run window by window.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "seamount/model/reach.h"
#include "seamount/tiles/world.h"

namespace seamount::tiles {

/// What a step that was thought to be local throws when it meets cells without a value, which looks at everything.
struct MeetsUnknown {
  size_t step = 0;
};

struct LocalStep {
  /// A raster input of which it gets a window.
  struct Input {
    const recipe::Port* port = nullptr;
    OutputOf from;
  };

  size_t index = 0;
  recipe::Json params;  ///< the step's; with what they are on the whole, where they hang on it
  Reach reach;
  GridFrame frame;            ///< of what it reads by windows and of all that it makes
  GridFrame domain;           ///< the document's, as the step sees it
  std::vector<Input> inputs;  ///< by windows
  recipe::Values wholes;      ///< all other inputs, where they belong

  /// Runs it on the cells of `rect`. `windows`: one for each of `inputs`. Throws MeetsUnknown, and what operators throw
  /// with the step's name.
  recipe::Values run(const World& world, const Rect& rect, const std::vector<recipe::Value>& windows,
                     const RunContext& run) const;
};

/// How a step would be run by windows, as far as can be said before its inputs are there.
struct Locality {
  std::vector<LocalStep::Input> inputs;
  std::vector<OutputOf> wholes;  ///< inputs from steps that it looks at as wholes
  bool measured = false;         ///< the lowest and the highest cell of its first input count: that must be there
};

/// Nothing if the step looks at everything by its operator or by how it is connected. `frame_of`: where a raster lies
/// that is there or will be.
std::optional<Locality> locality(const World& world, size_t index,
                                 const std::function<const GridFrame&(const OutputOf&)>& frame_of);

/// The step, with its own or other `params`, whose whole and measured inputs are there; nothing if its parameters make
/// it look at everything, or further than the raster is large. Throws MeetsUnknown where what is measured has cells
/// without a value.
std::optional<LocalStep> local_step(const World& world, size_t index, const Locality& found,
                                    const std::function<const GridFrame&(const OutputOf&)>& frame_of,
                                    const RunContext& run, const recipe::Json* params = nullptr);

}  // namespace seamount::tiles
