#include "seamount/ops/contour/edit/patch_border.h"

#include <algorithm>
#include <cmath>

namespace seamount::contour {
namespace {

constexpr double kMinApart = 1e-9;  ///< of a cell

/// Where an edge of a contour crosses a line of the lattice.
struct LatticeCrossing {
  double t;     ///< along the contour's edge
  bool column;  ///< crosses a line of constant x
  int line;
};

class Cutter {
 public:
  Cutter(const Patch& patch, CutContours& out) : patch_(patch), frame_(patch.nodes), out_(out) {}

  bool inside(Vec2 p) const {
    const double column = frame_.column(p.x);
    const double row = frame_.row(p.y);
    if (!(column >= 0.0 && row >= 0.0 && column < frame_.width && row < frame_.height)) return false;
    return patch_.has(static_cast<int>(column), static_cast<int>(row));
  }

  /// False if a cut is not clear.
  bool cut(const Contour& contour) {
    const size_t n = contour.ring.size();
    const size_t first_piece = out_.pieces.size();
    Polyline lead;         // outside points before the first cut
    int64_t leaving = -1;  // the cut at which the current outside piece began
    int64_t first_entry = -1;
    bool is_inside = inside(contour.ring[0]);
    const bool began_inside = is_inside;
    Polyline between;
    for (size_t i = 0; i < n; ++i) {
      if (!is_inside) between.push_back(contour.ring[i]);
      crossings_.clear();
      if (!collect(contour.ring[i], contour.ring[(i + 1) % n])) return false;
      for (size_t c = 0; c < crossings_.size(); ++c) {
        const double until = c + 1 < crossings_.size() ? crossings_[c + 1].t : 1.0;
        const Vec2 a = contour.ring[i];
        const Vec2 d = contour.ring[(i + 1) % n] - a;
        const bool then_inside = inside(a + (0.5 * (crossings_[c].t + until)) * d);
        if (then_inside == is_inside) continue;
        if (!add_cut(contour, a, d, crossings_[c], then_inside)) return false;
        const size_t cut = out_.cuts.size() - 1;
        if (!then_inside) {
          leaving = static_cast<int64_t>(cut);
        } else if (leaving >= 0) {
          out_.pieces.push_back({static_cast<size_t>(leaving), cut, std::move(between)});
          leaving = -1;
        } else {
          first_entry = static_cast<int64_t>(cut);
          lead = std::move(between);
        }
        between.clear();
        is_inside = then_inside;
      }
    }
    if (is_inside != began_inside) return false;
    if (leaving >= 0 && first_entry >= 0) {
      between.insert(between.end(), lead.begin(), lead.end());
      out_.pieces.push_back({static_cast<size_t>(leaving), static_cast<size_t>(first_entry), std::move(between)});
    } else if (out_.pieces.size() == first_piece && !is_inside) {
      out_.whole.push_back(contour);
    }
    return true;
  }

 private:
  /// Crossings of a -> b with the lattice's lines, in order. False if two fall together.
  bool collect(Vec2 a, Vec2 b) {
    const auto lines = [&](double from, double to, int count, bool column) {
      const double low = std::max(0.0, std::ceil(std::min(from, to)));
      const double high = std::min(count - 1.0, std::floor(std::max(from, to)));
      if (from == to) return;
      for (double line = low; line <= high; line += 1.0) {
        const double t = (line - from) / (to - from);
        if (t >= 0.0 && t < 1.0) crossings_.push_back({t, column, static_cast<int>(line)});
      }
    };
    lines(frame_.column(a.x), frame_.column(b.x), frame_.width, true);
    lines(frame_.row(a.y), frame_.row(b.y), frame_.height, false);
    std::sort(crossings_.begin(), crossings_.end(),
              [](const LatticeCrossing& c, const LatticeCrossing& d) { return c.t < d.t; });
    for (size_t i = 1; i < crossings_.size(); ++i) {
      if (crossings_[i].t == crossings_[i - 1].t) return false;
    }
    return crossings_.empty() || crossings_[0].t > 0.0;
  }

  bool add_cut(const Contour& contour, Vec2 a, Vec2 d, const LatticeCrossing& crossing, bool enters) {
    Vec2 at = a + crossing.t * d;
    int x = crossing.line;
    int y = crossing.line;
    double along = 0.0;
    Vec2 edge;
    if (crossing.column) {
      at.x = frame_.x(x);
      const double row = frame_.row(at.y);
      y = static_cast<int>(std::floor(row));
      along = row - y;
      edge = {0.0, -1.0};
    } else {
      at.y = frame_.y(y);
      const double column = frame_.column(at.x);
      x = static_cast<int>(std::floor(column));
      along = column - x;
      edge = {1.0, 0.0};
    }
    if (along < kMinApart || along > 1.0 - kMinApart) return false;
    const int64_t key = edge_key(patch_, x, y, crossing.column);
    out_.on_edge[key].push_back(out_.cuts.size());
    // A contour that crosses the edge to its left has the edge's first node on its own left: on its higher side.
    out_.cuts.push_back({at, contour.height_m, key, along, enters, cross(edge, d) > 0.0});
    return true;
  }

  const Patch& patch_;
  const GridFrame& frame_;
  CutContours& out_;
  std::vector<LatticeCrossing> crossings_;
};

}  // namespace

int64_t edge_key(const Patch& patch, int x, int y, bool south) {
  return 2 * (static_cast<int64_t>(y) * patch.nodes.width + x) + (south ? 1 : 0);
}

std::optional<CutContours> cut_contours(const ContourSet& set, const Patch& patch, const RunContext& run) {
  CutContours out;
  Cutter cutter(patch, out);
  for (const Contour& contour : set.contours) {
    run.check_cancelled();
    if (!cutter.cut(contour)) return std::nullopt;
  }
  for (auto& [edge, cuts] : out.on_edge) {
    std::sort(cuts.begin(), cuts.end(), [&](size_t a, size_t b) {
      return out.cuts[a].along != out.cuts[b].along ? out.cuts[a].along < out.cuts[b].along : a < b;
    });
    for (size_t i = 1; i < cuts.size(); ++i) {
      if (out.cuts[cuts[i]].along - out.cuts[cuts[i - 1]].along < kMinApart) return std::nullopt;
    }
  }
  return out;
}

}  // namespace seamount::contour
