#include "seamount/ops/erosion/lithology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seamount/geom/scalar/noise.h"

namespace seamount::erosion {
namespace {

constexpr float kEndless = std::numeric_limits<float>::infinity();
// Folds wander and swell over so many of their wavelengths, by so many radians and shares of their height per unit of
// noise.
constexpr double kFoldLength = 3.0, kFoldBend = 3.0, kFoldSwell = 0.8;
constexpr double kThickness_m = 4000.0;  // over which beds thicken and thin
constexpr double kThicknessGain = 2.0;   // noise has a deviation of about a third

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// Metres to the right of a direction given by its bearing.
double to_the_right(double bearing_deg, double x, double y) {
  const double angle = radians(bearing_deg);
  return x * std::cos(angle) - y * std::sin(angle);
}

/// Metres to the right of a line that goes on straight beyond its ends.
double to_the_right(const Polyline& line, Vec2 place) {
  double best = std::numeric_limits<double>::infinity(), side = 0;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 along = line[i + 1] - line[i], from = place - line[i];
    const double length = std::sqrt(dot(along, along));
    if (length <= 0) continue;
    const double low = i == 0 ? -std::numeric_limits<double>::infinity() : 0.0;
    const double high = i + 2 == line.size() ? std::numeric_limits<double>::infinity() : length;
    const double at = dot(from, along) / length, across = cross(from, along) / length;
    const double beyond = at - std::clamp(at, low, high), distance = std::hypot(across, beyond);
    // At a corner two pieces are as near: the one that the place lies farther aside of knows the side.
    const bool tie = std::abs(distance - best) <= 1e-9 * (1.0 + best);
    if (tie ? std::abs(across) > std::abs(side) : distance < best) {
      best = distance;
      side = across;
    }
  }
  return std::copysign(std::min(best, 1e12), side);
}

geom::Fbm smooth(double wavelength_m) { return {.wavelength_m = wavelength_m, .octaves = 1}; }

}  // namespace

BedSequence::BedSequence(const std::vector<BedParams>& beds, bool repeat) : repeats_(repeat) {
  if (beds.empty()) return;
  double depth = 0, hardness = 0, ease = 0;
  softest_ = kEndless;
  for (const BedParams& bed : beds) {
    top_.push_back(static_cast<float>(depth));
    hardness_.push_back(static_cast<float>(bed.hardness));
    softest_ = std::min(softest_, hardness_.back());
    depth += bed.thickness_m;
    hardness += bed.thickness_m * bed.hardness;
    ease += bed.thickness_m / std::sqrt(bed.hardness);
  }
  top_.push_back(static_cast<float>(depth));
  mean_hardness_ = static_cast<float>(hardness / depth);
  mean_ease_ = static_cast<float>(ease / depth);
  period_ = repeat ? static_cast<float>(depth) : kEndless;
}

BedSequence::Bed BedSequence::bed_of(float cycle, size_t index) const {
  const float shift = repeats_ ? cycle * period_ : 0.0F;
  const bool first = !repeats_ && index == 0, last = !repeats_ && index + 1 == hardness_.size();
  return {static_cast<int>(index), hardness_[index], first ? -kEndless : shift + top_[index],
          last ? kEndless : shift + top_[index + 1]};
}

BedSequence::Bed BedSequence::at(float depth) const {
  const float cycle = repeats_ ? std::floor(depth / period_) : 0.0F;
  const float within = repeats_ ? depth - cycle * period_ : depth;
  const auto above = std::upper_bound(top_.begin() + 1, top_.end() - 1, within);
  return bed_of(cycle, static_cast<size_t>(above - top_.begin()) - 1);
}

BedSequence::Bed BedSequence::under(const Bed& bed) const {
  const size_t next = (static_cast<size_t>(bed.index) + 1) % hardness_.size();
  const float shift = bed.bottom - top_[next];
  return {static_cast<int>(next), hardness_[next], bed.bottom,
          !repeats_ && next + 1 == hardness_.size() ? kEndless : shift + top_[next + 1]};
}

BedSequence::Bed BedSequence::over(const Bed& bed) const {
  const size_t next = (static_cast<size_t>(bed.index) + hardness_.size() - 1) % hardness_.size();
  const float shift = bed.top - top_[next + 1];
  return {static_cast<int>(next), hardness_[next], !repeats_ && next == 0 ? -kEndless : shift + top_[next], bed.top};
}

