#include "seamount/geom/current/kelvinlet_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "seamount/base/error.h"
#include "seamount/base/parallel.h"
#include "seamount/base/text.h"
#include "seamount/geom/current/flow_lattice.h"
#include "seamount/geom/current/kelvinlet_far.h"
#include "seamount/geom/current/kelvinlet_rows.h"
#include "seamount/model/same_size.h"

namespace seamount::geom {
namespace kelvinlets {
namespace {

/// Radii of a level are 5 to 10 of its steps (of the finest level also smaller): what its lattice can hold.
constexpr double kFinest = 5.0;
/// Steps across the grid on the coarsest level, whose Kelvinlets have no far field.
constexpr double kFewest = 12.0;

Source source_of(const Kelvinlet& k, const GridFrame& frame) {
  Source source;
  source.x = k.centre.x - frame.x(0);
  source.y = frame.y(0) - k.centre.y;
  source.eps = static_cast<float>(k.radius_m);
  if (k.kind == KelvinletKind::grab) {
    const double b = 0.25 / (1.0 - k.poisson_ratio), force = k.radius_m / (1.5 - b);
    source.grab = true;
    source.re = static_cast<float>(force * k.speed_m_s.x);
    source.im = static_cast<float>(force * k.speed_m_s.y);
    source.pressed = static_cast<float>(b);
    return source;
  }
  const double strength = k.speed_m_s.x * k.radius_m * k.radius_m / kLargestFalloff;
  (k.kind == KelvinletKind::scale ? source.re : source.im) = static_cast<float>(strength);
  return source;
}

/// The sum on one grid.
class Sum {
 public:
  Sum(std::span<const Kelvinlet> kelvinlets, const GridFrame& frame) : frame_(frame) {
    const double extent = std::max(frame.width_m(), frame.height_m());
    while (extent > kFewest * std::ldexp(frame.cell_m, top_)) ++top_;
    groups_.resize(static_cast<size_t>(top_) + 1);
    for (const Kelvinlet& k : kelvinlets) {
      const Source source = source_of(k, frame);
      const bool far_away = source.x < -0.5 * extent || source.y < -0.5 * extent ||
                            source.x > frame.width_m() + 0.5 * extent || source.y > frame.height_m() + 0.5 * extent;
      const double level = std::floor(std::log2(k.radius_m / (kFinest * frame.cell_m)));
      groups_[static_cast<size_t>(far_away ? top_ : std::clamp<double>(level, 0.0, top_))].push_back(source);
    }
  }

  void add_to(VectorField& current, const RunContext& run) const {
    FlowLattice flow(frame_, top_);
    add_near(flow, std::numeric_limits<double>::infinity(), run);
    for (int level = top_ - 1; level >= 0; --level) {
      FlowLattice finer(frame_, level);
      add_coarser(flow, finer, run);
      flow = std::move(finer);
      const std::vector<Source>& sources = groups_[static_cast<size_t>(level)];
      if (sources.empty()) continue;
      float radius = 0.0F;
      for (const Source& source : sources) radius = std::max(radius, source.eps);
      const double reach = std::clamp(std::ceil(3.0 * static_cast<double>(radius) / flow.step_m), 20.0, 30.0);
      add_near(flow, reach, run);
      std::vector<Source> wide, narrow;  // the far field of each knows one radius, where that still matters
      const float least = 4.5 * static_cast<double>(radius) > reach * flow.step_m ? 0.7F * radius : 0.0F;
      for (const Source& source : sources) (source.eps >= least ? wide : narrow).push_back(source);
      add_far(wide, reach * flow.step_m, flow, run);
      add_far(narrow, reach * flow.step_m, flow, run);
    }
    parallel_rows(run, frame_.width, frame_.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        const float *u = &flow.u[flow.at(0, y)], *v = &flow.v[flow.at(0, y)];
        float *east = current.x.row(y).data(), *north = current.y.row(y).data();
        for (int x = 0; x < frame_.width; ++x) {
          east[x] += u[x];
          north[x] += v[x];
        }
      }
    });
  }

