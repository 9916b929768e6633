#include "seamount/ops/island/peak_heights.h"

#include <algorithm>
#include <cmath>

#include "seamount/base/parallel.h"
#include "seamount/base/simd.h"
#include "seamount/base/text.h"

namespace seamount::island {
namespace {

constexpr double kNear = 0.3;          ///< of the land's width around a peak: what is moved with it
constexpr double kAsked = 0.08;        ///< of it: the summit of a peak that somebody placed is no further away
constexpr double kSteepest = 0.1;      ///< of what is drawn up
constexpr float kPressedFrom = 0.75F;  ///< of the height

struct Cell {
  int x = 0, y = 0;
  float z = -1e30F;
};

SEAMOUNT_VECTORISED float highest_of(const float* z, int count) {
  float highest = z[0];
  for (int i = 0; i < count; ++i) highest = z[i] > highest ? z[i] : highest;
  return highest;
}

SEAMOUNT_VECTORISED void press(float from, float factor, int count, float* __restrict z) {
  for (int i = 0; i < count; ++i) z[i] = z[i] > from ? from + (z[i] - from) * factor : z[i];
}

float highest_cell(const HeightField& terrain, const RunContext& run) {
  std::vector<float> rows(static_cast<size_t>(terrain.height()), -1e30F);
  parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) rows[static_cast<size_t>(y)] = highest_of(terrain.row(y).data(), terrain.width());
  });
  return *std::max_element(rows.begin(), rows.end());
}

/// Calls visit(x, y, squared distance) for the cells within `reach` of a place.
template <class Visit>
void near(const GridFrame& frame, Vec2 place, double reach, Visit visit) {
  const int x0 = std::max(0, static_cast<int>(std::floor(frame.column(place.x - reach))));
  const int x1 = std::min(frame.width - 1, static_cast<int>(std::ceil(frame.column(place.x + reach))));
  const int y0 = std::max(0, static_cast<int>(std::floor(frame.row(place.y + reach))));
  const int y1 = std::min(frame.height - 1, static_cast<int>(std::ceil(frame.row(place.y - reach))));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double dx = frame.x(x) - place.x, dy = frame.y(y) - place.y;
      if (dx * dx + dy * dy <= reach * reach) visit(x, y, dx * dx + dy * dy);
    }
  }
}

Cell highest_near(const HeightField& terrain, Vec2 place, double reach) {
  Cell best;
  near(terrain.frame(), place, std::max(reach, terrain.cell_m()), [&](int x, int y, double) {
    if (terrain(x, y) > best.z) best = {x, y, terrain(x, y)};
  });
  return best;
}

/// Presses what is higher around a place than its summit below it, the less the further away.
void press_around(HeightField& terrain, Vec2 place, float height, double reach) {
  near(terrain.frame(), place, reach, [&](int x, int y, double squared) {
    float& z = terrain(x, y);
    if (z <= height) return;
    const double away = std::sqrt(squared) / reach;
    const auto keep = static_cast<float>(std::clamp(4.0 * away - 3.0, 0.0, 1.0));
    const float pressed = height * (1.0F - 0.1F * (z - height) / (z - height + 0.2F * height));
    z = pressed + keep * (z - pressed);
  });
}

/// Scales the ground around a cell so that the cell comes to lie at `height`: fully there, not at all at `reach`.
void move_to(HeightField& terrain, const Cell& cell, float height, double widest) {
  const double change = height - cell.z;
  const Vec2 place{terrain.frame().x(cell.x), terrain.frame().y(cell.y)};
  const double reach = std::max(1.5 * terrain.cell_m(), std::min(widest, 1.6 * std::abs(change) / kSteepest));
  const double factor = change / static_cast<double>(cell.z);
  near(terrain.frame(), place, reach, [&](int x, int y, double squared) {
    const double share = 1.0 - squared / (reach * reach);
    float& z = terrain(x, y);
    if (z > 0.0F) z = std::min(height, z * static_cast<float>(1.0 + factor * share * share));
  });
  terrain(cell.x, cell.y) = height;
}

/// How far the ground belongs to a peak: no more than half the way to a higher one.
double around_peak(const std::vector<Peak>& peaks, size_t i) {
  double reach = 0.55 * peaks[i].radius_m;
  for (size_t j = 0; j < i; ++j) {
    const Vec2 way = peaks[j].place - peaks[i].place;
    reach = std::min(reach, 0.5 * std::sqrt(dot(way, way)));
  }
  return reach;
}

}  // namespace

void set_peak_heights(HeightField& terrain, const std::vector<Peak>& peaks, const RunContext& run) {
  if (peaks.empty() || terrain.empty()) return;
  const auto top = static_cast<float>(peaks.front().height_m);
  const float highest = highest_cell(terrain, run);
  if (highest <= 0.0F || top <= 0.0F) return;
  if (highest > top) {
    const float from = kPressedFrom * top;
    parallel_rows(run, terrain.width(), terrain.height(), [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        press(from, (top - from) / (highest - from), terrain.width(), terrain.row(y).data());
    });
  }
  for (size_t i = 0; i < peaks.size(); ++i) {
    const Peak& peak = peaks[i];
    if (i > 0 && !peak.exact) continue;
    const auto height = static_cast<float>(peak.height_m);
    const double reach = kNear * peak.radius_m;
    const double rim = peak.profile.knots.empty() ? 0.0 : highest_at(geom::CurveFunction(peak.profile));
    const double beside = around_peak(peaks, i);
    if (peak.exact) press_around(terrain, peak.place, height, beside);
    const double asked = std::max(kAsked, 1.3 * rim) * peak.radius_m;
    const Cell cell = highest_near(terrain, peak.place, peak.exact ? asked : reach);
    if (cell.z != height && cell.z > 0.0F) move_to(terrain, cell, height, peak.radius_m);
    const Cell around = highest_near(terrain, peak.place, 0.7 * beside);
    if (peak.exact && around.z > height + 1.0F)
      run.say("the summit at (" + format_number(std::round(peak.place.x)) + ", " +
              format_number(std::round(peak.place.y)) + ") of " + format_number(std::round(peak.height_m)) +
              " m stands on the slope of a higher one: the ground beside it is " + format_number(std::round(around.z)) +
              " m high");
  }
}

}  // namespace seamount::island
