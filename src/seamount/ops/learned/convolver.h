// One convolution of a network as oneDNN evaluates it: a band of rows at a time, on the calling thread alone.
#pragma once

#include <memory>

#include "seamount/model/weights.h"
#include "seamount/ops/learned/architecture.h"
#include "seamount/ops/learned/bf16.h"

namespace seamount::learned {

/// What is done to the sums of a convolution.
enum class After {
  nothing,
  relu,
  add_relu,  ///< what the result's memory held before is added first
};

/// Does this processor multiply bf16?
bool has_bf16();

class Convolver {
 public:
  /// `bf16`: weights and inputs are; results are unless `f32_out`. Weights as architecture.h says.
  Convolver(const Convolution& shape, const Tensor& weight, const Tensor& bias, After after, bool bf16,
            bool f32_out = false);
  Convolver(Convolver&&) noexcept;
  Convolver& operator=(Convolver&&) noexcept;
  ~Convolver();

  const Convolution& shape() const;

  /// Writes `rows` rows of the result from rows of `width` cells, channels last. A 3x3 convolution reads
  /// stride (rows - 1) + 3 rows from `in` on, with a cell of zeros left and right; a 1x1 convolution reads `rows`.
  /// Serial; any number of threads may call it at once. REQUIRES: the types of the constructor; an even width where the
  /// stride is 2.
  void run(const void* in, int width, int rows, void* out) const;

 private:
  struct Prepared;
  std::unique_ptr<Prepared> prepared_;
};

}  // namespace seamount::learned
