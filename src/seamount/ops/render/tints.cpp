#include "seamount/ops/render/tints.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>

#include "seamount/model/label_map.h"

namespace seamount::render {
namespace {

/// A knot of a ramp: its place in [0, 1] and its sRGB colour.
struct Stop {
  float place;
  Colour colour;
};

// Lightness (Oklab): 0.93 at the shore, falls to 0.80 in the lowlands within a tenth of the relief, then rises again to
// 0.95 on the peaks.
constexpr std::array kLand = {Stop{0.00F, {233, 232, 206}}, Stop{0.05F, {196, 208, 168}}, Stop{0.16F, {178, 194, 150}},
                              Stop{0.30F, {201, 205, 160}}, Stop{0.45F, {222, 211, 168}}, Stop{0.60F, {214, 191, 150}},
                              Stop{0.75F, {199, 173, 143}}, Stop{0.88F, {214, 200, 184}}, Stop{1.00F, {243, 240, 236}}};
// Lightness falls by about 0.07 a knot.
constexpr std::array kSea = {Stop{0.00F, {233, 232, 206}}, Stop{0.07F, {196, 228, 214}}, Stop{0.20F, {157, 214, 211}},
                             Stop{0.36F, {115, 188, 204}}, Stop{0.54F, {79, 154, 189}},  Stop{0.72F, {55, 118, 165}},
                             Stop{0.87F, {40, 86, 135}},   Stop{1.00F, {27, 58, 101}}};

constexpr double kKneeDepth = 12.0;  // metres: depths well below it are scaled linearly, well above by the logarithm
constexpr int kTableSize = 2048;

Rgb ramp_colour(std::span<const Stop> stops, float place) {
  size_t i = 1;
  while (i + 1 < stops.size() && stops[i].place < place) ++i;
  const Stop &from = stops[i - 1], &to = stops[i];
  return mix_perceptual(linear(from.colour), linear(to.colour),
                        clamp01((place - from.place) / (to.place - from.place)));
}

double round_up_nice(double x) {
  const double step = round_down_nice(x) / 10.0;
  return std::ceil(x / (2.0 * step) - 1e-9) * 2.0 * step;
}

}  // namespace

double round_down_nice(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x) + 1e-12));
  const double mantissa = x / power;
  return (mantissa >= 5.0 - 1e-9 ? 5.0 : mantissa >= 2.0 - 1e-9 ? 2.0 : 1.0) * power;
}

TintScale::TintScale(double lowest_m, double highest_m)
    : TintScale(std::min(0.0, lowest_m), highest_m > 0.0 ? std::max(0.0, lowest_m) : INFINITY, highest_m) {}

TintScale::TintScale(double lowest_sea_m, double lowest_land_m, double highest_m) {
  if (highest_m > 0.0 || lowest_land_m < 0.0) {
    if (lowest_land_m < 0.0)
      base_m_ = -round_up_nice(std::max(1.0, -lowest_land_m));
    else if (lowest_land_m > 0.35 * highest_m)
      base_m_ = lowest_land_m;
    top_m_ = base_m_ > 0.0 ? std::max(highest_m, base_m_ + 1.0) : round_up_nice(std::max(1.0, highest_m));
  }
  if (lowest_sea_m < 0.0) deepest_m_ = round_up_nice(std::max(1.0, -lowest_sea_m));
  sea_share_ = !has_sea() ? 0.0 : !has_land() ? 1.0 : 0.5;
  if (!has_sea() && !has_land()) top_m_ = 1.0;
  table_.resize(kTableSize);
  for (int i = 0; i < kTableSize; ++i) {
    const double place = i / (kTableSize - 1.0);
    table_[static_cast<size_t>(i)] =
        place < sea_share_ ? ramp_colour(kSea, static_cast<float>(1.0 - place / sea_share_))
                           : ramp_colour(kLand, static_cast<float>((place - sea_share_) / (1.0 - sea_share_ + 1e-12)));
  }
}

