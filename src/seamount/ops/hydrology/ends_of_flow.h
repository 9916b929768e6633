// Where flow ends besides the terrain's edge: in the sea, and in sinks that the caller names.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "seamount/base/run_context.h"
#include "seamount/geom/water/inland.h"
#include "seamount/model/grid.h"
#include "seamount/model/same_size.h"

namespace seamount::hydrology {

/// Ground on which cells at or below `sea` end flow.
struct EndsOfFlow {
  HeightField ground;
  float sea = 0.0F;
};

inline bool is_sink(const ScalarField& sinks, int64_t cell) { return sinks.data()[cell] > 0.0F; }

/// Hollows do not end flow (geom/water/inland.h); cells where `sinks` (may be null) is above 0 do, which are lowered
/// with the sea. Throws IncompatibleInputs for sinks of another size.
inline EndsOfFlow ends_of_flow(const HeightField& terrain, const ScalarField* sinks, bool sea,
                               const std::optional<double>& min_sea_m2, const RunContext& run) {
  EndsOfFlow ends{{}, sea ? 0.0F : geom::kNoSea};
  if (sinks == nullptr) {
    ends.ground = geom::raise_inland(terrain, ends.sea, min_sea_m2, run);
    return ends;
  }
  check_same_size("sinks", sinks->frame(), terrain.frame());
  ends.ground = geom::lower_sea(terrain, ends.sea, min_sea_m2, run);
  for (int64_t i = 0; i < terrain.frame().cells(); ++i)
    if (is_sink(*sinks, i) && ends.ground.data()[i] != geom::kUnknownGround) ends.ground.data()[i] = ends.sea;
  return ends;
}

/// Gives cells that were lowered with the sea their heights back.
inline void restore_lowered(HeightField& filled, const HeightField& terrain, const ScalarField* sinks, float sea) {
  if (sinks == nullptr) return;
  for (size_t i = 0; i < filled.size(); ++i)
    if (filled.data()[i] == sea) filled.data()[i] = terrain.data()[i];
}

}  // namespace seamount::hydrology
