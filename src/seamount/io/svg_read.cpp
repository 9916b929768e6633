#include "seamount/io/svg_read.h"

#include <cpl_minixml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <string_view>

#include "seamount/base/error.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/svg_path.h"
#include "seamount/io/vector_frame.h"

namespace seamount::io {
namespace {

constexpr size_t kMostPoints = 50'000'000;

struct TreeDeleter {
  void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};
using Tree = std::unique_ptr<CPLXMLNode, TreeDeleter>;

/// "svg" of "svg:svg".
std::string_view local_name(const char* name) {
  const std::string_view whole = name;
  const size_t colon = whole.rfind(':');
  return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

std::optional<std::string> attribute(const CPLXMLNode& element, std::string_view name) {
  for (const CPLXMLNode* child = element.psChild; child != nullptr; child = child->psNext)
    if (child->eType == CXT_Attribute && name == child->pszValue)
      return child->psChild != nullptr ? child->psChild->pszValue : "";
  return std::nullopt;
}

/// The value of a property in a style: "none" of "stroke:#000;fill:none".
std::optional<std::string> style_property(const std::string& style, std::string_view name) {
  for (size_t at = 0; at < style.size();) {
    const size_t end = std::min(style.find(';', at), style.size());
    std::string_view item = std::string_view(style).substr(at, end - at);
    while (item.starts_with(' ')) item.remove_prefix(1);
    const size_t colon = item.find(':');
    if (colon != std::string_view::npos && item.substr(0, colon) == name) {
      std::string value(item.substr(colon + 1));
      std::erase(value, ' ');
      return value;
    }
    at = end + 1;
  }
  return std::nullopt;
}

std::optional<double> number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

double length_of(const CPLXMLNode& element, std::string_view name) {
  const auto text = attribute(element, name);
  if (!text) return 0.0;
  const auto value = number(*text);
  if (!value) throw InvalidArgument(std::string(name), "'" + text->substr(0, 40) + "' is not a number");
  return *value;
}

bool holds(const Ring& ring, Vec2 p) {
  bool inside = false;
  for (size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 a = ring[i], b = ring[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

/// Rings as polygons by the even-odd rule, in the order of their outer rings.
std::vector<Polygon> nest_rings(std::vector<Ring> rings) {
  std::vector<std::vector<size_t>> around(rings.size());
  for (size_t i = 0; i < rings.size(); ++i) {
    const Vec2 inner = 0.5 * (rings[i][0] + rings[i][1]);
    for (size_t j = 0; j < rings.size(); ++j)
      if (i != j && holds(rings[j], inner)) around[i].push_back(j);
  }
  std::vector<Polygon> polygons;
  std::vector<size_t> polygon_of(rings.size(), rings.size());
  for (size_t i = 0; i < rings.size(); ++i) {
    if (around[i].size() % 2 != 0) continue;
    polygon_of[i] = polygons.size();
    polygons.push_back({std::move(rings[i]), {}});
  }
  for (size_t i = 0; i < rings.size(); ++i) {
    if (around[i].size() % 2 == 0) continue;
    for (const size_t outer : around[i])
      if (around[outer].size() + 1 == around[i].size() && polygon_of[outer] < polygons.size())
        polygons[polygon_of[outer]].holes.push_back(std::move(rings[i]));
  }
  return polygons;
}

class SvgReader {
 public:
  explicit SvgReader(const GdalCall& call) : call_(call) {}

  void read_root(const CPLXMLNode& root) {
    if (const auto frame = attribute(root, "data-seamount-frame")) {
      svg_.drawing.frame = parse_frame(*frame);
      if (!svg_.drawing.frame) call_.fail("has a damaged attribute data-seamount-frame");
    }
    svg_.crs = attribute(root, "data-seamount-crs").value_or("");
    svg_.ours = svg_.drawing.frame || attribute(root, "data-seamount-crs").has_value();
    read_children(root, {1, 0, 0, -1, 0, 0}, true, 0);
  }

  SvgDrawing& result() { return svg_; }

 private:
  void read_children(const CPLXMLNode& element, const SvgMatrix& matrix, bool filled, int depth) {
    constexpr int kDeepest = 200;
    if (depth > kDeepest) call_.fail("its elements are nested too deeply");
    for (const CPLXMLNode* child = element.psChild; child != nullptr; child = child->psNext)
      if (child->eType == CXT_Element) read_element(*child, matrix, filled, depth + 1);
  }

  void read_element(const CPLXMLNode& element, const SvgMatrix& outer, bool filled, int depth) {
    const std::string_view name = local_name(element.pszValue);
    try {
      SvgMatrix matrix = outer;
      if (const auto text = attribute(element, "transform")) matrix = outer.after(parse_svg_transform(*text));
      std::optional<std::string> fill = attribute(element, "fill");
      if (const auto style = attribute(element, "style"))
        if (const auto own = style_property(*style, "fill")) fill = own;
      if (fill && *fill != "inherit") filled = *fill != "none" && *fill != "transparent";
      if (name == "g" || name == "svg" || name == "a" || name == "switch")
        return read_children(element, matrix, filled, depth);
      std::vector<SvgChain> chains = chains_of(element, name);
      if (!chains.empty()) add(element, std::move(chains), matrix, filled);
    } catch (const InvalidArgument& error) {
      const std::string id = attribute(element, "id").value_or("");
      call_.fail("its " + std::string(name) + (id.empty() ? "" : " '" + id.substr(0, 60) + "'") + ": " + error.what());
    }
  }

  static std::vector<SvgChain> chains_of(const CPLXMLNode& element, std::string_view name) {
    if (name == "path") return parse_svg_path(attribute(element, "d").value_or(""));
    if (name == "polygon" || name == "polyline") {
      Polyline points = parse_svg_points(attribute(element, "points").value_or(""));
      if (points.empty()) return {};
      return {{std::move(points), name == "polygon"}};
    }
    const auto at = [&](const char* what) { return length_of(element, what); };
    if (name == "line") return {{{{at("x1"), at("y1")}, {at("x2"), at("y2")}}, false}};
    if (name == "rect") {
      const double x = at("x"), y = at("y"), w = at("width"), h = at("height");
      return {{{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, true}};
    }
    if (name != "circle" && name != "ellipse") return {};
    constexpr int kPoints = 64;
    const double rx = at(name == "circle" ? "r" : "rx"), ry = at(name == "circle" ? "r" : "ry");
    SvgChain chain{{}, true};
    for (int i = 0; i < kPoints; ++i) {
      const double angle = 2.0 * M_PI * i / kPoints;
      chain.points.push_back({at("cx") + rx * std::cos(angle), at("cy") + ry * std::sin(angle)});
    }
    return {std::move(chain)};
  }

  /// The numbers that an element carries, but for its value.
  static Attributes numbers_of(const CPLXMLNode& element, std::string_view value_name) {
    Attributes attributes;
    for (const CPLXMLNode* child = element.psChild; child != nullptr; child = child->psNext) {
      const std::string_view key = child->pszValue;
      if (child->eType != CXT_Attribute || !key.starts_with("data-") || key == value_name || child->psChild == nullptr)
        continue;
      const auto value = number(child->psChild->pszValue);
      if (!value || key == "data-name") continue;
      std::string name(key.substr(5));
      std::replace(name.begin(), name.end(), '-', '_');
      attributes.push_back({std::move(name), *value});
    }
    return attributes;
  }

  void add(const CPLXMLNode& element, std::vector<SvgChain> chains, const SvgMatrix& matrix, bool filled) {
    for (SvgChain& chain : chains) {
      total_ += chain.points.size();
      if (total_ > kMostPoints) call_.fail("has more than " + std::to_string(kMostPoints) + " points");
      for (Vec2& p : chain.points) {
        p = matrix(p);
        p = {p.x + 0.0, p.y + 0.0};
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw InvalidArgument("transform", "leads beyond all numbers");
      }
    }
    const auto name = attribute(element, "data-name");
    const auto height = attribute(element, "data-height-m");
    const auto value = height ? height : attribute(element, "data-value");
    const bool closed =
        std::all_of(chains.begin(), chains.end(), [](const SvgChain& c) { return c.closed && c.points.size() > 2; });
    if (name || (!value && filled && closed)) return add_area(element, std::move(chains), name);
    const std::optional<double> read = value ? number(*value) : std::nullopt;
    if (value && !read) throw InvalidArgument(height ? "data-height-m" : "data-value", "is not a number");
    const Attributes attributes = numbers_of(element, height ? "data-height-m" : "data-value");
    svg_.drawing.heights = svg_.drawing.heights || height.has_value();
    svg_.ours = svg_.ours || value.has_value();
    for (SvgChain& chain : chains) add_line(std::move(chain), read, attributes);
  }

  void add_area(const CPLXMLNode& element, std::vector<SvgChain> chains, const std::optional<std::string>& name) {
    NamedArea area{name ? *name : attribute(element, "inkscape:label").value_or(""), {}, numbers_of(element, "")};
    std::vector<Ring> rings;
    for (SvgChain& chain : chains) {
      chain.points.erase(std::unique(chain.points.begin(), chain.points.end()), chain.points.end());
      if (chain.points.size() > 1 && chain.points.front() == chain.points.back()) chain.points.pop_back();
      if (chain.points.size() > 2) rings.push_back(std::move(chain.points));
    }
    area.parts = nest_rings(std::move(rings));
    if (!area.parts.empty()) svg_.drawing.areas.push_back(std::move(area));
  }

  void add_line(SvgChain chain, std::optional<double> value, const Attributes& attributes) {
    Polyline& points = chain.points;
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() == 1) {  // a dot: a line without length and with a round end
      if (value) svg_.drawing.points.push_back({points[0], *value, attributes});
      return;
    }
    if (points.size() > 3 && points.front() == points.back()) points.pop_back(), chain.closed = true;
    if (!value && !svg_.without_value) svg_.without_value = "line " + std::to_string(svg_.drawing.lines.size());
    svg_.drawing.lines.push_back({std::move(points), value.value_or(0.0), chain.closed, attributes});
  }

  const GdalCall& call_;
  SvgDrawing svg_;
  size_t total_ = 0;
};

}  // namespace

SvgDrawing parse_svg(std::span<const uint8_t> bytes, const std::string& name) {
  const GdalCall call(name);
  if (bytes.size() > kMostSvgBytes) call.fail("is too large");
  const std::string text(bytes.begin(), bytes.end());
  if (text.find('\0') != std::string::npos) call.fail("is not an SVG text");
  const Tree tree(CPLParseXMLString(text.c_str()));
  call.check("is damaged, or not SVG");
  const CPLXMLNode* root = tree.get();
  while (root != nullptr && (root->eType != CXT_Element || local_name(root->pszValue) != "svg")) root = root->psNext;
  if (root == nullptr) call.fail("is not an SVG file");
  SvgReader reader(call);
  reader.read_root(*root);
  return std::move(reader.result());
}

}  // namespace seamount::io
