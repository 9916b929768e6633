#include "seamount/io/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "seamount/base/error.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Report sample() {
  Report report{"Hills & <dales>", {"mine", "the \"Alps\""}, {}, {{"cell", "m", {10, 30}}}};
  report.descriptors.push_back({"slope",
                                "Slope",
                                "Steepness.",
                                {PlotKind::histogram,
                                 "slope (deg)",
                                 "density",
                                 false,
                                 false,
                                 {{{1, 2, 3}, {0.1, 0.5, 0.2}}, {{1, 2, 3}, {0, 0.4, 0.6}}}},
                                {{"mean", "deg", {12.5, std::numeric_limits<double>::quiet_NaN()}}},
                                0.25});
  report.descriptors.push_back({"strahler",
                                "Orders",
                                "Counts.",
                                {PlotKind::bars, "order", "count", false, true, {{{1, 2}, {40, 8}}, {{}, {}}}},
                                {},
                                {}});
  return report;
}

TEST(Report, JsonHoldsEveryNumber) {
  const auto json = nlohmann::json::parse(report_json(sample()));
  EXPECT_EQ(json["title"], "Hills & <dales>");
  EXPECT_EQ(json["subjects"][1], "the \"Alps\"");
  EXPECT_EQ(json["descriptors"]["slope"]["distance"], 0.25);
  EXPECT_EQ(json["descriptors"]["slope"]["measures"]["mean"]["values"][0], 12.5);
  EXPECT_TRUE(json["descriptors"]["slope"]["measures"]["mean"]["values"][1].is_null());
  EXPECT_EQ(json["descriptors"]["slope"]["plot"]["lines"][1]["y"][2], 0.6);
  EXPECT_TRUE(json["descriptors"]["strahler"].at("distance").is_null());
  EXPECT_EQ(json["settings"]["cell"]["unit"], "m");
  EXPECT_EQ(json["settings"]["cell"]["values"][1], 30.0);
}

TEST(Report, OfOneSubjectHasNoDistances) {
  Report report = sample();
  report.subjects.pop_back();
  report.settings.clear();
  for (Descriptor& descriptor : report.descriptors) descriptor.distance.reset();
  const auto json = nlohmann::json::parse(report_json(report));
  EXPECT_FALSE(json["descriptors"]["strahler"].contains("distance"));
  EXPECT_FALSE(json.contains("settings"));
  EXPECT_THAT(report_html(report), Not(HasSubstr("class=\"distance\"")));
  EXPECT_THAT(report_html(report), Not(HasSubstr("Distances")));
}

TEST(Report, PageStandsAloneAndEscapes) {
  const std::string html = report_html(sample());
  EXPECT_THAT(html, HasSubstr("Hills &amp; &lt;dales&gt;"));
  EXPECT_THAT(html, HasSubstr("the &quot;Alps&quot;"));
  EXPECT_THAT(html, HasSubstr("<svg"));
  EXPECT_THAT(html, HasSubstr("&ndash;</td>"));
  EXPECT_THAT(html, HasSubstr("distance <b>&ndash;</b>"));
  EXPECT_THAT(html, HasSubstr("<td>10&nbsp;m</td><td>30&nbsp;m</td>"));
  for (const char* outside : {"<script", "http:", "https:", "src=", "url(", "nan", "inf"})
    EXPECT_THAT(html, Not(HasSubstr(outside)));
}

TEST(Report, PlotsWithoutPointsSaySo) {
  EXPECT_THAT(plot_svg({}), HasSubstr("Nothing to show"));
  const Plot point{PlotKind::curve, "x", "y", true, true, {{{5}, {7}}}};
  EXPECT_THAT(plot_svg(point), Not(HasSubstr("nan")));
  const Plot flat{PlotKind::histogram, "x", "y", false, false, {{{5, 6}, {0, 0}}}};
  EXPECT_THAT(plot_svg(flat), Not(HasSubstr("nan")));
}

TEST(Report, WritesByExtension) {
  const TestFolder folder;
  write_report(sample(), folder("a.json"));
  write_report(sample(), folder("a.html"));
  EXPECT_EQ(folder.files(), 2U);
  EXPECT_THROW(write_report(sample(), folder("a.pdf")), IoError);
}

}  // namespace
}  // namespace seamount::io
