#include "seamount/geom/mesh/edge_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace seamount::geom {

EdgeFit::EdgeFit(const HeightField& heights, const MeshDomain& domain, LatticePoint from, LatticePoint to)
    : heights_(heights),
      domain_(domain),
      from_(from),
      to_(to),
      length_(std::max(to.x - from.x, to.y - from.y)),
      dx_(to.x > from.x ? 1 : 0),
      dy_(to.y > from.y ? 1 : 0) {}

LatticePoint EdgeFit::cell(int step) const { return {from_.x + step * dx_, from_.y + step * dy_}; }

void EdgeFit::start(std::vector<LatticePoint> more, bool frozen) {
  vertices_ = std::move(more);
  for (const LatticePoint end : {from_, to_}) {
    if (domain_.holds(end)) vertices_.push_back(end);
  }
  if (!domain_.is_whole()) {
    for (int step = 0; step <= length_; ++step) {
      if (domain_.is_rim(cell(step))) vertices_.push_back(cell(step));
    }
  }
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  if (frozen) return;
  const auto step_of = [&](LatticePoint p) { return std::max(p.x - from_.x, p.y - from_.y); };
  for (size_t i = 1; i < vertices_.size(); ++i) measure(step_of(vertices_[i - 1]), step_of(vertices_[i]));
}

/// Queues what lies between two vertices. There are no rim cells: all steps are in the domain or none is.
void EdgeFit::measure(int first, int last) {
  if (last - first < 2 || !domain_.holds_step(cell(first), cell(first + 1))) return;
  const LatticePoint a = cell(first), b = cell(last);
  const double low = heights_(a.x, a.y), slope = (double{heights_(b.x, b.y)} - low) / (last - first);
  double worst = 0.0;
  int where = first;
  for (int step = first + 1; step < last; ++step) {
    const LatticePoint p = cell(step);
    const double error = std::abs(low + slope * (step - first) - heights_(p.x, p.y));
    if (error > worst) worst = error, where = step;
  }
  if (where > first) spans_.emplace(worst, where, first, last);
}

void EdgeFit::refine(double error_m, int64_t most) {
  for (int64_t added = 0; added<most&& this->error_m()> error_m; ++added) {
    const auto [error, where, first, last] = spans_.top();
    spans_.pop();
    vertices_.push_back(cell(where));
    measure(first, where);
    measure(where, last);
  }
}

}  // namespace seamount::geom
