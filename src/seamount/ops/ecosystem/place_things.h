// Places things on a terrain: what stands where and how large it should be comes from the caller (a scene of
// environmental objects, a scatter); here it gets a model, a heading, a foot on the ground and a level of detail.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/thing_params.h"
#include "seamount/model/things.h"

namespace seamount::ecosystem {

/// What a class of objects looks like.
struct ThingSpec {
  std::string name;  ///< "palm": of its shapes, fit for a file name
  ThingParams params;
  std::shared_ptr<const ThingMesh> mesh = nullptr;  ///< for ThingForm::file: what params.file holds (io/thing_file.h)
};

/// Where one is to stand.
struct ThingPlace {
  Vec2 place;                         ///< metres in the terrain's system
  uint32_t spec = 0;                  ///< which of the specs
  double size = 1.0;                  ///< factor on the spec's height and width, > 0
  std::optional<double> heading_deg;  ///< clockwise from north, where its shape's y is turned to; absent: by the key
  double health = 1.0;                ///< [0, 1]
  uint64_t key = 0;                   ///< what makes it differ from others: the same key, the same thing
};

struct PlaceThingsOptions {
  /// Triangles of all things together, at most; 0: no limit. Things get coarser levels, the smallest first, until it
  /// holds; then they are thinned out, which is said.
  uint64_t max_triangles = 0;
  bool keep_ground = true;  ///< Things::ground is the terrain
};

/// All that lies on known cells of the terrain, in the order of the placements. A thing stands on the bilinear ground,
/// sunk so far that its foot does not float; it leans with the ground as its spec says. Models are shared: `variants`
/// of each spec in five steps of health, made when first needed. Result depends on the placements' own keys and the
/// seed alone: another placement left out changes none of the others, unless the triangles are limited. Says how many
/// were left out (outside, unknown ground, limit). Throws InvalidArgument{"specs[2].mesh"} for a file without a mesh,
/// {"placements"} for a spec that is none, a size that is not positive or numbers that are not finite. About 0.2 us a
/// placement and 1 ms a shape, parallel.
Things place_things(const HeightField& terrain, const std::vector<ThingSpec>& specs,
                    const std::vector<ThingPlace>& placements, const PlaceThingsOptions& options, Seed seed,
                    const RunContext& run);

}  // namespace seamount::ecosystem
