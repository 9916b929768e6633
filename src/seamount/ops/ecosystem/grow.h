// Environmental objects (P3 sec. 1.4, Algorithm 1): a scene that grows on a terrain, iteration by iteration.
//
// An iteration: edits by hand that are due; the environment of its time; births of each class where it is fit; every
// living object fitted again; the environment of what came of it; whatever is unfit dies, and what its death makes
// unfit, until all that live are fit (chain reactions).
//
// Departs from Algorithm 1 in that several objects of a class may be born in an iteration, and in that the unfit are
// sought once the environment knows the newly born: no object below its threshold survives an iteration.
#pragma once

#include <vector>

#include "seamount/base/rng.h"
#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/scene.h"
#include "seamount/model/vector_field.h"
#include "seamount/ops/ecosystem/grow_params.h"

namespace seamount::ecosystem {

struct GrowInputs {
  const HeightField& ground;             ///< metres over z = 0, no unknown cells
  const Catalogue* catalogue = nullptr;  ///< what may grow; with objects that are given, in place of theirs
  const Scene* before = nullptr;         ///< a scene to go on with
  const Mask* focus = nullptr;           ///< factor of the fitness of what is to be born (lambda of sec. 1.7.1)
  const VectorField* current = nullptr;  ///< m/s, added to all others
};

struct Grown {
  Scene scene;
  HeightField terrain;  ///< metres over z = 0, of the scene's frame or of the window
  VectorField current;  ///< m/s
};

/// Grows a scene, or one window of it: that has iterations of its own, in which edits are counted and objects are born,
/// while the scene around it stands still. Events and edits in the files are the caller's to read. Says what never grew
/// and why, how targets were missed, what was dropped. A scene that is given keeps its seed, its surroundings and its
/// timeline.
///
/// Throws InvalidArgument (a parameter, an edit that names nothing, no catalogue, a window outside of the scene),
/// IncompatibleInputs where rasters or the scene lie elsewhere, Cancelled. About 100 ms an iteration for 10 000
/// objects, 512^2 cells and 6 materials; parallel, the same bytes on any number of threads.
Grown grow(const GrowInputs& inputs, const GrowParams& params, Seed seed, const RunContext& run);

}  // namespace seamount::ecosystem