double TintScale::bar_place(double height_m, bool land) const {
  if (height_m < 0.0 && has_sea() && !land) {
    const double depth = std::min(1.0, std::log1p(-height_m / kKneeDepth) / std::log1p(deepest_m_ / kKneeDepth));
    return sea_share_ * (1.0 - depth);
  }
  const double up = std::clamp((height_m - base_m_) / std::max(1e-9, top_m_ - base_m_), 0.0, 1.0);
  return has_land() || !has_sea() ? sea_share_ + (1.0 - sea_share_) * up : sea_share_;
}

double TintScale::bar_height(double place) const {
  if (place < sea_share_) {
    return -kKneeDepth * std::expm1((1.0 - place / sea_share_) * std::log1p(deepest_m_ / kKneeDepth));
  }
  return base_m_ + (top_m_ - base_m_) * (place - sea_share_) / std::max(1e-12, 1.0 - sea_share_);
}

Rgb TintScale::bar_tint(double place) const {
  const double at = place * (kTableSize - 1);
  const auto i = static_cast<size_t>(std::clamp(at, 0.0, kTableSize - 2.0));
  return mix(table_[i], table_[i + 1], static_cast<float>(at - static_cast<double>(i)));
}

Rgb TintScale::tint(float height_m, bool land) const { return bar_tint(bar_place(height_m, land)); }

std::vector<TintScale::Tick> TintScale::ticks(double gap) const {
  std::vector<Tick> result;
  if (has_sea()) {
    // Round depths of 1, 2, 5 steps from the deepest up, as long as they do not crowd.
    for (double depth = round_down_nice(deepest_m_); depth >= 1.0; depth = round_down_nice(depth * 0.999)) {
      const double place = bar_place(-depth);
      if (!result.empty() && place - result.back().place < gap) continue;
      if (sea_share_ - place < gap) break;
      result.push_back({-depth, place});
    }
    result.push_back({0.0, sea_share_});
  }
  if (has_land() || !has_sea()) {
    const double least = gap * (top_m_ - base_m_) / (1.0 - sea_share_);
    double step = round_down_nice(std::max(1e-3, least));
    if (step < least) step = round_down_nice(step * 2.5) >= least ? round_down_nice(step * 2.5) : step * 5.0;
    const double apart = 0.5 * step * (1.0 - sea_share_) / (top_m_ - base_m_);
    for (double h = std::ceil(base_m_ / step) * step; h <= top_m_ + 1e-9; h += step) {
      const double place = bar_place(h, true);
      if (result.empty() || place > result.back().place + apart) result.push_back({h, place});
    }
  }
  return result;
}

Rgb lake_tint(float depth_m) {
  constexpr double kDeep = 400.0;
  const double depth =
      std::log1p(static_cast<double>(std::max(0.0F, depth_m)) / kKneeDepth) / std::log1p(kDeep / kKneeDepth);
  return ramp_colour(kSea, static_cast<float>(0.12 + 0.6 * std::min(1.0, depth)));
}

Rgb region_colour(int region) {
  static const std::array<Rgb, kRegionCount> colours = {linear(Colour{139, 152, 104}), linear(Colour{236, 217, 165}),
                                                        linear(Colour{126, 205, 200}), linear(Colour{224, 138, 112}),
                                                        linear(Colour{62, 108, 156})};
  return colours[static_cast<size_t>(std::clamp(region, 0, kRegionCount - 1))];
}

std::string height_text(double height_m) {
  std::string digits = fmt::format("{:.6g}", std::abs(height_m));  // multiples of a step, but for rounding
  const size_t point = digits.find_first_of(".e");
  for (size_t i = point == std::string::npos ? digits.size() : point; i > 3; i -= 3) {
    digits.insert(i - 3, "\u2009");  // thin space between thousands
  }
  return height_m < 0.0 ? "\u2212" + digits : digits;
}

}  // namespace seamount::render
