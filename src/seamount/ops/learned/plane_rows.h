// Rows of a map's planes as a network reads them: the map continued by its edge cells to the right and below.
#pragma once

#include <vector>

#include "seamount/model/grid.h"
#include "seamount/ops/learned/planes.h"

namespace seamount::learned {

class PlaneRows {
 public:
  /// Fills rows [begin, end) of a map that is continued to `width`; begin >= 0.
  void fetch(const Planes& planes, int width, int begin, int end);

  /// Planes of all cells of a row that was fetched.
  const float* row(int y) const;

 private:
  std::vector<float, detail::UninitialisedAllocator<float>> values_;
  int first_ = 0, last_ = 0;
  size_t stride_ = 0;
};

}  // namespace seamount::learned