Lithology::Lithology(const LithologyParams& params, Seed seed)
    : params_(params),
      bends_(seed.derive("folds.bends")),
      swells_(seed.derive("folds.swells")),
      thickness_(seed.derive("thickness")) {
  check_params(params, "lithology.");
  for (size_t i = 0; i < params.faults.size(); ++i) {
    const Polyline& trace = params.faults[i].trace;
    if (trace.size() < 2 || std::all_of(trace.begin(), trace.end(), [&](Vec2 p) { return p == trace.front(); }))
      throw InvalidArgument("lithology.faults[" + std::to_string(i) + "].trace", "a line needs two different points");
  }
  beds_ = BedSequence(params.beds, params.repeat);
}

double Lithology::plane(double x, double y) const {
  return params_.top_m - std::tan(radians(params_.dip_deg)) *
                             to_the_right(params_.strike_deg, x - params_.top_x_m, y - params_.top_y_m);
}

double Lithology::folded(double x, double y, double bend, double swell) const {
  const double across =
      to_the_right(params_.fold_axis_deg.value_or(params_.strike_deg), x - params_.top_x_m, y - params_.top_y_m);
  return 0.5 * params_.fold_height_m * (1.0 + kFoldSwell * swell) *
         std::cos(2.0 * std::numbers::pi * across / params_.fold_wavelength_m + kFoldBend * bend);
}

double Lithology::thrown(double x, double y, double z) const {
  double sum = 0;
  for (const FaultParams& fault : params_.faults) {
    const double plane = (params_.top_m - z) / std::tan(radians(fault.dip_deg));
    if (to_the_right(fault.trace, {x, y}) > plane) sum += fault.throw_m;
  }
  return sum;
}

bool Lithology::faults_dip() const {
  return std::any_of(params_.faults.begin(), params_.faults.end(),
                     [](const FaultParams& fault) { return fault.dip_deg < 90; });
}

double Lithology::datum(double x, double y, double z) const {
  double height = plane(x, y) - thrown(x, y, z);
  if (params_.fold_height_m > 0) {
    const geom::Fbm shape = smooth(kFoldLength * params_.fold_wavelength_m);
    height += folded(x, y, geom::fbm(bends_, shape, x, y), geom::fbm(swells_, shape, x, y));
  }
  return height;
}

double Lithology::stretch(double x, double y) const {
  const double across = std::cos(radians(params_.dip_deg));
  if (!stretch_varies()) return across;
  const double noise = std::clamp(kThicknessGain * geom::fbm(thickness_, smooth(kThickness_m), x, y), -1.0, 1.0);
  return across / (1.0 + params_.thickness_variation * noise);
}

int Lithology::bed(double x, double y, double z) const { return beds_.at(static_cast<float>(depth(x, y, z))).index; }

double Lithology::hardness(double x, double y, double z) const {
  return beds_.at(static_cast<float>(depth(x, y, z))).hardness;
}

void Lithology::datum_row(const GridFrame& frame, int row, std::span<float> datum) const {
  std::vector<float> bends(datum.size()), swells(datum.size());
  if (params_.fold_height_m > 0) {
    const geom::Fbm shape = smooth(kFoldLength * params_.fold_wavelength_m);
    geom::fbm_row(bends_, shape, frame.x(0), frame.cell_m, frame.y(row), bends);
    geom::fbm_row(swells_, shape, frame.x(0), frame.cell_m, frame.y(row), swells);
  }
  for (size_t i = 0; i < datum.size(); ++i) {
    const double x = frame.x(static_cast<double>(i)), y = frame.y(row);
    datum[i] = static_cast<float>(plane(x, y) + folded(x, y, bends[i], swells[i]));
  }
}

void Lithology::stretch_row(const GridFrame& frame, int row, std::span<float> stretch) const {
  geom::fbm_row(thickness_, smooth(kThickness_m), frame.x(0), frame.cell_m, frame.y(row), stretch);
  const double across = std::cos(radians(params_.dip_deg));
  for (float& value : stretch) {
    const double noise = std::clamp(kThicknessGain * value, -1.0, 1.0);
    value = static_cast<float>(across / (1.0 + params_.thickness_variation * noise));
  }
}

}  // namespace seamount::erosion
