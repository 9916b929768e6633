#include "seamount/io/vector_heights.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "seamount/base/text.h"

namespace seamount::io {
namespace {

/// Likely ones first; without separators, in lower case. The last ones often mean something else.
constexpr std::array kHeightNames = {"value",
                                     "height",
                                     "elevation",
                                     "elev",
                                     "ele",
                                     "contour",
                                     "contours",
                                     "altitude",
                                     "alt",
                                     "hoehe",
                                     "höhe",
                                     "hohe",
                                     "höhenlinie",
                                     "hoehenlini",
                                     "cota",
                                     "quota",
                                     "kote",
                                     "kota",
                                     "zvalue",
                                     "contourelevation",
                                     "contourele",
                                     "contourelev",
                                     "elevcontour",
                                     "contourheight",
                                     "contourvalue",
                                     "contourval",
                                     "contourlevel",
                                     "elevvalue",
                                     "heightvalue",
                                     "propvalue",
                                     "propertyvalue",
                                     "isohypse",
                                     "isovalue",
                                     "altura",
                                     "altitud",
                                     "hauteur",
                                     "elevacion",
                                     "elevación",
                                     "elevação",
                                     "elevacao",
                                     "hoyde",
                                     "høyde",
                                     "höjd",
                                     "hojd",
                                     "korkeus",
                                     "magassag",
                                     "magasság",
                                     "vyska",
                                     "výška",
                                     "wysokosc",
                                     "rzedna",
                                     "equidistan",
                                     "visina",
                                     "courbe",
                                     "curva",
                                     "hgt",
                                     "spotheight",
                                     "zcoord",
                                     "zelev",
                                     "level",
                                     "niveau",
                                     "nivel",
                                     "z"};

constexpr double kFoot = 0.3048;
constexpr double kSurveyFoot = 1200.0 / 3937.0;

struct Unit {
  const char* name;
  double metres;
};
constexpr std::array kUnits = {Unit{"m", 1.0},
                               Unit{"meter", 1.0},
                               Unit{"meters", 1.0},
                               Unit{"metre", 1.0},
                               Unit{"metres", 1.0},
                               Unit{"mtr", 1.0},
                               Unit{"mts", 1.0},
                               Unit{"masl", 1.0},
                               Unit{"müm", 1.0},
                               Unit{"ft", kFoot},
                               Unit{"feet", kFoot},
                               Unit{"foot", kFoot},
                               Unit{"usft", kSurveyFoot},
                               Unit{"ftus", kSurveyFoot},
                               Unit{"usfeet", kSurveyFoot},
                               Unit{"km", 1000.0},
                               Unit{"dm", 0.1},
                               Unit{"cm", 0.01},
                               Unit{"mm", 0.001}};

std::optional<double> find_unit(std::string_view name) {
  for (const Unit& unit : kUnits)
    if (name == unit.name) return unit.metres;
  return std::nullopt;
}

std::optional<int> find_base(std::string_view base) {
  for (size_t i = 0; i < kHeightNames.size(); ++i)
    if (base == kHeightNames[i]) return static_cast<int>(i);
  return std::nullopt;
}

/// The words of a name, split at what is neither letter nor digit; bytes of UTF-8 are letters.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || byte >= 0x80)
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::string joined(const std::vector<std::string>& words, size_t count) {
  std::string text;
  for (size_t i = 0; i < count; ++i) text += words[i];
  return text;
}

bool is_reference(const std::string& word) { return word == "asl" || word == "amsl" || word == "msl" || word == "nn"; }

bool may_hold_heights(const OGRFieldDefn& field) {
  const OGRFieldType type = field.GetType();
  return type == OFTReal || type == OFTInteger || type == OFTInteger64 || type == OFTString;
}

}  // namespace

std::string lower_case(std::string text) {
  for (size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte >= 'A' && byte <= 'Z') text[i] = static_cast<char>(byte + ('a' - 'A'));
    const auto before = static_cast<unsigned char>(i > 0 ? text[i - 1] : 0);
    if (before == 0xC3 && byte >= 0x80 && byte <= 0x9E && byte != 0x97) text[i] = static_cast<char>(byte + 0x20);
  }
  return text;
}