 private:
  /// A level's Kelvinlets on the nodes within `reach` steps of them.
  void add_near(FlowLattice& flow, double reach, const RunContext& run) const {
    const std::vector<Source>& sources = groups_[static_cast<size_t>(flow.level)];
    if (sources.empty()) return;
    constexpr int kRows = 16;
    const double h = flow.step_m;
    const int first = -FlowLattice::kMargin;
    const int last_row = flow.last_row - first, last_column = flow.last_column - first;
    const auto bound = [](double v, int low, int high) { return static_cast<int>(std::clamp<double>(v, low, high)); };
    const int blocks = (flow.rows() + kRows - 1) / kRows;
    std::vector<std::vector<const Source*>> in_block(static_cast<size_t>(blocks));
    for (const Source& source : sources) {
      const double low = std::ceil(source.y / h - reach), high = std::floor(source.y / h + reach);
      if (high < first || low > last_row) continue;
      const int from = (bound(low, first, last_row) - first) / kRows,
                to = (bound(high, first, last_row) - first) / kRows;
      for (int block = from; block <= to; ++block) in_block[static_cast<size_t>(block)].push_back(&source);
    }
    const auto inverse_reach = static_cast<float>(1.0 / (reach * h));
    parallel_blocks(run, blocks, 1, [&](int64_t block, int64_t) {
      const int begin = first + static_cast<int>(block) * kRows, end = std::min(begin + kRows, last_row + 1);
      for (const Source* source : in_block[static_cast<size_t>(block)]) {
        const double across = source->x / h, down = source->y / h;
        for (int y = bound(std::ceil(down - reach), begin, end); y < end && y <= down + reach; ++y) {
          const double half =
              std::isinf(reach) ? reach : std::sqrt(std::max(0.0, reach * reach - (y - down) * (y - down)));
          const double low = std::ceil(across - half), high = std::floor(across + half);
          if (low > last_column || high < first) continue;
          const int from = bound(low, first, last_column), count = bound(high, first, last_column) - from + 1;
          const auto add = source->grab ? add_grab_row : add_round_row;
          add(*source, static_cast<float>(from * h - source->x), static_cast<float>(source->y - y * h),
              static_cast<float>(h), inverse_reach, count, &flow.u[flow.at(from, y)], &flow.v[flow.at(from, y)]);
        }
      }
    });
  }

  const GridFrame& frame_;
  int top_ = 0;
  std::vector<std::vector<Source>> groups_;  ///< by the level whose lattice holds their radius
};

void check(std::span<const Kelvinlet> kelvinlets, const VectorField& current) {
  check_same_size("north components", current.y.frame(), current.x.frame(), "east components");
  for (size_t i = 0; i < kelvinlets.size(); ++i) {
    const Kelvinlet& k = kelvinlets[i];
    const std::string name = "kelvinlets[" + std::to_string(i) + "]";
    const double sum = k.centre.x + k.centre.y + k.speed_m_s.x + k.speed_m_s.y + k.radius_m;
    if (!std::isfinite(sum)) throw InvalidArgument(name, "has a place, speed or radius that is no number");
    if (!(k.radius_m > 0.0)) throw InvalidArgument(name, "radius " + format_number(k.radius_m) + " is not above 0");
    if (!(k.poisson_ratio >= 0.0 && k.poisson_ratio <= 0.5))
      throw InvalidArgument(name, "Poisson ratio " + format_number(k.poisson_ratio) + " is outside [0, 0.5]");
  }
}

}  // namespace
}  // namespace kelvinlets

void add_kelvinlets(std::span<const Kelvinlet> kelvinlets, VectorField& current, const RunContext& run) {
  kelvinlets::check(kelvinlets, current);
  if (kelvinlets.empty() || current.empty()) return;
  RunContext quiet = run;
  quiet.progress = nullptr;
  kelvinlets::Sum(kelvinlets, current.frame()).add_to(current, quiet);
}

void add_each_kelvinlet(std::span<const Kelvinlet> kelvinlets, VectorField& current, const RunContext& run) {
  kelvinlets::check(kelvinlets, current);
  if (current.empty()) return;
  const GridFrame& frame = current.frame();
  parallel_rows(run, frame.width, frame.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        Vec2 sum;
        for (const Kelvinlet& k : kelvinlets) sum = sum + flow_of(k, {frame.x(x), frame.y(y)});
        current.x(x, y) += static_cast<float>(sum.x);
        current.y(x, y) += static_cast<float>(sum.y);
      }
    }
  });
}

}  // namespace seamount::geom
