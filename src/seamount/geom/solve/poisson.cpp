#include "seamount/geom/solve/poisson.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/model/same_size.h"

namespace seamount::geom {
namespace {

using Cells = std::vector<float>;

/// One level of the equation diagonal u - sum of links u(neighbour) = right. Arrays have one line of cells more on
/// every side, all 0, so that no loop asks for the border. Fixed cells have inverse 0 and u = 0: their values are in
/// `right`.
struct Level {
  int width, height;
  int64_t stride;
  Cells u, next, right, east, south, diagonal, inverse;

  Level(int w, int h) : width(w), height(h), stride(w + 2) {
    const size_t size = static_cast<size_t>(stride) * static_cast<size_t>(h + 2);
    for (Cells* cells : {&u, &next, &right, &east, &south, &diagonal, &inverse}) cells->assign(size, 0.0F);
  }
  size_t at(int x, int y) const { return static_cast<size_t>((y + 1) * stride + x + 1); }
};

/// Pointers into one row of a level.
struct Row {
  const float *u, *right, *east, *south, *diagonal, *inverse;
};

Row row_of(const Level& level, int y) {
  const size_t i = level.at(0, y);
  return {&level.u[i], &level.right[i], &level.east[i], &level.south[i], &level.diagonal[i], &level.inverse[i]};
}

/// (A u) of one cell.
SEAMOUNT_INLINE float product_at(const Row& row, int64_t stride, int x) {
  const float links = row.east[x] * row.u[x + 1] + row.east[x - 1] * row.u[x - 1] + row.south[x] * row.u[x + stride] +
                      row.south[x - stride] * row.u[x - stride];
  return row.diagonal[x] * row.u[x] - links;
}

SEAMOUNT_VECTORISED void smooth_row(const Row& given, int64_t stride, float weight, int width, float* next) {
  const Row row = given;
  for (int x = 0; x < width; ++x) {
    next[x] = row.u[x] + weight * row.inverse[x] * (row.right[x] - product_at(row, stride, x));
  }
}

/// The first sweep from u = 0.
SEAMOUNT_VECTORISED void start_row(const float* right, const float* inverse, float weight, int width, float* u) {
  for (int x = 0; x < width; ++x) u[x] = weight * inverse[x] * right[x];
}

/// Residuals of free cells, 0 elsewhere.
SEAMOUNT_VECTORISED void residual_row(const Row& given, int64_t stride, int width, float* out) {
  const Row row = given;
  for (int x = 0; x < width; ++x) {
    out[x] = row.inverse[x] > 0.0F ? row.right[x] - product_at(row, stride, x) : 0.0F;
  }
}

SEAMOUNT_VECTORISED void product_row(const Row& given, int64_t stride, int width, float* out) {
  const Row row = given;
  for (int x = 0; x < width; ++x) out[x] = product_at(row, stride, x);
}

/// Sum of products in 16 lanes, always added in the same order.
SEAMOUNT_VECTORISED double dot_block(const float* a, const float* b, int count) {
  constexpr int kLanes = 16;
  double lanes[kLanes] = {};
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    for (int k = 0; k < kLanes; ++k) lanes[k] += static_cast<double>(a[i + k]) * static_cast<double>(b[i + k]);
  }
  double sum = 0.0;
  for (; i < count; ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
  for (const double lane : lanes) sum += lane;
  return sum;
}

/// Jacobi sweeps whose weights are the Chebyshev points of the upper part of the spectrum, [0.4, 2].
void smooth(Level& level, bool from_zero, const RunContext& run) {
  for (const float weight : {0.5282F, 0.8333F, 1.9716F}) {
    parallel_rows(run, level.width, level.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        const Row row = row_of(level, y);
        float* next = &level.next[level.at(0, y)];
        if (from_zero) {
          start_row(row.right, row.inverse, weight, level.width, next);
        } else {
          smooth_row(row, level.stride, weight, level.width, next);
        }
      }
    });
    std::swap(level.u, level.next);
    from_zero = false;
  }
}

/// Coarse right-hand side by the transpose of add_correction: residuals of 4 x 4 fine cells weighted 1/4 and 3/4.
void restrict_residual(Level& fine, Level& coarse, const RunContext& run) {
  parallel_rows(run, fine.width, fine.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      residual_row(row_of(fine, y), fine.stride, fine.width, &fine.next[fine.at(0, y)]);
    }
  });
  parallel_rows(run, fine.width, coarse.height, [&](int begin, int end) {
    Cells mixed(static_cast<size_t>(2 * coarse.width) + 2, 0.0F);
    for (int y = begin; y < end; ++y) {
      std::fill(mixed.begin(), mixed.end(), 0.0F);
      for (int k = -1; k <= 2; ++k) {
        const int from = 2 * y + k;
        if (from < 0 || from >= fine.height) continue;
        const bool whole = from == 0 || from == 2 * coarse.height - 1;  // there the correction has one source
        const float weight = whole ? 1.0F : (k == 0 || k == 1 ? 0.75F : 0.25F);
        const float* residual = &fine.next[fine.at(0, from)];
        for (int x = 0; x < fine.width; ++x) mixed[static_cast<size_t>(x) + 1] += weight * residual[x];
      }
      // The outermost fine cells have one source too: what the cells beyond the edge would get comes back to them.
      mixed.front() = mixed[1];
      mixed.back() = mixed[mixed.size() - 2];
      float* right = &coarse.right[coarse.at(0, y)];
      for (size_t x = 0; x < static_cast<size_t>(coarse.width); ++x) {
        const float* m = &mixed[2 * x];
        right[x] = 0.75F * (m[1] + m[2]) + 0.25F * (m[0] + m[3]);
      }
    }
  });
}

