#include "seamount/ops/render/climate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace seamount::render {
namespace {

struct Knot {
  float latitude, value;
};

float between_knots(std::span<const Knot> knots, double latitude_deg) {
  const auto at = static_cast<float>(std::abs(latitude_deg));
  size_t i = 1;
  while (i + 1 < knots.size() && knots[i].latitude < at) ++i;
  const Knot &from = knots[i - 1], &to = knots[i];
  const float t = std::clamp((at - from.latitude) / (to.latitude - from.latitude), 0.0F, 1.0F);
  return from.value + t * (to.value - from.value);
}

// Means of the places in Wikipedia's list "Snow line" and "Tree line", where wet and dry ones differ their middle.
constexpr std::array kSnowLines = {Knot{0, 4750},  Knot{18, 5200}, Knot{28, 5800}, Knot{37, 4000}, Knot{47, 2850},
                                   Knot{62, 1700}, Knot{67, 1250}, Knot{78, 450},  Knot{90, 0}};
constexpr std::array kTreeLines = {Knot{0, 3900},  Knot{28, 4000}, Knot{37, 3000}, Knot{47, 2000},
                                   Knot{62, 1100}, Knot{67, 700},  Knot{73, 1},    Knot{90, 1}};
constexpr std::array kWarmth = {Knot{0, 26.5F}, Knot{15, 26.0F}, Knot{30, 20.0F}, Knot{45, 11.0F},
                                Knot{60, 2.5F}, Knot{75, -9.0F}, Knot{90, -18.0F}};
constexpr std::array kRain = {Knot{0, 2200}, Knot{20, 1900}, Knot{32, 1000}, Knot{45, 950},
                              Knot{60, 750}, Knot{75, 300},  Knot{90, 150}};

}  // namespace

float snow_line_at(double latitude_deg) { return between_knots(kSnowLines, latitude_deg); }
float tree_line_at(double latitude_deg) { return between_knots(kTreeLines, latitude_deg); }

Climate climate_of(const ClimateParams& params, const std::optional<double>& tree_line_m,
                   const std::optional<double>& snow_line_m, Rock rock, const Setting& setting) {
  const double latitude = params.latitude_deg.value_or(setting.in_sea ? -18.0 : 45.0);
  Climate climate;
  climate.latitude = static_cast<float>(latitude);
  climate.sea_level_c = between_knots(kWarmth, latitude);
  climate.low_m = static_cast<float>(std::max(0.0, setting.lowest_m));
  climate.rain_mm = static_cast<float>(params.rain_mm_yr.value_or(between_knots(kRain, latitude)));
  // Trade winds blow towards the equator and the west, westerlies towards the pole and the east.
  const double trade = latitude >= 0.0 ? 65.0 : 115.0, westerly = latitude >= 0.0 ? 250.0 : 290.0;
  const double from_deg = params.wind_from_deg.value_or(std::abs(latitude) < 30.0 ? trade : westerly);
  climate.wind_from = static_cast<float>(from_deg * std::numbers::pi / 180.0);
  climate.snow_line = static_cast<float>(snow_line_m.value_or(snow_line_at(latitude)));
  climate.tree_line = static_cast<float>(tree_line_m.value_or(tree_line_at(latitude)));
  const bool warm_sea = setting.in_sea && std::abs(latitude) < 30.0;
  climate.rock = rock != Rock::automatic ? rock : warm_sea ? Rock::basalt : Rock::granite;
  return climate;
}

}  // namespace seamount::render
