// The numbers of a trained network or dictionary: named tensors, and what is said about them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace seamount {

/// Row-major, the last index fastest.
struct Tensor {
  std::vector<int64_t> shape;  ///< each >= 1; empty: one number
  std::vector<float> values;   ///< as many as the shape says

  bool operator==(const Tensor&) const = default;
};

struct Weights {
  std::map<std::string, Tensor> tensors;
  std::map<std::string, std::string> about;  ///< what it is, how it was made

  bool operator==(const Weights&) const = default;
};

}  // namespace seamount
