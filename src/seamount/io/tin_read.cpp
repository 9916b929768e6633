#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <sstream>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/tin_file.h"
#include "seamount/io/vector_frame.h"

namespace seamount::io {
namespace {

constexpr size_t kMostItems = 100'000'000;

/// A property of an element, as its header line says.
struct Property {
  std::string name;
  std::string type;
  std::string count_type;  ///< of a list; empty: a plain value
};

struct Element {
  std::string name;
  size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  bool text = false;
  bool no_heights = false;
  std::vector<Element> elements;
  size_t body = 0;
};

size_t size_of(const std::string& type) {
  if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
  if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
  if (type == "int" || type == "uint" || type == "float" || type == "int32" || type == "uint32" || type == "float32")
    return 4;
  if (type == "double" || type == "float64") return 8;
  return 0;
}

/// The values of a PLY's body, one after another, as numbers.
class Values {
 public:
  Values(std::span<const uint8_t> body, bool text, const std::string& name) : body_(body), text_(text), name_(name) {}

  double next(const std::string& type) { return text_ ? word() : binary(type); }

  /// Throws unless `count` items of at least `least` bytes each can follow.
  void expect(size_t count, size_t least) const {
    if (count > kMostItems || count * least > body_.size() - at_)
      throw IoError(name_, "is truncated: it promises " + std::to_string(count) + " items and holds fewer");
  }

 private:
  template <class T>
  double plain() {
    if (body_.size() - at_ < sizeof(T)) throw IoError(name_, "is truncated");
    T value;
    std::memcpy(&value, body_.data() + at_, sizeof value);
    at_ += sizeof value;
    return static_cast<double>(value);
  }

  double binary(const std::string& type) {
    if (type == "float" || type == "float32") return plain<float>();
    if (type == "double" || type == "float64") return plain<double>();
    const bool is_signed = type.front() != 'u';
    switch (size_of(type)) {
      case 1:
        return is_signed ? plain<int8_t>() : plain<uint8_t>();
      case 2:
        return is_signed ? plain<int16_t>() : plain<uint16_t>();
      default:
        return is_signed ? plain<int32_t>() : plain<uint32_t>();
    }
  }

