#include "seamount/io/sidecar.h"

#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/file_digest.h"

namespace seamount::io {
namespace {

using Json = nlohmann::ordered_json;

/// One member of the JSON object, with the file and its name in every complaint.
class Member {
 public:
  Member(const Json& object, std::string file) : object_(object), file_(std::move(file)) {}

  bool has(const char* key) const { return object_.contains(key) && !object_.at(key).is_null(); }

  double number(const char* key) const {
    if (!has(key) || !object_.at(key).is_number()) throw IoError(file_, std::string(key) + ": a number is needed");
    const double value = object_.at(key).get<double>();
    if (!std::isfinite(value)) throw IoError(file_, std::string(key) + ": is not finite");
    return value;
  }

  int size(const char* key) const {
    const double value = number(key);
    if (value < 1 || value > 1e6 || value != std::floor(value))
      throw IoError(file_, std::string(key) + ": a whole number in [1, 1000000] is needed");
    return static_cast<int>(value);
  }

  std::string text(const char* key) const {
    if (!has(key)) return {};
    if (!object_.at(key).is_string()) throw IoError(file_, std::string(key) + ": text is needed");
    return object_.at(key).get<std::string>();
  }

  const Json& at(const char* key) const { return object_.at(key); }

 private:
  const Json& object_;
  std::string file_;
};

GridFrame frame_from(const Member& member, const std::string& file) {
  GridFrame frame;
  frame.width = member.size("width");
  frame.height = member.size("height");
  frame.cell_m = member.number("cell_m");
  if (!(frame.cell_m > 0)) throw IoError(file, "cell_m: must be above 0");
  frame.west_m = member.has("west_m") ? member.number("west_m") : -0.5 * frame.width_m();
  frame.north_m = member.has("north_m") ? member.number("north_m") : 0.5 * frame.height_m();
  frame.crs = member.text("crs");
  return frame;
}

Sidecar sidecar_from(const Json& json, const std::string& file) {
  if (!json.is_object()) throw IoError(file, "is not a JSON object");
  const Member member(json, file);
  Sidecar sidecar;
  sidecar.ours = member.has("seamount");
  sidecar.frame = frame_from(member, file);
  sidecar.heights = member.text("quantity") != "field";
  // Those of fields bear no unit; earlier versions gave them metres too.
  const auto either = [&](const char* plain, const char* metres) {
    return !sidecar.heights && member.has(plain) ? plain : metres;
  };
  const char *min = either("min", "min_m"), *max = either("max", "max_m");
  const char *low = either("low", "low_m"), *high = either("high", "high_m");
  if (member.has(min)) sidecar.min_m = member.number(min);
  if (member.has(max)) sidecar.max_m = member.number(max);
  if (member.has(low) || member.has(high)) {
    sidecar.range = HeightRange{member.number(low), member.number(high)};
    if (!(sidecar.range->high_m > sidecar.range->low_m))
      throw IoError(file, std::string(high) + ": must be above " + low);
  }
  if (member.has("ground_width")) sidecar.ground_width = member.size("ground_width");
  if (member.has("ground_height")) sidecar.ground_height = member.size("ground_height");
  const std::string first_row = member.text("first_row");
  if (!first_row.empty() && first_row != "north" && first_row != "south")
    throw IoError(file, "first_row: '" + first_row + "' is neither 'north' nor 'south'");
  sidecar.south_first = first_row == "south";
  sidecar.target = member.text("target");
  if (member.has("import") && member.at("import").is_object()) {
    for (const auto& [place, value] : member.at("import").items())
      sidecar.import.emplace_back(place, value.is_string() ? value.get<std::string>() : value.dump());
  }
  sidecar.provenance.program = member.text("program");
  sidecar.provenance.recipe = member.text("recipe");
  if (member.has("seed") && member.at("seed").is_number_unsigned())
    sidecar.provenance.seed = member.at("seed").get<uint64_t>();
  return sidecar;
}

/// The side-car of a raster, whose digest is computed if the side-car has one.
std::optional<Sidecar> read_for(const std::string& raster_path, const std::function<Digest()>& digest) {
  constexpr uint64_t kMostBytes = 1 << 20;
  const std::string file = sidecar_path(raster_path);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  const std::vector<uint8_t> bytes = read_file(file, kMostBytes);
  const Json json = Json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (json.is_discarded()) throw IoError(file, "is not valid JSON");
  Sidecar sidecar = sidecar_from(json, file);
  const std::string known = Member(json, file).text("digest");
  if (!known.empty() && known != digest().hex())
    throw IoError(file, "does not belong to the '" + std::filesystem::path(raster_path).filename().string() +
                            "' that is there; run again what wrote the two, or delete this file; if you changed the "
                            "raster by hand and the numbers still hold, take \"digest\" out of it");
  return sidecar;
}

}  // namespace

std::string sidecar_path(const std::string& raster_path) { return raster_path + ".json"; }

void write_sidecar(const Sidecar& sidecar, const std::string& raster_path) {
  Json json;
  json["seamount"] = "raster";
  json["file"] = std::filesystem::path(raster_path).filename().string();
  if (!sidecar.for_painting) json["digest"] = content_digest(raster_path).hex();
  json["width"] = sidecar.frame.width;
  json["height"] = sidecar.frame.height;
  json["cell_m"] = sidecar.frame.cell_m;
  json["west_m"] = sidecar.frame.west_m;
  json["north_m"] = sidecar.frame.north_m;
  if (!sidecar.frame.crs.empty()) json["crs"] = sidecar.frame.crs;
  json["quantity"] = sidecar.heights ? "height" : "field";
  if (sidecar.heights) json["vertical_datum"] = "sea level is 0 m, up is positive";
  const auto name = [&](const char* plain, const char* metres) { return sidecar.heights ? metres : plain; };
  json[name("min", "min_m")] = sidecar.min_m;
  json[name("max", "max_m")] = sidecar.max_m;
  if (sidecar.range) {
    json[name("low", "low_m")] = sidecar.range->low_m;
    json[name("high", "high_m")] = sidecar.range->high_m;
  }
  if (sidecar.ground_width > 0) json["ground_width"] = sidecar.ground_width;
  if (sidecar.ground_height > 0) json["ground_height"] = sidecar.ground_height;
  json["first_row"] = sidecar.south_first ? "south" : "north";
  json["byte_order"] = extension_of(raster_path) == ".png" ? "as PNG" : "little endian";
  if (!sidecar.target.empty()) json["target"] = sidecar.target;
  for (const auto& [place, value] : sidecar.import) json["import"][place] = value;
  if (!sidecar.provenance.program.empty()) json["program"] = sidecar.provenance.program;
  if (!sidecar.provenance.recipe.empty()) json["recipe"] = sidecar.provenance.recipe;
  if (sidecar.provenance.seed) json["seed"] = *sidecar.provenance.seed;
  write_text(sidecar_path(raster_path), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<Sidecar> read_sidecar(const std::string& raster_path, std::span<const uint8_t> raster) {
  return read_for(raster_path, [&] { return hash_bytes(std::as_bytes(raster)); });
}

std::optional<Sidecar> read_sidecar(const std::string& raster_path) {
  return read_for(raster_path, [&] { return content_digest(raster_path); });
}

}  // namespace seamount::io
