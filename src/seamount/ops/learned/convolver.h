// One convolution of a network as oneDNN evaluates it: a band of rows at a time, on the calling thread alone.
#pragma once

#include <memory>

#include "seamount/model/weights.h"
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
  /// `weight`: [out, in, rows, columns], 3x3, 1x1 or 3x2. `bf16`: weights and inputs are; results are unless `f32_out`.
  Convolver(const Tensor& weight, const Tensor& bias, int stride, After after, bool bf16, bool f32_out = false);
  Convolver(Convolver&&) noexcept;
  Convolver& operator=(Convolver&&) noexcept;
  ~Convolver();

  int out_channels() const;
  /// Multiplications for a cell of the result.
  double work() const;

  /// Writes `rows` rows of the result from rows of `width` cells, channels last. A convolution of three rows reads
  /// stride (rows - 1) + 3 rows from `in` on, that of one row reads `rows`; three columns have a cell of zeros left and
  /// right, two have none, and give a cell less. Serial; any number of threads may call it at once. REQUIRES: the types
  /// of the constructor; an even width where the stride is 2.
  void run(const void* in, int width, int rows, void* out) const;

 private:
  struct Prepared;
  std::unique_ptr<Prepared> prepared_;
};

}  // namespace seamount::learned
