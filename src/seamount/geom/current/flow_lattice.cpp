#include "seamount/geom/current/flow_lattice.h"

#include <cmath>
#include <cstdint>

#include "seamount/base/parallel.h"

namespace seamount::geom {
namespace {

int last_node(int cells, int level) {
  return static_cast<int>((static_cast<int64_t>(cells) - 1 + (int64_t{1} << level) - 1) >> level);
}

constexpr float kInner = 150.0F / 256.0F, kMiddle = -25.0F / 256.0F, kOuter = 3.0F / 256.0F;

/// The coarse node at or before a fine one.
int half_below(int node) { return node >= 0 ? node / 2 : -((1 - node) / 2); }

/// One row of coarse values to fine ones.
void widen(const float* coarse, int first, int last, float* fine) {
  for (int node = first; node <= last; ++node) {
    const float* c = coarse + half_below(node);
    fine[node - first] =
        node % 2 == 0 ? c[0] : kInner * (c[0] + c[1]) + kMiddle * (c[-1] + c[2]) + kOuter * (c[-2] + c[3]);
  }
}

void add_plane(const FlowLattice& coarse, const std::vector<float>& from, FlowLattice& fine, std::vector<float>& to,
               const RunContext& run) {
  constexpr int kLines = 8, kBias = 1024;
  const int first = -FlowLattice::kMargin, last = fine.last_column + FlowLattice::kMargin;
  const auto width = static_cast<size_t>(fine.columns());
  parallel_rows(run, fine.columns(), fine.rows(), [&](int begin, int end) {
    std::vector<float> lines(kLines * width);
    std::vector<int> held(kLines, 0);  // the coarse row of each line, plus kBias; 0: none
    const auto line = [&](int row) -> const float* {
      const auto slot = static_cast<size_t>((row + kBias) % kLines);
      float* out = &lines[slot * width];
      if (held[slot] != row + kBias) widen(&from[coarse.at(0, row)], first, last, out);
      held[slot] = row + kBias;
      return out;
    };
    for (int y = begin; y < end; ++y) {
      const int row = y - FlowLattice::kMargin, c = half_below(row);
      float* out = &to[fine.at(first, row)];
      if (row % 2 == 0) {
        const float* a = line(c);
        for (size_t i = 0; i < width; ++i) out[i] += a[i];
        continue;
      }
      const float *p = line(c - 2), *q = line(c - 1), *a = line(c), *b = line(c + 1), *r = line(c + 2),
                  *s = line(c + 3);
      for (size_t i = 0; i < width; ++i)
        out[i] += kInner * (a[i] + b[i]) + kMiddle * (q[i] + r[i]) + kOuter * (p[i] + s[i]);
    }
  });
}

}  // namespace

FlowLattice::FlowLattice(const GridFrame& frame, int level_)
    : level(level_),
      last_column(last_node(frame.width, level_)),
      last_row(last_node(frame.height, level_)),
      step_m(std::ldexp(frame.cell_m, level_)),
      u(static_cast<size_t>(columns()) * static_cast<size_t>(rows()), 0.0F),
      v(u) {}

void add_coarser(const FlowLattice& coarse, FlowLattice& fine, const RunContext& run) {
  add_plane(coarse, coarse.u, fine, fine.u, run);
  add_plane(coarse, coarse.v, fine, fine.v, run);
}

void quintic_weights(double t, float weights[6]) {
  for (int i = 0; i < 6; ++i) {
    double w = 1.0;
    for (int j = 0; j < 6; ++j)
      if (j != i) w *= (t - (j - 2)) / (i - j);
    weights[i] = static_cast<float>(w);
  }
}

void add_picture(const NodePicture& picture, FlowLattice& lattice, const RunContext& run) {
  const int columns = lattice.columns();
  std::vector<int> first(static_cast<size_t>(columns));
  std::vector<float> across(static_cast<size_t>(columns) * 6);
  const auto place = [&](int node, double origin, float weights[6]) {
    const double at = ((node - FlowLattice::kMargin) * lattice.step_m - origin) / picture.step_m;
    const double low = std::floor(at);
    quintic_weights(at - low, weights);
    return static_cast<int>(low) - 2;
  };
  for (int x = 0; x < columns; ++x)
    first[static_cast<size_t>(x)] = place(x, picture.x_m, &across[static_cast<size_t>(x) * 6]);
  const int begin_column = first.front(), count = first.back() + 6 - begin_column;
  parallel_rows(run, columns, lattice.rows(), [&](int begin, int end) {
    std::vector<float> line(static_cast<size_t>(count));
    for (int y = begin; y < end; ++y) {
      float down[6];
      const int top = place(y, picture.y_m, down);
      const size_t to = lattice.at(-FlowLattice::kMargin, y - FlowLattice::kMargin);
      for (const bool east : {true, false}) {
        const float* from =
            (east ? picture.u : picture.v) + static_cast<std::ptrdiff_t>(top) * picture.stride + begin_column;
        for (int i = 0; i < count; ++i) {
          float sum = 0.0F;
          for (int j = 0; j < 6; ++j) sum += down[j] * from[j * picture.stride + i];
          line[static_cast<size_t>(i)] = sum;
        }
        float* out = &(east ? lattice.u : lattice.v)[to];
        for (int x = 0; x < columns; ++x) {
          const float* l = &line[static_cast<size_t>(first[static_cast<size_t>(x)] - begin_column)];
          const float* w = &across[static_cast<size_t>(x) * 6];
          out[x] += ((w[0] * l[0] + w[1] * l[1]) + (w[2] * l[2] + w[3] * l[3])) + (w[4] * l[4] + w[5] * l[5]);
        }
      }
    }
  });
}

}  // namespace seamount::geom
