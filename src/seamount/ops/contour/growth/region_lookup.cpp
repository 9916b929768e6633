// Points in regions (regions.h): the edges of all outlines are entered once into rows of equal height, ring after ring,
// so that a point counts crossings to its right among the edges of its row alone.
#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/polygon/predicates.h"
#include "seamount/ops/contour/growth/regions.h"

namespace seamount::contour {
namespace {

struct RowEdge {
  Vec2 a, b;
  int32_t region;
};

class EdgeRows {
 public:
  EdgeRows(const RegionTree& tree, const RunContext& run) {
    geom::Box box;
    size_t edges = 0;
    for (const GrowthRegion& region : tree.regions) {
      const geom::Box b = geom::bounding_box(region.outline);
      if (box.empty()) box = b;
      box.low.y = std::min(box.low.y, b.low.y);
      box.high.y = std::max(box.high.y, b.high.y);
      edges += region.outline.size();
    }
    rows_.resize(std::clamp<size_t>(edges / 4, 1, 8192));
    south_ = box.low.y;
    scale_ = static_cast<double>(rows_.size()) / std::max(box.high.y - box.low.y, 1e-300);
    for (size_t r = 0; r < tree.regions.size(); ++r) enter(tree.regions[r].outline, static_cast<int32_t>(r), run);
  }

  /// Parents stand before children, so that the last ring around p is the innermost.
  int32_t region_at(Vec2 p) const {
    int32_t found = -1;
    int32_t ring = -1;
    bool inside = false;
    for (const RowEdge& edge : rows_[row_of(p.y)]) {
      if (edge.region != ring) {
        if (inside) found = ring;
        ring = edge.region;
        inside = false;
      }
      if (geom::ray_crosses(p, edge.a, edge.b)) inside = !inside;
    }
    return inside ? ring : found;
  }

 private:
  size_t row_of(double y) const {
    return static_cast<size_t>(std::clamp((y - south_) * scale_, 0.0, static_cast<double>(rows_.size() - 1)));
  }

  void enter(const Ring& ring, int32_t region, const RunContext& run) {
    for (size_t i = 0; i < ring.size(); ++i) {
      run.check_cancelled();
      const Vec2 a = ring[i];
      const Vec2 b = ring[(i + 1) % ring.size()];
      const size_t last = row_of(std::max(a.y, b.y));
      for (size_t row = row_of(std::min(a.y, b.y)); row <= last; ++row) rows_[row].push_back({a, b, region});
    }
  }

  std::vector<std::vector<RowEdge>> rows_;
  double south_ = 0.0;
  double scale_ = 1.0;
};

}  // namespace

int region_at(const RegionTree& tree, Vec2 p) {
  for (size_t i = tree.regions.size(); i-- > 0;) {
    if (geom::contains(tree.regions[i].outline, p)) return static_cast<int>(i);
  }
  return -1;
}

std::vector<int32_t> regions_at(const RegionTree& tree, const std::vector<Vec2>& points, const RunContext& run) {
  const EdgeRows rows(tree, run);
  std::vector<int32_t> regions(points.size());
  parallel_blocks(run, static_cast<int64_t>(points.size()), 4096, [&](int64_t begin, int64_t end) {
    for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) regions[i] = rows.region_at(points[i]);
  });
  return regions;
}

}  // namespace seamount::contour
