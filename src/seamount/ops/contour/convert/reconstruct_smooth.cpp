// Each contour has one slope at each of its edges, the mean of those of the bands on either side. From the contour
// below the ground rises at that slope, from the contour above it falls at that contour's, and the two are blended
// across the band (Hormann, Spinello and Schroeder 2003 do so with cubics along the way between the nearest points):
//
//   h = (1 - b) (h_k + I s(m_k d_k / I)) + b (h_{k+1} - I s(m_{k+1} d_{k+1} / I)),  b = 3 t^2 - 2 t^3,
//   t = d_k / (d_k + d_{k+1}), I = h_{k+1} - h_k, s saturating below 1,
//
// so heights meet each contour with the same slope from both sides and stay between the levels, while spurs and valleys
// between two branches of one contour, which the plain interpolation leaves almost level, go on as steep as the slopes
// beside them. Creases on the medial axes stay: they are the ridges and the valleys. A plate's few sweeps take the
// noise of the distances, and the channels by which valley floors are drained, into the surface.
#include <algorithm>
#include <array>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/geom/scalar/blend.h"
#include "seamount/geom/solve/drain.h"
#include "seamount/geom/solve/thin_plate.h"
#include "seamount/ops/contour/convert/face_ground.h"

namespace seamount::contour {
namespace {

constexpr float kNoSlope = -1.0F;
constexpr float kBeside = 6.0F;  ///< cells over which an edge's own slope fades into that of open ground

/// Metres a cell across the face's band where it is nearest to a place (in cells); kNoSlope where no cell of the face
/// is near or no band has two bounds.
float slope_beside(const FaceGround& ground, int32_t face, double column, double row) {
  if (ground.faces.bounds_of(face) != 2) return kNoSlope;
  constexpr int kNear = 2;
  const auto x0 = static_cast<int>(std::clamp(std::round(column), -1e6, 1e9));
  const auto y0 = static_cast<int>(std::clamp(std::round(row), -1e6, 1e9));
  double nearest = 1e30;
  float width = 0.0F;
  for (int y = y0 - kNear; y <= y0 + kNear; ++y) {
    for (int x = x0 - kNear; x <= x0 + kNear; ++x) {
      if (!ground.between.face.contains(x, y) || ground.between.face(x, y) != face) continue;
      const double squared = (x - column) * (x - column) + (y - row) * (y - row);
      const float across = ground.between.low(x, y) + ground.between.high(x, y);
      if (squared >= nearest || !std::isfinite(across)) continue;
      nearest = squared;
      width = across;
    }
  }
  if (nearest == 1e30) return kNoSlope;
  return static_cast<float>(ground.faces.high_m(face) - ground.faces.low_m(face)) / std::max(width, 0.5F);
}

/// The mean over five edges of those that have a slope.
void average_along(std::span<const float> raw, std::span<float> slopes) {
  const size_t n = raw.size();
  for (size_t i = 0; i < n; ++i) {
    float sum = 0.0F;
    float count = 0.0F;
    for (size_t k = 0; k < 5; ++k) {
      const float slope = raw[(i + 2 * n + k - 2) % n];
      if (slope <= kNoSlope) continue;
      sum += slope;
      count += 1.0F;
    }
    slopes[i] = count > 0.0F ? sum / count : kNoSlope;
  }
}

/// Per edge of all rings.
std::vector<float> edge_slopes(const ContourSet& set, const FaceGround& ground, const RunContext& run) {
  std::vector<size_t> first = {0};
  first.reserve(set.contours.size() + 1);
  for (const Contour& contour : set.contours) first.push_back(first.back() + contour.ring.size());
  std::vector<float> slopes(first.back());
  const GridFrame& frame = ground.between.face.frame();
  parallel_blocks(run, static_cast<int64_t>(set.contours.size()), 8, [&](int64_t begin, int64_t end) {
    for (auto c = static_cast<size_t>(begin); c < static_cast<size_t>(end); ++c) {
      const Ring& ring = set.contours[c].ring;
      std::vector<float> raw(ring.size());
      for (size_t i = 0; i < ring.size(); ++i) {
        const Vec2 middle = 0.5 * (ring[i] + ring[i + 1 < ring.size() ? i + 1 : 0]);
        const double column = frame.column(middle.x);
        const double row = frame.row(middle.y);
        const float inside = slope_beside(ground, static_cast<int32_t>(c) + 1, column, row);
        const float outside = slope_beside(ground, set.contours[c].parent + 1, column, row);
        raw[i] = inside > kNoSlope && outside > kNoSlope ? 0.5F * (inside + outside) : std::max(inside, outside);
      }
      average_along(raw, std::span(slopes).subspan(first[c], ring.size()));
    }
  });
  return slopes;
}

/// The height of one cell.
class Blend {
 public:
  Blend(const FaceGround& ground, const std::vector<float>& slopes) : ground_(ground), slopes_(slopes) {}

