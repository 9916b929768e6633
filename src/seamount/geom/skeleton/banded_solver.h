// Symmetric positive definite systems whose entries lie near the diagonal: the linear part of a snake's step.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace seamount::geom {

/// L D L^t of a matrix with at most kWidth entries to the left of its diagonal. Linear in its size.
class BandedSolver {
 public:
  static constexpr size_t kWidth = 4;

  explicit BandedSolver(size_t size) : rows_(size, Row{}) {}

  size_t size() const { return rows_.size(); }

  /// Adds to the entries (i, j) and (j, i), once where i = j. REQUIRES: |i - j| <= kWidth, not factored yet.
  void add(size_t i, size_t j, double value) { rows_[i > j ? i : j][i > j ? i - j : j - i] += value; }

  /// REQUIRES: positive definite.
  void factor() {
    for (size_t i = 0; i < rows_.size(); ++i) {
      for (size_t back = std::min(i, kWidth); back > 0; --back) {
        const size_t j = i - back;
        double sum = rows_[i][back];
        for (size_t k = back + 1; k <= std::min(i, kWidth); ++k) {
          if (k - back <= kWidth) sum -= rows_[i][k] * rows_[j][k - back] * rows_[i - k][0];
        }
        rows_[i][back] = sum / rows_[j][0];
      }
      for (size_t k = 1; k <= std::min(i, kWidth); ++k) rows_[i][0] -= rows_[i][k] * rows_[i][k] * rows_[i - k][0];
    }
  }

  /// x becomes the solution for the right-hand side x. `Value` needs -, and double *. REQUIRES: factor().
  template <class Value>
  void solve(std::vector<Value>& x) const {
    for (size_t i = 0; i < rows_.size(); ++i) {
      for (size_t k = 1; k <= std::min(i, kWidth); ++k) x[i] = x[i] - rows_[i][k] * x[i - k];
    }
    for (size_t i = 0; i < rows_.size(); ++i) x[i] = (1.0 / rows_[i][0]) * x[i];
    for (size_t i = rows_.size(); i-- > 0;) {
      for (size_t k = 1; k <= std::min(i, kWidth); ++k) x[i - k] = x[i - k] - rows_[i][k] * x[i];
    }
  }

 private:
  using Row = std::array<double, kWidth + 1>;  ///< entry (i, i - k) at k
  std::vector<Row> rows_;
};

}  // namespace seamount::geom
