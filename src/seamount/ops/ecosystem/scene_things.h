// What the objects of a scene look like in three dimensions (P3 sec. 1.4.3, fig. 1.18 and 1.21).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/model/things.h"
#include "seamount/ops/ecosystem/environment.h"

namespace seamount::ecosystem {

struct ThingsParams {
  int window = 0;
  int max_triangles = 0;
  bool keep_ground = true;

  static constexpr auto fields() {
    return std::tuple(field(&ThingsParams::window, "window", "", at_least(0),
                            "0: all of the scene, with what grew in its windows; else what lies within that window"),
                      field(&ThingsParams::max_triangles, "max_triangles", "", between(0, 1e9),
                            "of all together: things get coarser, then fewer; 0: no limit"),
                      field(&ThingsParams::keep_ground, "keep_ground", "what they stand on goes with them into files"));
  }
};

/// Meshes of the users' files, by the name that the catalogue gives them.
using MeshFiles = std::map<std::string, std::shared_ptr<const ThingMesh>>;

/// One thing for each point, and things at their class's spacing along curves and within regions; of several kinds that
/// a class names, one by lot. An object whose fitness is near the threshold of death looks ailing. They stand on
/// `surface`. The same object gives the same thing. Throws InvalidArgument for a window that is not there or a mesh
/// file that is missing; as place_things(). Parallel; about 1 us a thing.
Things things(const Scene& scene, const HeightField& surface, const MeshFiles& meshes, const ThingsParams& params,
              const RunContext& run);

}  // namespace seamount::ecosystem
