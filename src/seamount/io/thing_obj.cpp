// Wavefront OBJ, as much of it as a model needs: v (with colours), vn, f, usemtl; of materials Kd and d.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <map>
#include <optional>

#include "seamount/base/error.h"
#include "seamount/base/printable.h"
#include "seamount/io/thing_parts.h"

namespace seamount::io {
namespace {

constexpr std::array<float, 3> kGrey = {0.35F, 0.33F, 0.30F};

/// Words of a line.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}
  std::string_view next() {
    const size_t from = rest_.find_first_not_of(" \t\r");
    if (from == std::string_view::npos) return rest_ = {};
    rest_.remove_prefix(from);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r"));
    rest_.remove_prefix(word.size());
    return word;
  }
  std::string_view rest() {
    const size_t from = rest_.find_first_not_of(" \t\r"), to = rest_.find_last_not_of(" \t\r");
    return from == std::string_view::npos ? std::string_view() : rest_.substr(from, to - from + 1);
  }

 private:
  std::string_view rest_;
};

template <class Visit>
void for_each_line(std::string_view text, Visit&& visit) {
  int number = 0;
  while (!text.empty()) {
    const size_t end = text.find('\n');
    visit(text.substr(0, end), ++number);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
}

std::optional<float> number(std::string_view word) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  float value = 0.0F;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || word.empty()) return std::nullopt;
  return value;
}

std::map<std::string, std::array<float, 3>, std::less<>> material_colours(std::string_view text) {
  std::map<std::string, std::array<float, 3>, std::less<>> colours;
  std::string name;
  for_each_line(text, [&](std::string_view line, int) {
    Words words(line);
    const std::string_view what = words.next();
    if (what == "newmtl") name = std::string(words.rest());
    if (what != "Kd" || name.empty()) return;
    std::array<float, 3> colour{};
    for (float& c : colour) c = number(words.next()).value_or(0.5F);
    colours[name] = colour;
  });
  return colours;
}

class Obj {
 public:
  Obj(const std::string& name, std::string_view materials)
      : name_(name), parts_(name), colours_(material_colours(materials)) {}

  void line(std::string_view text, int at) {
    at_ = at;
    Words words(text);
    const std::string_view what = words.next();
    if (what == "v") vertex(words);
    if (what == "vn") normals_.push_back(vector(words));
    if (what == "f") face(words);
    if (what == "usemtl") {
      const auto found = colours_.find(words.rest());
      colour_ = found == colours_.end() ? kGrey : found->second;
    }
  }
  ThingMesh mesh() const { return parts_.mesh(); }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw IoError(name_, fmt::format("line {}: {}", at_, problem));
  }

  std::array<float, 3> vector(Words& words) const {
    std::array<float, 3> made{};
    for (float& value : made) {
      const std::string_view word = words.next();
      const auto read = number(word);
      if (!read) fail("'" + printable(word.substr(0, 40)) + "' is no number");
      value = *read;
    }
    return made;
  }

  void vertex(Words& words) {
    places_.push_back(vector(words));
    std::array<float, 3> colour = {-1.0F, 0.0F, 0.0F};  // none
    std::array<std::optional<float>, 3> given;
    for (auto& value : given) value = number(words.next());
    if (given[0] && given[1] && given[2]) colour = {*given[0], *given[1], *given[2]};
    vertex_colours_.push_back(colour);
  }

  /// From 1, or from the end where it is negative.
  size_t index(std::string_view word, size_t count) const {
    long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      fail("'" + printable(word.substr(0, 40)) + "' is no index");
    if (value < 0) value += static_cast<long>(count) + 1;
    if (value < 1 || static_cast<size_t>(value) > count) fail(fmt::format("index {} of {}", word, count));
    return static_cast<size_t>(value) - 1;
  }

  ThingCorner corner(std::string_view word) const {
    const size_t slash = word.find('/'), second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
    ThingCorner made;
    const size_t at = index(word.substr(0, slash), places_.size());
    made.place = places_[at];
    made.colour = vertex_colours_[at][0] >= 0.0F ? vertex_colours_[at] : colour_;
    if (second != std::string_view::npos) made.normal = normals_[index(word.substr(second + 1), normals_.size())];
    return made;
  }

  void face(Words& words) {
    std::array<ThingCorner, 3> fan;
    int corners = 0;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      const ThingCorner next = corner(word);
      if (corners == 0) fan[0] = next;
      if (corners >= 2) {
        fan[1] = fan[2];
        fan[2] = next;
        parts_.triangle(fan, false);
      } else if (corners == 1) {
        fan[2] = next;
      }
      ++corners;
    }
    if (corners < 3) fail("a face of fewer than three corners");
  }

  std::string name_;
  ThingParts parts_;
  std::map<std::string, std::array<float, 3>, std::less<>> colours_;
  std::array<float, 3> colour_ = kGrey;
  std::vector<std::array<float, 3>> places_, normals_, vertex_colours_;
  int at_ = 0;
};

}  // namespace

std::string obj_materials(std::string_view text) {
  std::string name;
  for_each_line(text, [&](std::string_view line, int) {
    Words words(line);
    if (name.empty() && words.next() == "mtllib") name = std::string(words.rest());
  });
  return name;
}

ThingMesh obj_thing(std::string_view text, const std::string& name, std::string_view materials, const RunContext& run) {
  Obj obj(name, materials);
  for_each_line(text, [&](std::string_view line, int at) {
    if (at % 4096 == 0) run.check_cancelled();
    obj.line(line, at);
  });
  if (materials.find("map_Kd") != std::string_view::npos) run.say(name + ": its textures are not read, only colours");
  return obj.mesh();
}

}  // namespace seamount::io