/// Adds the coarse solution, bilinearly between coarse cells (3/4 and 1/4), to free fine cells.
void add_correction(const Level& coarse, Level& fine, const RunContext& run) {
  parallel_rows(run, fine.width, fine.height, [&](int begin, int end) {
    Cells mixed(static_cast<size_t>(coarse.width) + 2);
    for (int y = begin; y < end; ++y) {
      const int near = y / 2;
      const int far = std::clamp(near + (y % 2 == 0 ? -1 : 1), 0, coarse.height - 1);
      const float* a = &coarse.u[coarse.at(0, near)];
      const float* b = &coarse.u[coarse.at(0, far)];
      for (int x = 0; x < coarse.width; ++x) mixed[static_cast<size_t>(x + 1)] = 0.75F * a[x] + 0.25F * b[x];
      mixed.front() = mixed[1];
      mixed.back() = mixed[mixed.size() - 2];
      float* u = &fine.u[fine.at(0, y)];
      const float* inverse = &fine.inverse[fine.at(0, y)];
      for (int x = 0; x < fine.width; ++x) {
        const size_t centre = static_cast<size_t>(x / 2) + 1;
        const float value = 0.75F * mixed[centre] + 0.25F * (x % 2 == 0 ? mixed[centre - 1] : mixed[centre + 1]);
        if (inverse[x] > 0.0F) u[x] += value;
      }
    }
  });
}

/// Aggregates four cells into one. Links across a coarse edge add up and are halved (twice the distance), which is what
/// discretising anew gives; links to fixed cells keep 0.6, the mean over levels of what a straight border asks for.
Level coarsen(const Level& fine, const RunContext& run) {
  Level coarse((fine.width + 1) / 2, (fine.height + 1) / 2);
  const auto leak = [&fine](size_t i) {
    const float links =
        fine.east[i] + fine.east[i - 1] + fine.south[i] + fine.south[i - static_cast<size_t>(fine.stride)];
    return fine.inverse[i] > 0.0F ? std::max(0.0F, fine.diagonal[i] - links) : 0.0F;
  };
  parallel_rows(run, fine.width, coarse.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < coarse.width; ++x) {
        const size_t i = coarse.at(x, y);
        const bool last_column = 2 * x + 1 >= fine.width;
        const bool last_row = 2 * y + 1 >= fine.height;
        for (int k = 0; k < 4; ++k) {
          if ((k % 2 == 1 && last_column) || (k / 2 == 1 && last_row)) continue;
          const size_t child = fine.at(2 * x + k % 2, 2 * y + k / 2);
          if (k % 2 == 1) coarse.east[i] += 0.5F * fine.east[child];
          if (k / 2 == 1) coarse.south[i] += 0.5F * fine.south[child];
          coarse.diagonal[i] += 0.6F * leak(child);
        }
      }
    }
  });
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      const size_t i = coarse.at(x, y);
      coarse.diagonal[i] +=
          coarse.east[i] + coarse.east[i - 1] + coarse.south[i] + coarse.south[i - static_cast<size_t>(coarse.stride)];
      coarse.inverse[i] = coarse.diagonal[i] > 0.0F ? 1.0F / coarse.diagonal[i] : 0.0F;
    }
  }
  return coarse;
}

Level finest_level(const ScalarField& u, const Grid<uint8_t>& fixed, const ScalarField* rhs, const RunContext& run) {
  Level level(u.width(), u.height());
  const double cell_area = u.cell_m() * u.cell_m();
  parallel_rows(run, u.width(), u.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < u.width(); ++x) {
        if (fixed(x, y) != 0) continue;
        const size_t i = level.at(x, y);
        float diagonal = 0.0F;
        float right = rhs != nullptr ? static_cast<float>(-cell_area * (*rhs)(x, y)) : 0.0F;
        const std::array<std::array<int, 2>, 4> neighbours = {{{x + 1, y}, {x, y + 1}, {x - 1, y}, {x, y - 1}}};
        for (const auto& [nx, ny] : neighbours) {
          if (!u.contains(nx, ny)) continue;
          diagonal += 1.0F;
          if (fixed(nx, ny) != 0) right += u(nx, ny);
        }
        if (u.contains(x + 1, y) && fixed(x + 1, y) == 0) level.east[i] = 1.0F;
        if (u.contains(x, y + 1) && fixed(x, y + 1) == 0) level.south[i] = 1.0F;
        level.diagonal[i] = diagonal;
        level.right[i] = right;
        level.inverse[i] = diagonal > 0.0F ? 1.0F / diagonal : 0.0F;
      }
    }
  });
  return level;
}

