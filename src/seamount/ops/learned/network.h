// Evaluates a trained network (architecture.h) on the processor, with oneDNN's convolutions.
//
// Threads are those of base/parallel.h: each layer is cut into bands of rows, and each band is one serial call of
// oneDNN, so that the result is the same bytes on any number of threads, work can be cancelled, and no second pool of
// threads competes. Large maps are evaluated in tiles, which are rows as wide as the map: levels up to stride 4 tile by
// tile with as many rows around as they see, deeper ones for the whole map at once, so that tiles do not show.
//
// Time: what the convolutions take, and a tenth more. Memory: of a map of 4096 x 4096 with the default widths 0.6 GB in
// bf16 and 0.75 GB in f32, besides what the planes are made from.
#pragma once

#include <memory>

#include "seamount/base/run_context.h"
#include "seamount/model/grid.h"
#include "seamount/model/weights.h"
#include "seamount/ops/learned/architecture.h"
#include "seamount/ops/learned/planes.h"
#include "seamount/ops/learned/precision.h"

namespace seamount::learned {

class Network {
 public:
  /// Throws InvalidArgument where the weights are of no network (architecture_of()), or where bf16 is asked of a
  /// processor without it.
  explicit Network(const Weights& weights, Precision precision = Precision::automatic);
  Network(Network&&) noexcept;
  Network& operator=(Network&&) noexcept;
  ~Network();

  const Architecture& architecture() const;
  /// f32 or bf16: what automatic came to.
  Precision precision() const;

  /// The network's plane over the whole map, in the frame given. The map is padded with its edge cells to a multiple of
  /// architecture().stride(). Throws IncompatibleInputs unless planes and frame agree. Parallel; the same bytes on any
  /// number of threads; another `tile` (rows, a multiple of the stride; 0: as many as memory of
  /// about 0.75 GB holds) changes it by rounding only. Throws InvalidArgument{tile}.
  ScalarField evaluate(const Planes& planes, const GridFrame& frame, const RunContext& run, int tile = 0) const;

 private:
  struct Prepared;
  std::unique_ptr<Prepared> prepared_;
};

}  // namespace seamount::learned
