#include "seamount/ops/render/tracer.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"

namespace seamount::render {
namespace {

Grid<float> patch_maxima(const HeightField& heights, const RunContext& run) {
  Grid<float> maxima(GridFrame{heights.width() - 1, heights.height() - 1, 1.0, 0.0, 0.0, {}});
  parallel_rows(run, maxima.width(), maxima.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const float* a = heights.row(y).data();
      const float* b = heights.row(y + 1).data();
      float* out = maxima.row(y).data();
      for (int x = 0; x < maxima.width(); ++x) {
        out[x] = std::max(std::max(a[x], a[x + 1]), std::max(b[x], b[x + 1]));
      }
    }
  });
  return maxima;
}

Grid<float> halved_maxima(const Grid<float>& fine, const RunContext& run) {
  Grid<float> coarse(GridFrame{(fine.width() + 1) / 2, (fine.height() + 1) / 2, 1.0, 0.0, 0.0, {}});
  parallel_rows(run, coarse.width(), coarse.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < coarse.width(); ++x) {
        const int x1 = std::min(2 * x + 1, fine.width() - 1), y1 = std::min(2 * y + 1, fine.height() - 1);
        coarse(x, y) = std::max(std::max(fine(2 * x, 2 * y), fine(x1, 2 * y)), std::max(fine(2 * x, y1), fine(x1, y1)));
      }
    }
  });
  return coarse;
}

}  // namespace

Tracer::Tracer(const HeightField& heights, const RunContext& run) : heights_(heights) {
  maxima_.push_back(patch_maxima(heights, run));
  while (maxima_.back().width() > 1 || maxima_.back().height() > 1) {
    maxima_.push_back(halved_maxima(maxima_.back(), run));
  }
}

float Tracer::height(float column, float row) const {
  const float c = std::clamp(column, 0.0F, static_cast<float>(heights_.width() - 1));
  const float r = std::clamp(row, 0.0F, static_cast<float>(heights_.height() - 1));
  const int x = std::min(static_cast<int>(c), heights_.width() - 2);
  const int y = std::min(static_cast<int>(r), heights_.height() - 2);
  const float u = c - static_cast<float>(x), v = r - static_cast<float>(y);
  const float upper = heights_(x, y) + u * (heights_(x + 1, y) - heights_(x, y));
  const float lower = heights_(x, y + 1) + u * (heights_(x + 1, y + 1) - heights_(x, y + 1));
  return upper + v * (lower - upper);
}

bool Tracer::clip(const LatticeRay& ray, float& begin, float& end) const {
  const auto slab = [&](float at, float slope, float size) {
    if (slope == 0.0F) return at >= 0.0F && at <= size;
    const float a = -at / slope, b = (size - at) / slope;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
    return begin < end;
  };
  return slab(ray.column, ray.dcolumn, static_cast<float>(heights_.width() - 1)) &&
         slab(ray.row, ray.drow, static_cast<float>(heights_.height() - 1));
}

float Tracer::meet_patch(const LatticeRay& ray, int x, int y, float begin, float end) const {
  const float a = heights_(x, y), b = heights_(x + 1, y) - a, c = heights_(x, y + 1) - a;
  const float d = heights_(x + 1, y + 1) - a - b - c;
  // Height of the ray over the patch, a quadratic in s = t - begin.
  const float u = ray.column + ray.dcolumn * begin - static_cast<float>(x);
  const float v = ray.row + ray.drow * begin - static_cast<float>(y);
  const float f0 = ray.height + ray.dheight * begin - (a + b * u + c * v + d * u * v);
  if (f0 <= 0.0F) return begin;
  const float f1 = ray.dheight - (b * ray.dcolumn + c * ray.drow + d * (u * ray.drow + v * ray.dcolumn));
  const float f2 = -d * ray.dcolumn * ray.drow;
  const float length = end - begin;
  const float discriminant = f1 * f1 - 4.0F * f2 * f0;
  if (discriminant < 0.0F) return -1.0F;
  // The smaller positive root, written without cancellation; f0 > 0.
  const float root = std::sqrt(discriminant);
  const float q = -0.5F * (f1 + (f1 >= 0.0F ? root : -root));
  const float s1 = q != 0.0F ? f0 / q : -1.0F;
  const float s2 = f2 != 0.0F ? q / f2 : -1.0F;
  float s = -1.0F;
  if (s1 >= 0.0F && s1 <= length) s = s1;
  if (s2 >= 0.0F && s2 <= length && (s < 0.0F || s2 < s)) s = s2;
  return s < 0.0F ? -1.0F : begin + s;
}

float Tracer::trace(const LatticeRay& ray, float begin, float end) const {
  const float fastest = std::max(std::abs(ray.dcolumn), std::abs(ray.drow));
  const float nudge = fastest > 0.0F ? 1e-3F / fastest : 0.0F;  // a thousandth of a cell: into the next node
  const float across = ray.dcolumn != 0.0F ? 1.0F / ray.dcolumn : 1e30F;
  const float down = ray.drow != 0.0F ? 1.0F / ray.drow : 1e30F;
  const int last_x = heights_.width() - 2, last_y = heights_.height() - 2;
  const int top = static_cast<int>(maxima_.size()) - 1;
  int level = std::min(top, 6);
  float t = begin;
  while (t < end) {
    const int x = std::clamp(static_cast<int>(ray.column + ray.dcolumn * (t + nudge)), 0, last_x);
    const int y = std::clamp(static_cast<int>(ray.row + ray.drow * (t + nudge)), 0, last_y);
    const int nx = x >> level, ny = y >> level;
    const auto edge_x = static_cast<float>((nx + (ray.dcolumn > 0.0F ? 1 : 0)) << level);
    const auto edge_y = static_cast<float>((ny + (ray.drow > 0.0F ? 1 : 0)) << level);
    const float leave_x = ray.dcolumn != 0.0F ? (edge_x - ray.column) * across : 1e30F;
    const float leave_y = ray.drow != 0.0F ? (edge_y - ray.row) * down : 1e30F;
    const float leave = std::min(end, std::max(std::min(leave_x, leave_y), t + nudge));
    const float lowest = ray.height + ray.dheight * (ray.dheight < 0.0F ? leave : t);
    if (lowest > maxima_[static_cast<size_t>(level)](nx, ny)) {
      t = leave;
      if (level < top) ++level;
    } else if (level > 0) {
      --level;
    } else {
      const float hit = meet_patch(ray, x, y, t, leave);
      if (hit >= 0.0F) return hit;
      t = leave;
    }
  }
  return -1.0F;
}

}  // namespace seamount::render
