// Drawings as SVG (vector.h), in what every renderer knows: paths, and stroke widths in the picture's own units.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "seamount/base/text.h"
#include "seamount/io/vector_chains.h"
#include "seamount/io/vector_frame.h"

namespace seamount::io {
namespace {

constexpr double kPixels = 1000.0;      ///< of the longer side, for programs that want a size
constexpr double kStroke = 1.0 / 1000;  ///< of the longer side
constexpr double kDot = 4.0 / 1000;

void append_path(std::string& text, const std::vector<Vec2>& points, bool close) {
  for (size_t i = 0; i < points.size(); ++i) {
    text += i == 0 ? "M" : "L";
    append_decimal(text, points[i].x, 3);
    text += ' ';
    append_decimal(text, -points[i].y, 3);
  }
  if (close) text += 'Z';
}

/// " data-width-m=\"12.5\"" for each attribute; letters that XML names cannot have become hyphens.
std::string svg_data(const Attributes& attributes) {
  std::string text;
  for (const Attribute& attribute : attributes) {
    text += " data-";
    for (const char c : attribute.name) {
      const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
      text += plain ? c : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : '-';
    }
    text += "=\"" + format_number(attribute.value) + '"';
  }
  return text;
}

struct View {
  double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
  double longer() const { return std::max({x1 - x0, y1 - y0, 1e-3}); }
};

/// The frame, so that the picture lies over the terrain, else all places with a margin.
View view_of(const Drawing& drawing) {
  View view;
  if (drawing.frame)
    return {drawing.frame->west_m, drawing.frame->east_m(), drawing.frame->south_m(), drawing.frame->north_m};
  const auto include = [&](Vec2 p) {
    view.x0 = std::min(view.x0, p.x), view.x1 = std::max(view.x1, p.x);
    view.y0 = std::min(view.y0, p.y), view.y1 = std::max(view.y1, p.y);
  };
  for_each_chain(drawing,
                 [&](const std::vector<Vec2>& points) { std::for_each(points.begin(), points.end(), include); });
  for (const ValuedPoint& point : drawing.points) include(point.place);
  if (!(view.x1 >= view.x0)) view = {0, 0, 0, 0};
  const double margin = 0.01 * std::max({view.x1 - view.x0, view.y1 - view.y0, 1.0});
  return {view.x0 - margin, view.x1 + margin, view.y0 - margin, view.y1 + margin};
}

std::string head(const Drawing& drawing, const View& view) {
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" ";
  if (drawing.frame) text += "data-seamount-frame=\"" + frame_text(*drawing.frame) + "\" ";
  text += "data-seamount-crs=\"" + xml_escaped(drawing.crs) + "\" width=\"";
  append_decimal(text, kPixels * (view.x1 - view.x0) / view.longer(), 2);
  text += "\" height=\"";
  append_decimal(text, kPixels * (view.y1 - view.y0) / view.longer(), 2);
  text += "\" viewBox=\"";
  for (const double number : {view.x0, -view.y1, view.x1 - view.x0, view.y1 - view.y0}) {
    append_decimal(text, number, 3);
    text += ' ';
  }
  text.back() = '"';
  return text + ">\n";
}

/// " stroke-width=\"12.3\"": three digits are enough.
std::string stroke_width(double share, const View& view) {
  const double metres = share * view.longer();
  const double unit = std::pow(10.0, std::floor(std::log10(metres)) - 2.0);
  std::string text = " stroke-width=\"";
  append_decimal(text, std::round(metres / unit) * unit, 6);
  return text + '"';
}

}  // namespace

void append_decimal(std::string& text, double value, int digits) {
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::fixed, digits).ptr;
  std::string_view number(buffer, static_cast<size_t>(end - buffer));
  while (number.ends_with('0')) number.remove_suffix(1);
  if (number.ends_with('.')) number.remove_suffix(1);
  text += number == "-0" ? "0" : number;
}

std::string to_svg(const Drawing& drawing) {
  const View view = view_of(drawing);
  const std::string stroke = stroke_width(kStroke, view);
  std::string text = head(drawing, view);
  text += "<g fill=\"#d8cfb8\" fill-rule=\"evenodd\" stroke=\"#333\"" + stroke + ">\n";
  for (const NamedArea& area : drawing.areas) {
    text += "<path data-name=\"" + xml_escaped(area.name) + '"' + svg_data(area.attributes) + " d=\"";
    for (const Polygon& polygon : area.parts) {
      append_path(text, polygon.outer, true);
      for (const Ring& hole : polygon.holes) append_path(text, hole, true);
    }
    text += "\"/>\n";
  }
  text += "</g>\n<g fill=\"none\" stroke=\"#7a4a1e\"" + stroke + ">\n";
  const std::string value = drawing.heights ? "data-height-m=\"" : "data-value=\"";
  for (const ValuedLine& line : drawing.lines) {
    text += "<path " + value + format_number(line.value) + '"' + svg_data(line.attributes) + " d=\"";
    append_path(text, line.points, line.closed);
    text += "\"/>\n";
  }
  // A line without length and with a round end is a dot.
  const std::string dot = stroke_width(kDot, view);
  for (const ValuedPoint& point : drawing.points) {
    text += "<path" + dot + " stroke-linecap=\"round\" " + value + format_number(point.value) + '"' +
            svg_data(point.attributes) + " d=\"";
    append_path(text, {point.place, point.place}, false);
    text += "\"/>\n";
  }
  return text + "</g>\n</svg>\n";
}

}  // namespace seamount::io
