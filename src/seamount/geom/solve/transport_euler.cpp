#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/solve/transport.h"
#include "seamount/geom/solve/transport_check.h"
#include "seamount/geom/solve/transport_stencil.h"
#include "seamount/model/same_size.h"

namespace seamount::geom {
namespace {

/// Concentrations with a ring of cells around them, and the rates of one problem.
class EulerGrid {
 public:
  explicit EulerGrid(const Transport& transport)
      : transport_(transport),
        stencils_(transport, 1.0),
        width_(transport.source->width()),
        height_(transport.source->height()),
        now_(static_cast<size_t>(width_ + 2) * static_cast<size_t>(height_ + 2), 0.0),
        next_(now_) {
    for (int y = -1; y <= height_; ++y) {
      for (int x = -1; x <= width_; ++x) {
        const bool ring = x < 0 || y < 0 || x == width_ || y == height_;
        if (ring && transport.around != nullptr)
          now_[at(x, y)] = next_[at(x, y)] = static_cast<double>(transport.around->clamped(x, y));
      }
    }
  }

  double loss(const transport::Stencil<double>& s) const {
    return transport_.decay_per_s + s.west_out + s.east_out + s.north_out + s.south_out;
  }

  double largest_rate() const {
    double largest = 0.0;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) largest = std::max(largest, loss(stencils_.at(x, y)));
    return largest;
  }

  /// One step of `dt` seconds (0: none is needed), and the largest change and concentration.
  void step(double dt, const RunContext& run, double& change, double& largest) {
    std::vector<double> changes(static_cast<size_t>(height_), 0.0), values(changes);
    parallel_rows(run, width_, height_, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < width_; ++x) {
          const double before = now_[at(x, y)];
          const double after = std::max(0.0, before + dt * rate(x, y));
          next_[at(x, y)] = after;
          const auto row = static_cast<size_t>(y);
          changes[row] = std::max(changes[row], std::abs(after - before));
          values[row] = std::max(values[row], after);
        }
      }
    });
    now_.swap(next_);
    change = *std::max_element(changes.begin(), changes.end());
    largest = *std::max_element(values.begin(), values.end());
  }

  ScalarField state() const {
    ScalarField out(transport_.source->frame());
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) out(x, y) = static_cast<float>(now_[at(x, y)]);
    return out;
  }

 private:
  size_t at(int x, int y) const {
    return static_cast<size_t>(y + 1) * static_cast<size_t>(width_ + 2) + static_cast<size_t>(x + 1);
  }

  double rate(int x, int y) const {
    const transport::Stencil<double> s = stencils_.at(x, y);
    const size_t i = at(x, y), row = static_cast<size_t>(width_ + 2);
    return s.west_in * now_[i - 1] + s.east_in * now_[i + 1] + s.north_in * now_[i - row] + s.south_in * now_[i + row] -
           loss(s) * now_[i] + static_cast<double>((*transport_.source)(x, y));
  }

  const Transport& transport_;
  transport::Stencils<double> stencils_;
  int width_, height_;
  std::vector<double> now_, next_;
};

}  // namespace

ScalarField euler_state(const Transport& transport, const RunContext& run, const EulerOptions& options) {
  transport::check_transport(transport);
  if (transport.source->empty()) return *transport.source;
  EulerGrid grid(transport);
  const double largest_rate = grid.largest_rate();
  const double dt = largest_rate > 0.0 ? 0.9 / largest_rate : 1.0;
  RunContext quiet = run;
  quiet.progress = nullptr;
  double change = 0.0, largest = 0.0;
  int64_t steps = 0;
  do {
    grid.step(dt, quiet, change, largest);
    ++steps;
  } while (change > options.tolerance * largest && steps < options.max_steps);
  if (change > options.tolerance * largest)
    run.say("materials: not steady after " + std::to_string(steps) + " steps: the last one changed " +
            format_number(100.0 * change / largest) + " % of the largest concentration");
  return grid.state();
}

MaterialBalance material_balance(const ScalarField& concentration, const Transport& transport) {
  transport::check_transport(transport);
  check_same_size("concentration", concentration.frame(), transport.source->frame(), "source");
  const transport::Stencils<double> stencils(transport, 1.0);
  MaterialBalance balance;
  const int width = concentration.width(), height = concentration.height();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const transport::Stencil<double> s = stencils.at(x, y);
      const auto own = static_cast<double>(concentration(x, y));
      const auto source = static_cast<double>((*transport.source)(x, y));
      double arrives = 0.0, out = 0.0;
      const auto face = [&](int nx, int ny, double rate_in, double rate_out) {
        const bool inside = concentration.contains(nx, ny);
        const ScalarField* beyond = inside ? &concentration : transport.around;
        const double theirs = beyond != nullptr ? static_cast<double>(beyond->clamped(nx, ny)) : 0.0;
        arrives += rate_in * theirs;
        out += rate_out * own;
        if (inside) return;
        balance.left += rate_out * own;
        balance.entered += rate_in * theirs;
      };
      face(x - 1, y, s.west_in, s.west_out);
      face(x + 1, y, s.east_in, s.east_out);
      face(x, y - 1, s.north_in, s.north_out);
      face(x, y + 1, s.south_in, s.south_out);
      balance.decayed += transport.decay_per_s * own;
      balance.deposited += std::max(0.0, source);
      if (source < 0.0) balance.taken += own > 0.0 ? -source : std::min(-source, arrives);
    }
  }
  return balance;
}

}  // namespace seamount::geom
