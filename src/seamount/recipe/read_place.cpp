#include "seamount/recipe/read_place.h"

namespace seamount::recipe {
namespace {

std::string shown(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  constexpr size_t kLongest = 40;
  if (text.size() > kLongest) text = text.substr(0, kLongest - 3) + "...";
  switch (json.type()) {
    case Json::value_t::null:
      return "nothing (null)";
    case Json::value_t::object:
      return "the object " + text;
    case Json::value_t::array:
      return "the list " + text;
    case Json::value_t::string:
      return "the text " + text;
    default:
      return text;
  }
}

}  // namespace

void ReadPlace::expected(const std::string& what, const Json& found) const {
  fail("expected " + what + ", found " + shown(found));
}

}  // namespace seamount::recipe
