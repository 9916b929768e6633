// Terrain for game engines and Blender, with the exact numbers to type in there.
//
// Engines put the outer samples ON the terrain's edge, so a terrain of n samples is (n - 1) cells wide; Blender's
// picture is n cells wide. terrain.samples brings a terrain there; write_for_engine() only accepts a grid of a right
// size.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/base/fields.h"
#include "seamount/io/sidecar.h"
#include "seamount/model/grid.h"

namespace seamount::io {

enum class Engine {
  unreal,   ///< .r16, .raw or .png, 16 bit; code 32768 is the actor's height
  unity,    ///< .raw or .r16, 16 bit little endian, southern row first (Unity's order: import without flip)
  godot,    ///< .exr with metres (Terrain3D, HTerrain), or .r16
  blender,  ///< .exr with metres, for a displacement modifier of strength 1 and midlevel 0 on a grid of all cells
};

struct EngineOptions {
  /// Heights of codes 0 and 65535. Default: chosen so that the terrain takes the middle three quarters (there is room
  /// to sculpt beyond) and that the numbers to type in are short.
  std::optional<HeightRange> range;
  Provenance provenance;
};

/// Sizes that an engine accepts, ascending; empty: any.
const std::vector<int>& engine_sizes(Engine engine);

/// Writes the raster and its side-car. Heights come back within half a step of range / 65535 once the numbers are typed
/// in. Throws InvalidArgument{"size"} (listing the allowed ones) for a wrong size, {"range"} for a range that does not
/// hold the terrain, {"path"} for an extension that the engine does not read; IoError.
void write_for_engine(const HeightField& heights, Engine engine, const std::string& path,
                      const EngineOptions& options = {});

/// Throws InvalidArgument{"path"} for an extension that the engine does not read, of heights or of a mask (.png).
void check_engine_path(const std::string& path, Engine engine, bool heights = true);

/// What write_for_engine() says beside samples of such a frame and such heights: the range of codes, the row order and
/// the numbers to type in. Throws as it does, but for sizes.
Sidecar engine_sidecar(const GridFrame& frame, HeightRange extremes, Engine engine, const std::string& path,
                       const EngineOptions& options);

/// The second half of it: the raster as the side-car says, and the side-car. REQUIRES: engine_sidecar() made it for
/// heights that hold these. Throws WriteError.
void write_engine_samples(const HeightField& heights, Engine engine, const Sidecar& sidecar, const std::string& path);

}  // namespace seamount::io

template <>
struct seamount::Choices<seamount::io::Engine> {
  static constexpr std::array<std::string_view, 4> names = {"unreal", "unity", "godot", "blender"};
};
