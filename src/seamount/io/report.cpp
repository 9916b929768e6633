#include "seamount/io/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"

namespace seamount::io {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

/// Three significant digits and a unit, whole numbers from 1000 on; a dash for what is not defined.
std::string readable(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "&ndash;";
  const bool whole = std::abs(value) >= 1e3 && std::abs(value) < 1e7;
  std::string text = whole ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
  if (text.starts_with('-')) text = "&minus;" + text.substr(1);
  return unit.empty() ? text : text + "&nbsp;" + xml_escaped(unit);
}

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return xml_escaped(name);
}

constexpr const char* kStyle = R"(
:root{color-scheme:light dark;--page:#f6f5f1;--card:#fff;--text:#23262b;--soft:#6a6f78;--line:#e3e1da;--grid:#ecebe5;
--s0:#1f6fb4;--s1:#d0802a}
@media(prefers-color-scheme:dark){:root{--page:#15181c;--card:#1e2227;--text:#e6e7ea;--soft:#9aa1ab;--line:#31363d;
--grid:#2a2f35;--s0:#64aee8;--s1:#eba75c}}
*{box-sizing:border-box}body{margin:0 auto;padding:32px 20px 48px;max-width:1380px;background:var(--page);
color:var(--text);font:15px/1.45 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",sans-serif}
h1{font-size:26px;font-weight:650;letter-spacing:-.01em;margin:0 0 6px}h2{font-size:16px;font-weight:620;margin:0}
.subjects{display:flex;gap:20px;flex-wrap:wrap;margin:0 0 22px;color:var(--soft)}
.subjects i{display:inline-block;width:12px;height:12px;border-radius:3px;margin-right:7px;vertical-align:-1px}
.cards{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,400px),1fr));gap:16px}
.card{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:16px 18px}
.head{display:flex;justify-content:space-between;align-items:baseline;gap:12px}
.distance{font-variant-numeric:tabular-nums;color:var(--soft);font-size:13px;white-space:nowrap}
.distance b{color:var(--text);font-weight:620}p{margin:4px 0 8px;color:var(--soft);font-size:13px}
svg{display:block;width:100%;height:auto}svg text{fill:var(--soft);font-size:11px}svg .axis{font-size:11.5px}
.grid path{stroke:var(--grid);fill:none}.none{padding:60px 0;text-align:center}
table{width:100%;border-collapse:collapse;font-size:13px;font-variant-numeric:tabular-nums;margin-top:6px}
td,th{padding:3px 0;border-top:1px solid var(--line);text-align:right;font-weight:400}
td:first-child,th:first-child{text-align:left;color:var(--soft)}th{border-top:0;color:var(--soft)}
.overview,.settings{margin-bottom:16px}.overview td:nth-child(2){width:100%;padding:3px 12px}
.overview td:first-child{white-space:nowrap}
.bar{height:9px;border-radius:5px;background:var(--s0);min-width:2px}
)";

std::string subjects_line(const Report& report) {
  std::string html = "<div class=\"subjects\">";
  for (size_t i = 0; i < report.subjects.size(); ++i)
    html +=
        fmt::format("<span><i style=\"background:var(--s{})\"></i>{}</span>", i % 2, xml_escaped(report.subjects[i]));
  return html + "</div>\n";
}

/// A distance as people read it: a dash where none is defined.
std::string distance_text(const std::optional<double>& distance) {
  return distance ? fmt::format("{:.3f}", *distance) : "&ndash;";
}

/// A bar for every distance; empty with one subject.
std::string overview(const Report& report) {
  if (report.subjects.size() < 2) return "";
  double longest = 0.0;
  for (const Descriptor& descriptor : report.descriptors)
    longest = std::max(longest, descriptor.distance.value_or(0.0));
  std::string html =
      "<section class=\"card overview\"><h2>Distances</h2><p>How far the two are apart; 0 is the same. Each descriptor "
      "says below how its own is defined.</p><table>";
  for (const Descriptor& descriptor : report.descriptors) {
    const double share = longest > 0.0 ? descriptor.distance.value_or(0.0) / longest : 0.0;
    html += "<tr><td>" + xml_escaped(descriptor.title) + "</td><td>";
    if (descriptor.distance) html += fmt::format("<div class=\"bar\" style=\"width:{:.1f}%\"></div>", 100.0 * share);
    html += "</td><td>" + distance_text(descriptor.distance) + "</td></tr>";
  }
  return html + "</table></section>\n";
}

std::string measures_table(const Report& report, const std::vector<Measure>& measures) {
  if (measures.empty()) return "";
  std::string html = "<table>";
  if (report.subjects.size() > 1) {
    html += "<tr><th></th>";
    for (const std::string& subject : report.subjects) html += "<th>" + xml_escaped(subject) + "</th>";
    html += "</tr>";
  }
  for (const Measure& measure : measures) {
    html += "<tr><td>" + spaced(measure.name) + "</td>";
    for (const double value : measure.values) html += "<td>" + readable(value, measure.unit) + "</td>";
    html += "</tr>";
  }
  return html + "</table>";
}

std::string settings_card(const Report& report) {
  if (report.settings.empty()) return "";
  return "<section class=\"card settings\"><h2>Measured with</h2>" + measures_table(report, report.settings) +
         "</section>\n";
}

Json measures_json(const std::vector<Measure>& measures) {
  Json list = Json::object();
  for (const Measure& measure : measures)
    list[measure.name] = {{"unit", measure.unit}, {"values", numbers(measure.values)}};
  return list;
}

}  // namespace

std::string report_json(const Report& report) {
  Json root = {{"title", report.title}, {"subjects", report.subjects}};
  if (!report.settings.empty()) root["settings"] = measures_json(report.settings);
  root["descriptors"] = Json::object();
  for (const Descriptor& descriptor : report.descriptors) {
    Json entry = {{"title", descriptor.title}, {"meaning", descriptor.meaning}};
    if (report.subjects.size() > 1) entry["distance"] = number(descriptor.distance.value_or(NAN));
    if (!descriptor.measures.empty()) entry["measures"] = measures_json(descriptor.measures);
    Json lines = Json::array();
    for (const PlotLine& line : descriptor.plot.lines)
      lines.push_back({{"x", numbers(line.x)}, {"y", numbers(line.y)}});
    entry["plot"] = {{"x", descriptor.plot.x_title}, {"y", descriptor.plot.y_title}, {"lines", lines}};
    root["descriptors"][descriptor.name] = std::move(entry);
  }
  return root.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_html(const Report& report) {
  std::string html =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"><title>" +
      xml_escaped(report.title) + "</title><style>" + kStyle + "</style></head><body>\n<h1>" +
      xml_escaped(report.title) + "</h1>\n" + subjects_line(report) + overview(report) + settings_card(report) +
      "<div class=\"cards\">\n";
  for (const Descriptor& descriptor : report.descriptors) {
    html += "<section class=\"card\"><div class=\"head\"><h2>" + xml_escaped(descriptor.title) + "</h2>";
    if (report.subjects.size() > 1)
      html += "<span class=\"distance\">distance <b>" + distance_text(descriptor.distance) + "</b></span>";
    html += "</div><p>" + xml_escaped(descriptor.meaning) + "</p>" + plot_svg(descriptor.plot) +
            measures_table(report, descriptor.measures) + "</section>\n";
  }
  return html + "</div>\n</body></html>\n";
}

void write_report(const Report& report, const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".json") return write_text(path, report_json(report));
  if (extension == ".html") return write_text(path, report_html(report));
  throw IoError(path, "'" + extension + "' is not a format for reports" + suggestion(extension, {".html", ".json"}));
}

}  // namespace seamount::io
