#include "seamount/recipe/moved_names.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

namespace seamount::recipe {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kNoFiles = {"outputs", "id", "op", "in", "about", "seamount"};

class Mover {
 public:
  Mover(fs::path from, fs::path to) : from_(std::move(from)), to_(std::move(to)) {}

  void move(OrderedJson& json) const {
    if (json.is_string()) {
      json = name(json.get<std::string>());
    } else if (json.is_array()) {
      for (OrderedJson& item : json) move(item);
    } else if (json.is_object()) {
      for (const auto& [key, member] : json.items()) {
        if (!skips(key)) move(member);
      }
    }
  }

  static bool skips(std::string_view key) { return std::find(kNoFiles.begin(), kNoFiles.end(), key) != kNoFiles.end(); }

 private:
  std::string name(const std::string& text) const {
    const fs::path path(text);
    std::error_code error;
    if (text.empty() || path.is_absolute() || !path.has_extension()) return text;
    if (!fs::is_regular_file(from_ / path, error)) return text;
    return (from_ / path).lexically_normal().lexically_relative(to_.lexically_normal()).generic_string();
  }

  fs::path from_, to_;
};

}  // namespace

OrderedJson seen_from(OrderedJson json, const std::string& pointer, const std::string& from, const std::string& to) {
  for (size_t begin = 0; begin < pointer.size();) {
    const size_t end = std::min(pointer.find('/', begin + 1), pointer.size());
    if (Mover::skips(std::string_view(pointer).substr(begin + 1, end - begin - 1))) return json;
    begin = end;
  }
  Mover(fs::absolute(from), fs::absolute(to)).move(json);
  return json;
}

}  // namespace seamount::recipe
