#include "seamount/ops/contour/convert/ground_slope.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"

namespace seamount::contour {
namespace {

constexpr int kBlock = 2;                ///< cells along a square of the finest level
constexpr float kCoarserCounts = 0.02F;  ///< as if so many cells of a square were beside a contour
constexpr float kRounding = 0.1F;        ///< cells from a contour within which cells tell less and less
constexpr float kNear = 2.0F;            ///< cells from a contour up to which the finest level tells

/// Bilinear in a level at a place in its own squares.
float bilinear(const std::vector<float>& values, int width, int height, float x, float y) {
  const float fx = std::clamp(x, 0.0F, static_cast<float>(width - 1));
  const float fy = std::clamp(y, 0.0F, static_cast<float>(height - 1));
  const int x0 = std::min(static_cast<int>(fx), std::max(width - 2, 0));
  const int y0 = std::min(static_cast<int>(fy), std::max(height - 2, 0));
  const int x1 = std::min(x0 + 1, width - 1);
  const int y1 = std::min(y0 + 1, height - 1);
  const float s = fx - static_cast<float>(x0);
  const float t = fy - static_cast<float>(y0);
  const auto value = [&](int column, int row) {
    return values[static_cast<size_t>(row) * static_cast<size_t>(width) + static_cast<size_t>(column)];
  };
  const float upper = value(x0, y0) + s * (value(x1, y0) - value(x0, y0));
  const float lower = value(x0, y1) + s * (value(x1, y1) - value(x0, y1));
  return upper + t * (lower - upper);
}

/// (1 2 1) / 4 along one direction.
void soften_along(std::vector<float>& values, int width, int height, bool rows, const RunContext& run) {
  const std::vector<float> from = values;
  parallel_rows(run, width, height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto at = [&](int column, int row) {
          return from[static_cast<size_t>(std::clamp(row, 0, height - 1)) * static_cast<size_t>(width) +
                      static_cast<size_t>(std::clamp(column, 0, width - 1))];
        };
        const float before = rows ? at(x - 1, y) : at(x, y - 1);
        const float after = rows ? at(x + 1, y) : at(x, y + 1);
        values[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] =
            0.25F * (before + after) + 0.5F * at(x, y);
      }
    }
  });
}

}  // namespace

GroundSlope::GroundSlope(const FaceGround& ground, const RunContext& run) {
  levels_ = {gather(ground, run)};
  soften(levels_[0], run);
  while (std::max(levels_.back().width, levels_.back().height) > 1) levels_.push_back(coarser(levels_.back()));
  for (size_t l = levels_.size(); l-- > 0;) {
    Level& here = levels_[l];
    const Level* above = l + 1 < levels_.size() ? &levels_[l + 1] : nullptr;
    parallel_rows(run, here.width, here.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < here.width; ++x) {
          const size_t i = static_cast<size_t>(y) * static_cast<size_t>(here.width) + static_cast<size_t>(x);
          float& slope = here.slopes[i];
          if (above == nullptr) {
            slope = here.weights[i] > 0.0F ? slope / here.weights[i] : 0.0F;
          } else {
            const float coarse = bilinear(above->slopes, above->width, above->height,
                                          0.5F * static_cast<float>(x) - 0.25F, 0.5F * static_cast<float>(y) - 0.25F);
            const float own = here.weights[i] > 0.0F ? slope / here.weights[i] : 0.0F;
            slope = coarse + (own - coarse) * here.known[i] / (here.known[i] + kCoarserCounts);
          }
        }
      }
    });
  }
}

float GroundSlope::at(int x, int y, float near) const {
  const float wanted = std::min(std::log2(1.0F + near / kNear), static_cast<float>(levels_.size() - 1));
  const auto fine = std::min(static_cast<size_t>(wanted), levels_.size() - 1);
  const float t = wanted - static_cast<float>(fine);
  const auto sample = [&](size_t level) {
    const Level& from = levels_[level];
    const float step = 1.0F / static_cast<float>(kBlock << level);
    return bilinear(from.slopes, from.width, from.height, step * (static_cast<float>(x) + 0.5F) - 0.5F,
                    step * (static_cast<float>(y) + 0.5F) - 0.5F);
  };
  const float slope = sample(fine);
  return t > 0.0F ? slope + t * (sample(fine + 1) - slope) : slope;
}