  double word() {
    const auto is_space = [](uint8_t c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
    while (at_ < body_.size() && is_space(body_[at_])) ++at_;
    const char* first = reinterpret_cast<const char*>(body_.data()) + at_;
    const char* last = reinterpret_cast<const char*>(body_.data()) + body_.size();
    double value = 0.0;
    const auto [end, error] = std::from_chars(first, last, value);
    if (error != std::errc() || first == last) throw IoError(name_, "is truncated, or holds something but numbers");
    at_ += static_cast<size_t>(end - first);
    return value;
  }

  std::span<const uint8_t> body_;
  bool text_;
  const std::string& name_;
  size_t at_ = 0;
};

void read_frame(std::istringstream& words, const std::string& name, Tin& tin) {
  std::string text;
  std::getline(words, text);
  const std::optional<GridFrame> frame = parse_frame(text);
  if (!frame) throw IoError(name, "has a damaged comment 'seamount frame'");
  const std::string crs = tin.frame.crs;
  tin.frame = *frame;
  tin.frame.crs = crs;
}

void read_region(std::istringstream& words, const std::string& name, Tin& tin) {
  TinRegion region;
  std::string height, form;
  words >> region.parent >> height >> form;
  double value = 0.0;
  const auto [end, error] = std::from_chars(height.data(), height.data() + height.size(), value);
  const bool number = error == std::errc() && end == height.data() + height.size() && std::isfinite(value);
  if (!words || (!number && height != "-") || (form != "basin" && form != "hill"))
    throw IoError(name, "has a damaged comment 'seamount region'");
  std::getline(words >> std::ws, region.name);
  if (number) region.height_m = value;
  region.basin = form == "basin";
  tin.regions.push_back(std::move(region));
}

void read_peak(std::istringstream& words, const std::string& name, Tin& tin) {
  double peak = 0.0;
  words >> peak;
  if (tin.regions.empty() || !words || !std::isfinite(peak))
    throw IoError(name, "has a damaged comment 'seamount peak'");
  tin.regions.back().peak_m = peak;
}

void read_outline(std::istringstream& words, const std::string& name, Tin& tin) {
  Ring outline;
  for (Vec2 p; words >> p.x >> p.y;) outline.push_back(p);
  const bool finite =
      std::all_of(outline.begin(), outline.end(), [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  if (tin.regions.empty() || !words.eof() || !finite) throw IoError(name, "has a damaged comment 'seamount outline'");
  tin.regions.back().outline = std::move(outline);
}

/// What write_tin() says of the frame and the regions; comments of other programs say nothing to us.
void read_comment(std::istringstream& words, Header& header, const std::string& name, Tin& tin) {
  std::string owner, kind;
  words >> owner >> kind;
  if (owner != "seamount") return;
  if (kind == "frame") read_frame(words, name, tin);
  if (kind == "crs") std::getline(words >> std::ws, tin.frame.crs);
  if (kind == "no") header.no_heights = true;
  if (kind == "region") read_region(words, name, tin);
  if (kind == "peak") read_peak(words, name, tin);
  if (kind == "outline") read_outline(words, name, tin);
}

void read_element(std::istringstream& words, Header& header, const std::string& name) {
  Element element;
  words >> element.name >> element.count;
  if (!words || element.count > kMostItems) throw IoError(name, "has a header line 'element' without a sensible count");
  header.elements.push_back(std::move(element));
}

void read_property(std::istringstream& words, Header& header, const std::string& name) {
  if (header.elements.empty()) throw IoError(name, "has a property before any element");
  Property property;
  words >> property.type;
  if (property.type == "list") words >> property.count_type >> property.type;
  words >> property.name;
  const bool known = size_of(property.type) > 0 && (property.count_type.empty() || size_of(property.count_type) > 0);
  if (!words || !known) throw IoError(name, "has a property of unknown type '" + property.type + "'");
  header.elements.back().properties.push_back(std::move(property));
}

Header read_header(std::span<const uint8_t> bytes, const std::string& name, Tin& tin) {
  Header header;
  size_t at = 0;
  for (int line_number = 0;; ++line_number) {
    const auto end = std::find(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end(), uint8_t{'\n'});
    if (end == bytes.end() || line_number > 100000) throw IoError(name, "is not a PLY, or its header is truncated");
    std::string line(bytes.begin() + static_cast<std::ptrdiff_t>(at), end);
    at = static_cast<size_t>(end - bytes.begin()) + 1;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line_number == 0 && line != "ply") throw IoError(name, "is not a PLY");
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "end_header") break;
    if (keyword == "comment") read_comment(words, header, name, tin);
    if (keyword == "element") read_element(words, header, name);
    if (keyword == "property") read_property(words, header, name);
    if (keyword == "format") {
      std::string format;
      words >> format;
      header.text = format == "ascii";
      if (!header.text && format != "binary_little_endian")
        throw IoError(name, "is a PLY of format '" + format + "'; ascii and binary_little_endian can be read");
    }
  }
  header.body = at;
  return header;
}

size_t least_bytes(const Element& element, bool text) {
  size_t bytes = 0;
  for (const Property& p : element.properties)
    bytes += text ? 1 : size_of(p.count_type.empty() ? p.type : p.count_type);
  return std::max<size_t>(1, bytes);
}

void read_vertices(const Element& element, Values& values, const std::string& name, bool heights, Tin& tin) {
  const auto has = [&](const char* wanted) {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const Property& p) { return p.name == wanted && p.count_type.empty(); });
  };
  if (!has("x") || !has("y") || !has("z")) throw IoError(name, "has vertices without x, y and z");
  tin.nodes.resize(element.count);
  if (heights) tin.height_m.resize(element.count);
  if (has("region")) tin.region.resize(element.count);
  if (has("rank")) tin.rank.resize(element.count);
  if (has("bed")) tin.bed_m.resize(element.count);
  for (size_t i = 0; i < element.count; ++i) {
    for (const Property& property : element.properties) {
      if (!property.count_type.empty()) throw IoError(name, "has lists in its vertices");
      const double value = values.next(property.type);
      if (!std::isfinite(value) || std::abs(value) > 1e9)
        throw IoError(name,
                      "has a vertex " + std::to_string(i) + " whose " + property.name + " is " + format_number(value));
      if (property.name == "x") tin.nodes[i].x = value;
      if (property.name == "y") tin.nodes[i].y = value;
      if (property.name == "z" && heights) tin.height_m[i] = static_cast<float>(value);
      if (property.name == "region") tin.region[i] = static_cast<int32_t>(value);
      if (property.name == "rank") tin.rank[i] = static_cast<float>(value);
      if (property.name == "bed") tin.bed_m[i] = value <= kNoBedInFiles ? Tin::kNoBed : static_cast<float>(value);
    }
  }
}

void read_faces(const Element& element, Values& values, const std::string& name, Tin& tin) {
  tin.triangles.reserve(element.count);
  for (size_t i = 0; i < element.count; ++i) {
    for (const Property& property : element.properties) {
      if (property.count_type.empty()) {
        values.next(property.type);
        continue;
      }
      const double corners = values.next(property.count_type);
      const bool indices = property.name == "vertex_indices" || property.name == "vertex_index";
      if (indices && corners != 3)
        throw IoError(name, "has a face " + std::to_string(i) + " of " + format_number(corners) +
                                " corners; only triangles can be read");
      std::array<int32_t, 3> triangle{};
      if (!(corners >= 0 && corners <= 255)) throw IoError(name, "has a list of " + format_number(corners) + " items");
      for (int c = 0; c < static_cast<int>(corners); ++c) {
        const double node = values.next(property.type);
        if (!indices) continue;
        if (!(node >= 0 && node < static_cast<double>(tin.nodes.size())))
          throw IoError(name, "has a face " + std::to_string(i) + " with a corner that is not there");
        triangle[static_cast<size_t>(c)] = static_cast<int32_t>(node);
      }
      if (!indices) continue;
      const Vec2 a = tin.nodes[static_cast<size_t>(triangle[0])];
      const Vec2 b = tin.nodes[static_cast<size_t>(triangle[1])], c = tin.nodes[static_cast<size_t>(triangle[2])];
      if (cross(b - a, c - a) < 0) std::swap(triangle[1], triangle[2]);
      tin.triangles.push_back(triangle);
    }
  }
}

/// Regions without their per-node index, or the other way round, are not a grown network.
void check_regions(Tin& tin, const std::string& name) {
  if (tin.regions.empty() || tin.region.empty()) {
    tin.regions.clear();
    tin.region.clear();
    tin.rank.clear();
    tin.bed_m.clear();
    return;
  }
  for (size_t i = 0; i < tin.regions.size(); ++i) {
    if (tin.regions[i].parent < -1 || tin.regions[i].parent >= static_cast<int>(i))
      throw IoError(name, "has a region " + std::to_string(i) + " whose parent does not stand before it");
  }
  const auto most = static_cast<int32_t>(tin.regions.size());
  for (size_t i = 0; i < tin.region.size(); ++i) {
    if (tin.region[i] < Tin::kOutside || tin.region[i] >= most)
      throw IoError(name, "has a vertex " + std::to_string(i) + " in a region that is not there");
  }
}

}  // namespace

Tin read_tin(std::span<const uint8_t> bytes, const std::string& name) {
  Tin tin;
  const Header header = read_header(bytes, name, tin);
  Values values(bytes.subspan(header.body), header.text, name);
  bool vertices = false;
  for (const Element& element : header.elements) {
    values.expect(element.count, least_bytes(element, header.text));
    if (element.name == "vertex") {
      read_vertices(element, values, name, !header.no_heights, tin);
      vertices = true;
    } else if (element.name == "face") {
      if (!vertices) throw IoError(name, "has faces before its vertices");
      read_faces(element, values, name, tin);
    } else {
      throw IoError(name, "has elements '" + element.name + "'; only vertices and faces can be read");
    }
  }
  if (tin.triangles.empty()) throw IoError(name, "has no triangles");
  check_regions(tin, name);
  return tin;
}

Tin read_tin(const std::string& path) {
  check_readable(path);
  return read_tin(read_file(path), path);
}

}  // namespace seamount::io
