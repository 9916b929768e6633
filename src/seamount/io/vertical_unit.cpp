#include "seamount/io/vertical_unit.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

namespace seamount::io {
namespace {

struct Unit {
  double metres;
  std::vector<std::string_view> names;  ///< letters and digits only, lower case
};

constexpr double kFoot = 0.3048;
constexpr double kSurveyFoot = 1200.0 / 3937.0;

const std::vector<Unit>& units() {
  static const std::vector<Unit> kUnits = {
      {1.0,
       {"m", "metre", "metres", "meter", "meters", "mtr", "mts", "metros", "metro", "metri", "m\xc3\xa8tre",
        "m\xc3\xa8tres", "mmsl", "masl", "metreabovesealevel", "metersabovesealevel"}},
      {kFoot,
       {"ft", "foot", "feet", "fut", "internationalfoot", "internationalfeet", "ftint", "footinternational", "fti",
        "ift"}},
      {kSurveyFoot,
       {"ussurveyfoot", "ussurveyfeet", "usft", "ftus", "surveyfoot", "surveyfeet", "sfoot", "footus", "usfoot",
        "usfeet", "footussurvey", "ussft", "sft", "ussurveyft"}},
      {1000.0, {"km", "kilometre", "kilometres", "kilometer", "kilometers"}},
      {0.1, {"dm", "decimetre", "decimetres", "decimeter", "decimeters"}},
      {0.01, {"cm", "centimetre", "centimetres", "centimeter", "centimeters"}},
      {0.001, {"mm", "millimetre", "millimetres", "millimeter", "millimeters"}},
      {3 * kFoot, {"yd", "yard", "yards"}},
      {6 * kFoot, {"fathom", "fathoms", "ftm", "fath"}},
      {kFoot / 12, {"in", "inch", "inches"}},
  };
  return kUnits;
}

}  // namespace

std::optional<double> metres_in_unit(std::string_view spelled) {
  std::string plain;
  for (const char c : spelled) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || byte >= 0x80) plain += static_cast<char>(std::tolower(byte));
  }
  for (const Unit& unit : units())
    if (std::find(unit.names.begin(), unit.names.end(), plain) != unit.names.end()) return unit.metres;
  return std::nullopt;
}

}  // namespace seamount::io
