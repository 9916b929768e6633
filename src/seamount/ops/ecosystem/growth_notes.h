// What is said of classes that did not become what was asked of them.
#pragma once

#include <span>

#include "seamount/ops/ecosystem/births.h"

namespace seamount::ecosystem {

/// What happened to a class while a scene grew.
struct History {
  int born = 0;
  int died = 0;
  int unfitted = 0;         ///< places where no skeleton could grow
  bool wrong_cell = false;  ///< the frame's cells are too fine or too coarse for it
  Prospects prospects;
};

/// One line for each class that was never born, whose target (-1: none) was missed, or whose fitness had no value
/// somewhere; with the largest fitness found and where.
void say_what_became(const Scene& scene, std::span<const History> histories, std::span<const int> wanted, int window,
                     const RunContext& run);

}  // namespace seamount::ecosystem
