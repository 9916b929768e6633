// A network made ready for one precision: its convolutions, and the last one as it is computed by hand.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "seamount/ops/learned/architecture.h"
#include "seamount/ops/learned/convolver.h"

namespace seamount::learned {

struct Layers {
  Architecture architecture;
  bool bf16 = false;
  std::map<std::string, Convolver> convolvers;  ///< by name; all but `outer`. `inner` is of pairs of cells
  std::vector<float> outer_weight;              ///< [row][column][plane]
  float outer_bias = 0.0F;

  const Convolver& operator[](const std::string& name) const { return convolvers.at(name); }
  const Convolver& operator()(const char* name, int level) const { return convolvers.at(name + std::to_string(level)); }
  bool has_deep(int level) const { return architecture.widths[level] >= kDeepWidth; }
};

/// Throws InvalidArgument where architecture_of() does.
Layers make_layers(const Weights& weights, bool bf16);

}  // namespace seamount::learned