  float at(int x, int y) const {
    const int32_t face = ground_.between.face(x, y);
    const float low = ground_.between.low(x, y);
    const float high = ground_.between.high(x, y);
    const auto foot = static_cast<float>(ground_.faces.bounds_of(face) > 0 ? ground_.faces.low_m(face) : 0.0);
    const auto f = static_cast<size_t>(face);
    if (ground_.open(face)) {
      const float reach = ground_.reach_m[f];
      if (!std::isfinite(low)) return foot + ground_.sign(face) * reach * 0.5F;
      // The nearest edge's own slope counts beside it alone, or else each edge would draw a ray across open ground.
      const float own = slope_of(ground_.between.low_edge(x, y), ground_.slope[f]) - ground_.slope[f];
      const float climb = low * (ground_.slope[f] + own * std::exp(-low / kBeside));
      return foot + ground_.sign(face) * reach * saturated(climb / reach);
    }
    if (ground_.faces.bounds_of(face) != 2 || !std::isfinite(low) || !std::isfinite(high))
      return ground_.between.height_m(x, y);
    const float rise = static_cast<float>(ground_.faces.high_m(face)) - foot;
    const float across = std::max(low + high, 1e-6F);
    const float up = saturated_late(slope_of(ground_.between.low_edge(x, y), rise / across) * low / rise);
    const float down = saturated_late(slope_of(ground_.between.high_edge(x, y), rise / across) * high / rise);
    return foot + rise * (up + (1.0F - down - up) * geom::smoothstep(low / across));
  }

 private:
  float slope_of(int32_t edge, float otherwise) const {
    const float slope = edge >= 0 ? slopes_[static_cast<size_t>(edge)] : kNoSlope;
    return slope > 0.0F ? slope : otherwise;
  }

  const FaceGround& ground_;
  const std::vector<float>& slopes_;
};

/// How far smoothing may move heights: less next to a contour, and never beyond the levels.
struct Bounds {
  HeightField low, high;
};
Bounds smoothing_bounds(const FaceGround& ground, const HeightField& heights, const RunContext& run) {
  constexpr float kShare = 0.2F;
  constexpr float kFull = 2.0F;  ///< cells from a contour at which heights may move by the whole share
  Bounds bounds{HeightField(heights.frame()), HeightField(heights.frame())};
  parallel_rows(run, heights.width(), heights.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < heights.width(); ++x) {
        const int32_t face = ground.between.face(x, y);
        const float z = heights(x, y);
        const float near = std::min({ground.between.low(x, y), ground.between.high(x, y), kFull}) / kFull;
        float room = kShare * near * ground.reach_m[static_cast<size_t>(face)];
        float least = -1e30F;
        float most = 1e30F;
        if (ground.faces.bounds_of(face) > 1) {
          least = static_cast<float>(ground.faces.low_m(face));
          most = static_cast<float>(ground.faces.high_m(face));
          room = kShare * near * (most - least);
        } else if (ground.open(face)) {
          (ground.faces.rises(face) ? least : most) = static_cast<float>(ground.faces.low_m(face));
        }
        bounds.low(x, y) = std::min(z, std::max(z - room, least));
        bounds.high(x, y) = std::max(z, std::min(z + room, most));
      }
    }
  });
  return bounds;
}

/// Smooths; drains, and smooths the channels' surroundings down to them.
HeightField settle(const FaceGround& ground, HeightField heights, Bounds bounds, const RunContext& run) {
  constexpr int kFirstSweeps = 3;
  constexpr int kSweeps = 7;
  constexpr int kRounds = 2;
  heights = geom::smooth_thin_plate(std::move(heights), bounds.low, bounds.high, kFirstSweeps, run.part(0.0, 0.2));
  for (int round = 0; round < kRounds; ++round) {
    geom::drain(heights, basin_floors(ground, heights), run.part(0.2 + 0.3 * round, 0.3 + 0.3 * round));
    // Where a channel was cut or a floor raised, the surface may not go back.
    parallel_rows(run.part(0.3, 0.3), heights.width(), heights.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < heights.width(); ++x) {
          float& low = bounds.low(x, y);
          float& high = bounds.high(x, y);
          const float z = heights(x, y);
          if (z < low) high = z;
          low = std::min(low, z);
          high = std::max(high, low);
        }
      }
    });
    heights = geom::smooth_thin_plate(std::move(heights), bounds.low, bounds.high, kSweeps,
                                      run.part(0.3 + 0.3 * round, 0.5 + 0.3 * round));
  }
  geom::drain(heights, basin_floors(ground, heights), run.part(0.8, 1.0));
  return heights;
}

}  // namespace

HeightField smooth_surface(const ContourSet& set, FaceGround ground, const RunContext& run) {
  const std::vector<float> slopes = edge_slopes(set, ground, run.part(0.0, 0.05));
  const Blend blend(ground, slopes);
  HeightField& heights = ground.between.height_m;
  parallel_rows(run.part(0.05, 0.1), heights.width(), heights.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < heights.width(); ++x) heights(x, y) = blend.at(x, y);
    }
  });
  ground.between.low_edge = ground.between.high_edge = {};
  Bounds bounds = smoothing_bounds(ground, heights, run.part(0.1, 0.15));
  ground.between.low = ground.between.high = {};
  return settle(ground, std::move(heights), std::move(bounds), run.part(0.15, 1.0));
}

}  // namespace seamount::contour
