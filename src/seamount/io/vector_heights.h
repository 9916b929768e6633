// Which field of a layer holds heights, and what its values are in metres. Not part of the public interface.
//
// Names in any letter case and with a unit: height_m, elevation, elev, ele, ELEV_FT, contour, CONTOUR, hoehe, altitude,
// alt, cota, quota, kote, z_value, level, z ...
#pragma once

#include <ogr_feature.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "seamount/io/gdal_call.h"

namespace seamount::io {

/// What a field's name says: how likely it is a height (0 is the most likely), and the metres in one unit of it.
struct HeightName {
  int rank = 0;
  double unit_m = 1.0;
  bool unit_given = false;
};
std::optional<HeightName> parse_height_name(std::string_view name);

/// "120", "120,5 m", "394 ft": metres, the unit of the text before `unit_m`. Nothing for anything else.
std::optional<double> parse_height(std::string_view text, double unit_m);

/// A field that may hold heights.
struct HeightField {
  int index = -1;
  double unit_m = 1.0;
  std::string name;
};

/// The field called `wanted` (any letter case) alone, or those whose names mean a height, likely ones first. Throws
/// IoError for one that is not there.
std::vector<HeightField> height_fields(const OGRFeatureDefn& definition, const std::string& wanted,
                                       const GdalCall& call);

/// The height in metres that a feature has in it.
std::optional<double> height_in(const OGRFeature& feature, const HeightField& field);

/// "ID, ELEV, note", "none": for messages.
std::string field_list(const OGRFeatureDefn& definition);

/// ASCII and Latin-1 letters of UTF-8 in lower case.
std::string lower_case(std::string text);

}  // namespace seamount::io
