#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "seamount/base/text.h"
#include "seamount/io/report.h"

namespace seamount::io {
namespace {

constexpr double kWidth = 420, kHeight = 230, kLeft = 62, kRight = 12, kTop = 10, kBottom = 40;

/// One axis: from values to places on the page.
struct Axis {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  bool logarithmic = false;
  bool whole = false;       ///< ticks at whole numbers only
  double from = 0, to = 1;  ///< places of low and high

  bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0.0); }
  void include(double value) {
    if (!shows(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return low > high; }
  double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
  double place(double value) const {
    const double span = scaled(high) - scaled(low);
    return from + (to - from) * (span > 0.0 ? (scaled(value) - scaled(low)) / span : 0.5);
  }

  /// Round values within the axis: 1, 2 or 5 times a power of ten, powers of ten on logarithmic axes.
  std::vector<double> ticks() const {
    std::vector<double> values;
    if (logarithmic) {
      const double first = std::ceil(scaled(low) - 1e-9), last = std::floor(scaled(high) + 1e-9);
      const double step = std::max(1.0, std::ceil((last - first) / 6.0));
      for (double power = first; power <= last; power += step) values.push_back(std::pow(10.0, power));
      return values;
    }
    const double rough = (high - low) / 5.0;
    if (!(rough > 0.0)) return {low};
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = power * (rough / power < 1.5 ? 1.0 : rough / power < 3.5 ? 2.0 : rough / power < 7.5 ? 5.0 : 10.0);
    if (whole) step = std::max(1.0, std::round(step));
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
      values.push_back(k * step + 0.0);  // never -0
    return values;
  }
};

/// A tick as people write it: 1500, 0.25, 10^6.
std::string tick_text(double value, bool logarithmic) {
  if (logarithmic && (value >= 1e4 || value < 1e-2))
    return fmt::format("10<tspan dy=\"-4\" font-size=\"8\">{}</tspan>", std::lround(std::log10(value)));
  if (value != 0.0 && (std::abs(value) >= 1e5 || std::abs(value) < 1e-3)) return fmt::format("{:.0e}", value);
  return fmt::format("{:g}", std::round(value * 1e6) / 1e6);
}

std::string draw_axes(const Plot& plot, const Axis& x, const Axis& y) {
  std::string svg = "<g class=\"grid\">";
  for (const double tick : x.ticks())
    svg += fmt::format("<path d=\"M{0:.1f} {1}V{2}\"/>", x.place(tick), kTop, kHeight - kBottom);
  for (const double tick : y.ticks())
    svg += fmt::format("<path d=\"M{0} {1:.1f}H{2}\"/>", kLeft, y.place(tick), kWidth - kRight);
  svg += "</g><g class=\"ticks\">";
  for (const double tick : x.ticks())
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>", x.place(tick),
                       kHeight - kBottom + 14, tick_text(tick, x.logarithmic));
  for (const double tick : y.ticks())
    svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", kLeft - 6, y.place(tick) + 3.5,
                       tick_text(tick, y.logarithmic));
  svg += fmt::format("</g><text class=\"axis\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                     0.5 * (kLeft + kWidth - kRight), kHeight - 6, xml_escaped(plot.x_title));
  svg += fmt::format("<text class=\"axis\" transform=\"translate(11 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
                     0.5 * (kTop + kHeight - kBottom), xml_escaped(plot.y_title));
  return svg;
}

/// "M x y L x y ..." of the points that the axes show, and the places of the first and the last.
struct Path {
  std::string text;
  double first = 0, last = 0;
  int points = 0;
};

Path draw_path(const PlotLine& line, const Axis& x, const Axis& y, bool skip_unshown) {
  Path path;
  for (size_t i = 0; i < line.x.size(); ++i) {
    if (!x.shows(line.x[i]) || (skip_unshown && !y.shows(line.y[i]))) continue;
    path.last = x.place(line.x[i]);
    if (path.points++ == 0) path.first = path.last;
    path.text += fmt::format("{}{:.1f} {:.1f}", path.points == 1 ? "M" : "L", path.last, y.place(line.y[i]));
  }
  return path;
}

std::string draw_line(const PlotLine& line, size_t subject, PlotKind kind, const Axis& x, const Axis& y) {
  const Path path = draw_path(line, x, y, kind == PlotKind::curve);
  if (path.points == 0) return "";
  const std::string colour = fmt::format("var(--s{})", subject % 2);
  std::string svg;
  if (kind == PlotKind::histogram)
    svg += fmt::format("<path d=\"{}L{:.1f} {}L{:.1f} {}Z\" fill=\"{}\" fill-opacity=\".16\"/>", path.text, path.last,
                       kHeight - kBottom, path.first, kHeight - kBottom, colour);
  svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\" stroke-linejoin=\"round\"/>",
                     path.text, colour);
  if (kind == PlotKind::curve && path.points <= 24) {
    for (size_t i = 0; i < line.x.size(); ++i) {
      if (!x.shows(line.x[i]) || !y.shows(line.y[i])) continue;
      svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.2\" fill=\"{}\"/>", x.place(line.x[i]),
                         y.place(line.y[i]), colour);
    }
  }
  return svg;
}

std::string draw_bars(const Plot& plot, const Axis& x, const Axis& y) {
  const double step = x.place(x.low + 1.0) - x.place(x.low),
               width = 0.7 * step / static_cast<double>(plot.lines.size());
  std::string svg;
  for (size_t s = 0; s < plot.lines.size(); ++s) {
    const PlotLine& line = plot.lines[s];
    for (size_t i = 0; i < line.x.size(); ++i) {
      if (!y.shows(line.y[i])) continue;
      const double left = x.place(line.x[i]) - 0.35 * step + static_cast<double>(s) * width, top = y.place(line.y[i]);
      svg += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"1.5\" fill=\"var(--s{})\"/>", left,
          top, 0.92 * width, std::max(0.0, kHeight - kBottom - top), s % 2);
    }
  }
  return svg;
}

}  // namespace

std::string plot_svg(const Plot& plot) {
  Axis x, y;
  x.whole = plot.kind == PlotKind::bars;
  x.logarithmic = plot.log_x, y.logarithmic = plot.log_y;
  x.from = kLeft, x.to = kWidth - kRight, y.from = kHeight - kBottom, y.to = kTop;
  for (const PlotLine& line : plot.lines) {
    for (const double value : line.x) x.include(value);
    for (const double value : line.y) y.include(value);
  }
  if (x.empty() || y.empty()) return "<p class=\"none\">Nothing to show.</p>";
  if (plot.kind != PlotKind::curve && !plot.log_y) y.low = 0.0;
  if (plot.kind == PlotKind::bars) {
    x.low -= 0.5, x.high += 0.5;
    if (plot.log_y) y.low = std::pow(10.0, std::floor(std::log10(y.low) - 0.3));
  }
  if (y.low == y.high) y.high = y.low + (y.low > 0.0 ? y.low : 1.0);
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\">", kWidth, kHeight);
  if (plot.kind == PlotKind::bars) {
    svg += draw_axes(plot, x, y) + draw_bars(plot, x, y);
  } else {
    svg += draw_axes(plot, x, y);
    // The reference lies behind.
    for (size_t s = plot.lines.size(); s-- > 0;) svg += draw_line(plot.lines[s], s, plot.kind, x, y);
  }
  return svg + "</svg>";
}

}  // namespace seamount::io
