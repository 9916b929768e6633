// Dictionaries for tests.
#pragma once

#include <cmath>

#include "seamount/base/rng.h"
#include "seamount/ops/amplify/dictionary.h"

namespace seamount::amplify {

/// Atoms of any shape and detail.
inline Dictionary random_dictionary(int atoms, uint64_t seed) {
  Rng rng(Seed{seed}.derive("atoms"));
  Dictionary dictionary;
  for (int i = 0; i < atoms; ++i) {
    Features shape;
    float squares = 0.0F;
    for (float& f : shape) {
      f = static_cast<float>(rng.normal());
      squares += f * f;
    }
    for (float& f : shape) f /= std::sqrt(squares);
    Detail detail;
    for (float& z : detail) z = static_cast<float>(0.1 * rng.normal());
    dictionary.shapes.push_back(shape);
    dictionary.details.push_back(detail);
  }
  return dictionary;
}

}  // namespace seamount::amplify