GroundSlope::Level GroundSlope::gather(const FaceGround& ground, const RunContext& run) const {
  const GridFrame& frame = ground.between.face.frame();
  Level level;
  level.width = (frame.width + kBlock - 1) / kBlock;
  level.height = (frame.height + kBlock - 1) / kBlock;
  level.slopes.resize(static_cast<size_t>(level.width) * static_cast<size_t>(level.height));
  level.weights.resize(level.slopes.size());
  level.known.resize(level.slopes.size());
  std::vector<float> rises(static_cast<size_t>(ground.faces.count()), 0.0F);
  for (int32_t face = 0; face < ground.faces.count(); ++face)
    if (ground.faces.bounds_of(face) == 2)
      rises[static_cast<size_t>(face)] = static_cast<float>(ground.faces.high_m(face) - ground.faces.low_m(face));
  parallel_rows(run, level.width, level.height, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int column = 0; column < level.width; ++column) {
        float slopes = 0.0F;
        float weights = 0.0F;
        float known = 0.0F;
        for (int y = row * kBlock; y < std::min((row + 1) * kBlock, frame.height); ++y) {
          for (int x = column * kBlock; x < std::min((column + 1) * kBlock, frame.width); ++x) {
            const float rise = rises[static_cast<size_t>(ground.between.face(x, y))];
            const float low = ground.between.low(x, y);
            const float high = ground.between.high(x, y);
            if (rise == 0.0F || !std::isfinite(low + high)) continue;
            const float near = std::min(low, high);
            // By 1 / width every stretch of a contour weighs the same, however many cells lie between it and the next.
            const float across = std::max(low + high, 0.5F);
            const float counts = std::min(near / kRounding, 1.0F) * std::exp(-near * near);
            slopes += counts * rise / (across * across);
            weights += counts / across;
            known += counts;
          }
        }
        const size_t i = static_cast<size_t>(row) * static_cast<size_t>(level.width) + static_cast<size_t>(column);
        level.slopes[i] = slopes / (kBlock * kBlock);
        level.weights[i] = weights / (kBlock * kBlock);
        level.known[i] = known / (kBlock * kBlock);
      }
    }
  });
  return level;
}

void GroundSlope::soften(Level& level, const RunContext& run) {
  for (std::vector<float>* values : {&level.slopes, &level.weights, &level.known})
    for (const bool rows : {true, false, true, false}) soften_along(*values, level.width, level.height, rows, run);
}

GroundSlope::Level GroundSlope::coarser(const Level& fine) {
  Level coarse;
  coarse.width = (fine.width + 1) / 2;
  coarse.height = (fine.height + 1) / 2;
  coarse.slopes.assign(static_cast<size_t>(coarse.width) * static_cast<size_t>(coarse.height), 0.0F);
  coarse.weights.assign(coarse.slopes.size(), 0.0F);
  coarse.known.assign(coarse.slopes.size(), 0.0F);
  for (int y = 0; y < fine.height; ++y) {
    for (int x = 0; x < fine.width; ++x) {
      const size_t from = static_cast<size_t>(y) * static_cast<size_t>(fine.width) + static_cast<size_t>(x);
      const size_t to = static_cast<size_t>(y / 2) * static_cast<size_t>(coarse.width) + static_cast<size_t>(x / 2);
      coarse.slopes[to] += 0.25F * fine.slopes[from];
      coarse.weights[to] += 0.25F * fine.weights[from];
      coarse.known[to] += 0.25F * fine.known[from];
    }
  }
  return coarse;
}

}  // namespace seamount::contour
