// The climate that a picture's ground grows in: how warm and how wet it is, where trees end and snow stays. From the
// latitude, in round figures (tables of snow and tree lines, biomes and lapse rate: Körner 2012; Whittaker 1975, fig.
// 4.10), where nothing better is stated.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <tuple>

#include "seamount/base/fields.h"
#include "seamount/base/presets.h"

namespace seamount::render {

/// What bare rock looks like; granite also stands for gneiss and schist.
enum class Rock { automatic, granite, basalt, limestone, sandstone };

struct ClimateParams {
  std::optional<double> latitude_deg;
  std::optional<double> rain_mm_yr;
  std::optional<double> wind_from_deg;

  static constexpr auto fields() {
    using P = ClimateParams;
    return std::tuple(
        field(&P::latitude_deg, "latitude_deg", "deg", between(-90, 90),
              "latitude, which decides how warm it is; by default that of the terrain's place if it has one, else -18 "
              "in a sea and 45 inland"),
        field(&P::rain_mm_yr, "rain_mm_yr", "mm/yr", between(0, 15000),
              "rain in a year, mean over the land; below 250 a desert; by default as usual for the latitude"),
        field(&P::wind_from_deg, "wind_from_deg", "deg", between(-360, 360),
              "bearing that the wind brings rain from: windward slopes are wet, leeward ones dry; by default trade "
              "winds or westerlies by the latitude"));
  }

  static constexpr auto presets() {
    using P = ClimateParams;
    return std::array{preset<P>("tropical", "rain forest up to the clouds",
                                [](P& p) {
                                  p.latitude_deg = 8;
                                  p.rain_mm_yr = 5000;
                                }),
                      preset<P>("temperate", "meadows and woods, bare rock above, snow on high mountains",
                                [](P& p) {
                                  p.latitude_deg = 46;
                                  p.rain_mm_yr = 1100;
                                }),
                      preset<P>("arid", "bare rock and sand, hardly any green",
                                [](P& p) {
                                  p.latitude_deg = 27;
                                  p.rain_mm_yr = 90;
                                }),
                      preset<P>("polar", "tundra along the coast under ice and snow", [](P& p) {
                        p.latitude_deg = 82;
                        p.rain_mm_yr = 350;
                      })};
  }
};

/// What the ground's materials ask of a climate.
struct Climate {
  float latitude = 18.0F;
  float sea_level_c = 25.0F;  ///< mean of the year at the water's level
  float rain_mm = 2000.0F;    ///< mean over the land
  float wind_from = 1.2F;     ///< radians clockwise from north
  float tree_line = 3900.0F;  ///< metres over the water
  float snow_line = 5000.0F;
  Rock rock = Rock::granite;

  float low_m = 0.0F;  ///< lowest ground over the water: plateaus are warmer than peaks that stand as high

  float temperature(float z) const { return sea_level_c - 0.0030F * low_m - 0.0065F * (z - low_m); }
};

/// Height over the sea above which snow stays all year, and where forest ends: linear between measured latitudes.
float snow_line_at(double latitude_deg);
float tree_line_at(double latitude_deg);

/// What is not stated follows from where a terrain lies: in a sea or inland, and how high over the water its lowest
/// ground is.
struct Setting {
  bool in_sea = false;
  double lowest_m = 0.0;
};

Climate climate_of(const ClimateParams& params, const std::optional<double>& tree_line_m,
                   const std::optional<double>& snow_line_m, Rock rock, const Setting& setting);

}  // namespace seamount::render

template <>
struct seamount::Choices<seamount::render::Rock> {
  static constexpr std::array<std::string_view, 5> names = {"automatic", "granite", "basalt", "limestone", "sandstone"};
};
