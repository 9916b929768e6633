#include "seamount/io/things_info.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/input_file.h"

namespace seamount::io {
namespace {

constexpr size_t kHead = 4096;  // bytes that tell what a file is

std::optional<FileInfo> describe_csv(const std::string& path) {
  constexpr std::string_view kStart = "name,shape,mesh,level,x,y,z,qx,qy,qz,qw,";
  if (!read_text(path, kHead).starts_with(kStart)) return std::nullopt;
  const auto bytes = read_file(path, uint64_t{1} << 30);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::set<std::string, std::less<>> shapes;
  size_t rows = 0;
  for (size_t at = text.find('\n'); at != std::string_view::npos && at + 1 < text.size();
       at = text.find('\n', at + 1)) {
    const std::string_view line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
    if (std::count(line.begin(), line.end(), ',') != std::count(text.begin(), text.begin() + text.find('\n'), ','))
      throw IoError(path, "row " + std::to_string(rows + 1) + " has not as many values as there are columns");
    const size_t first = line.find(','), second = line.find(',', first + 1);
    shapes.insert(std::string(line.substr(first + 1, second - first - 1)));
    ++rows;
  }
  return FileInfo{
      {"format", "placements (CSV)"}, {"things", std::to_string(rows)}, {"shapes", std::to_string(shapes.size())}};
}

std::optional<FileInfo> describe_json(const std::string& path) {
  const std::string head = read_text(path, kHead);
  if (head.find("\"engine\"") == std::string::npos || head.find("\"axes\"") == std::string::npos) return std::nullopt;
  try {
    const auto bytes = read_file(path, uint64_t{1} << 30);
    const auto json = nlohmann::json::parse(bytes);
    std::set<std::string> shapes;
    for (const auto& row : json.at("things")) shapes.insert(row.at(1).get<std::string>());
    return FileInfo{{"format", "placements (JSON)"},
                    {"for", json.at("engine").get<std::string>()},
                    {"axes", json.at("axes").get<std::string>() + ", in " + json.at("unit").get<std::string>()},
                    {"things", std::to_string(json.at("things").size())},
                    {"shapes", std::to_string(shapes.size())},
                    {"origin", format_number(json.at("origin_x_m").get<double>()) + " m, " +
                                   format_number(json.at("origin_y_m").get<double>()) + " m"}};
  } catch (const nlohmann::json::exception&) {
    throw IoError(path, "is a damaged table of placements");
  }
}

}  // namespace

std::optional<FileInfo> describe_placements(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".csv") return describe_csv(path);
  if (extension == ".json") return describe_json(path);
  return std::nullopt;
}

}  // namespace seamount::io