std::optional<HeightName> parse_height_name(std::string_view name) {
  std::vector<std::string> words = words_of(lower_case(std::string(name)));
  while (words.size() > 1 && is_reference(words.back())) words.pop_back();
  if (words.empty()) return std::nullopt;
  if (const auto rank = find_base(joined(words, words.size()))) return HeightName{*rank, 1.0, false};
  for (size_t tail = 1; tail <= 2 && tail < words.size(); ++tail) {
    std::string unit;
    for (size_t i = words.size() - tail; i < words.size(); ++i) unit += words[i];
    const auto metres = find_unit(unit);
    const auto rank = find_base(joined(words, words.size() - tail));
    if (metres && rank) return HeightName{*rank, *metres, true};
  }
  if (words.size() != 1) return std::nullopt;
  for (const Unit& unit : kUnits) {  // "elevft"
    const std::string_view word = words[0];
    if (!word.ends_with(unit.name)) continue;
    const std::string_view base = word.substr(0, word.size() - std::string_view(unit.name).size());
    const auto rank = find_base(base);
    if (rank && base.size() >= 3) return HeightName{*rank, unit.metres, true};
  }
  return std::nullopt;
}

std::optional<double> parse_height(std::string_view text, double unit_m) {
  const auto trim = [](std::string_view t) {
    while (!t.empty() && (t.front() == ' ' || t.front() == '\t')) t.remove_prefix(1);
    while (!t.empty() && (t.back() == ' ' || t.back() == '\t' || t.back() == '.')) t.remove_suffix(1);
    return t;
  };
  text = trim(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  std::string number(text.substr(0, 64));
  const size_t comma = number.find(',');
  if (comma != std::string::npos) {
    size_t digits = 0;
    while (comma + 1 + digits < number.size() && number[comma + 1 + digits] >= '0' && number[comma + 1 + digits] <= '9')
      ++digits;
    // "1,250" may be either.
    if (digits == 0 || digits == 3 || number.find('.') != std::string::npos) return std::nullopt;
    number[comma] = '.';
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  const std::string unit = lower_case(std::string(trim(std::string_view(end, number.data() + number.size() - end))));
  if (unit.empty()) return value * unit_m;
  if (unit == "'") return value * kFoot;
  const auto metres = find_unit(unit);
  return metres ? std::optional(value * *metres) : std::nullopt;
}

std::vector<HeightField> height_fields(const OGRFeatureDefn& definition, const std::string& wanted,
                                       const GdalCall& call) {
  std::vector<std::pair<int, HeightField>> found;
  std::vector<std::string> names;
  for (int i = 0; i < definition.GetFieldCount(); ++i) {
    const OGRFieldDefn& field = *definition.GetFieldDefn(i);
    const std::string name = field.GetNameRef();
    names.push_back(name);
    const auto told = parse_height_name(name);
    if (!wanted.empty() && lower_case(name) == lower_case(wanted)) return {{i, told ? told->unit_m : 1.0, name}};
    if (wanted.empty() && told && may_hold_heights(field)) {
      const bool other_unit = told->unit_given && told->unit_m != 1.0;  // metres go before feet of the same name
      found.emplace_back(4 * told->rank + (other_unit         ? 2
                                           : told->unit_given ? 0
                                                              : 1),
                         HeightField{i, told->unit_m, name});
    }
  }
  if (!wanted.empty()) call.fail("has no field '" + wanted + "'" + suggestion(wanted, names));
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<HeightField> fields;
  for (auto& [rank, field] : found) fields.push_back(std::move(field));
  return fields;
}

std::optional<double> height_in(const OGRFeature& feature, const HeightField& field) {
  if (feature.IsFieldSetAndNotNull(field.index) == 0) return std::nullopt;
  if (feature.GetFieldDefnRef(field.index)->GetType() == OFTString)
    return parse_height(feature.GetFieldAsString(field.index), field.unit_m);
  const double value = feature.GetFieldAsDouble(field.index);
  return std::isfinite(value) ? std::optional(value * field.unit_m) : std::nullopt;
}

std::string field_list(const OGRFeatureDefn& definition) {
  constexpr int kMost = 30;
  std::string list;
  for (int i = 0; i < std::min(definition.GetFieldCount(), kMost); ++i)
    list += (i == 0 ? "" : ", ") + std::string(definition.GetFieldDefn(i)->GetNameRef());
  if (definition.GetFieldCount() > kMost) list += ", ...";
  return list.empty() ? "none" : list;
}

}  // namespace seamount::io