/// levels[depth].u becomes about the solution for levels[depth].right: one V-cycle from 0, symmetric as a matrix.
void cycle(std::vector<Level>& levels, size_t depth, const RunContext& run) {
  Level& level = levels[depth];
  smooth(level, true, run);
  if (depth + 1 == levels.size()) {
    for (int i = 0; i < 8; ++i) smooth(level, false, run);
    return;
  }
  restrict_residual(level, levels[depth + 1], run);
  cycle(levels, depth + 1, run);
  add_correction(levels[depth + 1], level, run);
  smooth(level, false, run);
}

/// Conjugate gradients with a V-cycle as preconditioner. levels[0].right holds the residual on the way.
class Solver {
 public:
  Solver(std::vector<Level>& levels, const RunContext& run)
      : levels_(levels), run_(run), x_(levels[0].u.size(), 0.0F), p_(x_), product_(x_) {}

  double largest_residual() const {
    float largest = 0.0F;
    for (const float r : levels_[0].right) largest = std::max(largest, std::abs(r));
    return static_cast<double>(largest);
  }

  /// One step; false where there is nothing left to gain.
  bool step() {
    Level& finest = levels_[0];
    cycle(levels_, 0, run_);
    const double reached = dot(finest.right, finest.u);
    if (!(reached > 0.0)) return false;
    const float keep = before_ > 0.0 ? static_cast<float>(reached / before_) : 0.0F;
    before_ = reached;
    for_rows([&](size_t i, int) {
      for (size_t x = i; x < i + static_cast<size_t>(finest.width); ++x) p_[x] = finest.u[x] + keep * p_[x];
    });
    for_rows([&](size_t i, int y) {
      Row row = row_of(finest, y);
      row.u = &p_[i];
      product_row(row, finest.stride, finest.width, &product_[i]);
    });
    const double curvature = dot(p_, product_);
    if (!(curvature > 0.0)) return false;
    const float length = static_cast<float>(reached / curvature);
    for_rows([&](size_t i, int) {
      for (size_t x = i; x < i + static_cast<size_t>(finest.width); ++x) {
        x_[x] += length * p_[x];
        finest.right[x] -= length * product_[x];
      }
    });
    return true;
  }

  float solution(int x, int y) const { return x_[levels_[0].at(x, y)]; }

 private:
  template <class Body>
  void for_rows(Body&& body) {
    parallel_rows(run_, levels_[0].width, levels_[0].height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) body(levels_[0].at(0, y), y);
    });
  }

  double dot(const Cells& a, const Cells& b) const {
    return parallel_sum<double>(run_, static_cast<int64_t>(a.size()), 1 << 16, [&](int64_t begin, int64_t end) {
      return dot_block(a.data() + begin, b.data() + begin, static_cast<int>(end - begin));
    });
  }

  std::vector<Level>& levels_;
  const RunContext& run_;
  Cells x_, p_, product_;
  double before_ = 0.0;
};

void solve(ScalarField& u, const Grid<uint8_t>& fixed, const ScalarField* rhs, const RunContext& run,
           const PoissonOptions& options) {
  check_same_size("fixed cells", fixed.frame(), u.frame(), "field");
  if (rhs != nullptr) check_same_size("right-hand side", rhs->frame(), u.frame(), "field");
  if (u.empty()) return;
  RunContext quiet = run;
  quiet.progress = nullptr;
  std::vector<Level> levels;
  levels.push_back(finest_level(u, fixed, rhs, quiet));
  while (levels.back().width > 2 || levels.back().height > 2) levels.push_back(coarsen(levels.back(), quiet));
  Solver solver(levels, quiet);
  const double target = options.tolerance * solver.largest_residual();
  for (int i = 0; i < options.max_cycles && solver.largest_residual() > target; ++i) {
    if (!solver.step()) break;
    run.report((i + 1.0) / options.max_cycles);
  }
  for (int y = 0; y < u.height(); ++y) {
    for (int x = 0; x < u.width(); ++x) {
      if (fixed(x, y) == 0) u(x, y) = solver.solution(x, y);
    }
  }
}

}  // namespace

void solve_laplace(ScalarField& u, const Grid<uint8_t>& fixed, const RunContext& run, const PoissonOptions& options) {
  solve(u, fixed, nullptr, run, options);
}

void solve_poisson(ScalarField& u, const Grid<uint8_t>& fixed, const ScalarField& rhs, const RunContext& run,
                   const PoissonOptions& options) {
  solve(u, fixed, &rhs, run, options);
}

}  // namespace seamount::geom
