#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/io/projection.h"
#include "seamount/io/svg_path.h"
#include "seamount/io/test_files.h"
#include "seamount/io/vector.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Drawing read(const std::string& text, const VectorOptions& options = {}) {
  return read_svg({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "x.svg", options);
}

std::string svg(const std::string& inside) { return "<svg xmlns=\"http://www.w3.org/2000/svg\">" + inside + "</svg>"; }

TEST(SvgPath, ReadsEveryCommandThatEditorsWrite) {
  const auto chains = parse_svg_path("m 1,2 3,0 v4h-3z M10 10L20 10 20 20 q5 5 0 10Z");
  ASSERT_EQ(chains.size(), 2U);
  EXPECT_EQ(chains[0].points, (Polyline{{1, 2}, {4, 2}, {4, 6}, {1, 6}}));
  EXPECT_TRUE(chains[0].closed);
  EXPECT_EQ(chains[1].points.back(), (Vec2{20, 30}));
  const auto curve = parse_svg_path("M0 0C0 10 10 10 10 0S20-10 20 0");
  EXPECT_EQ(curve[0].points.size(), 33U);
  EXPECT_EQ(curve[0].points[8], (Vec2{5, 7.5})) << "the middle of a cubic";
  EXPECT_NEAR(curve[0].points[24].y, -7.5, 1e-12) << "goes on smoothly";
  EXPECT_EQ(parse_svg_path("M1-.5.5-1e1")[0].points, (Polyline{{1, -0.5}, {0.5, -10}}));
  EXPECT_EQ(parse_svg_path("M0 0L1 0L1 1Zl5 5").size(), 2U) << "what follows Z begins where the last one did";
  for (const char* bad : {"L1 2", "M1", "M1 2L3", "M0 0A1 1 0 0 0 2 2", "M0 0 L nan 2", "5 6", "M0 0Z5 5", "M1e99 0"})
    EXPECT_THROW(parse_svg_path(bad), InvalidArgument) << bad;
}

TEST(SvgTransform, AppliesInTheirOrder) {
  const Vec2 p = parse_svg_transform("translate(10,20) scale(2) matrix(0 1 -1 0 0 0)")({1, 0});
  EXPECT_EQ(p, (Vec2{10, 22}));
  const Vec2 turned = parse_svg_transform("rotate(90, 5, 5)")({10, 5});
  EXPECT_NEAR(turned.x, 5, 1e-12);
  EXPECT_NEAR(turned.y, 10, 1e-12);
  for (const char* bad : {"translate", "translate(", "scale(1 2 3)", "warp(1)", "matrix(1 2 3)"})
    EXPECT_THROW(parse_svg_transform(bad), InvalidArgument) << bad;
}

Drawing sample(const std::string& crs) {
  Drawing drawing;
  drawing.crs = crs;
  drawing.areas = {{"isle \"A\" <&>",
                    {{{{0, 0}, {1000, 0}, {1000, 500.25}, {0, 500}}, {{{100, 100}, {100, 200}, {200, 150}}}},
                     {{{2000, 0}, {2100, 0}, {2050, 80}}, {}}},
                    {{"height_m", 12.5}, {"basin", 1}}}};
  drawing.lines = {{{{0, 0}, {10.5, 20}, {30, 10}}, 12.5, false, {{"width_m", 4.25}}},
                   {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, -5, true, {}}};
  drawing.points = {{{40, 50}, 1234.5, {{"prominence_m", 321}}}};
  return drawing;
}

TEST(Svg, ComesBackAsItWas) {
  const TestFolder folder;
  for (const std::string& crs : {std::string(), std::string("EPSG:32604"), local_crs(12.5, -30)}) {
    for (const bool heights : {false, true}) {
      Drawing drawing = sample(crs);
      drawing.heights = heights;
      if (heights) drawing.frame = GridFrame{512, 300, 7.25, -1234.5, 4321.0625, crs};
      write_drawing(drawing, folder("x.svg"));
      EXPECT_EQ(read_drawing(folder("x.svg")), drawing);
    }
  }
  EXPECT_THAT(error_of([&] { read_drawing(folder("x.svg"), {.feature = "isle"}); }), HasSubstr("no feature 'isle'"));
}

TEST(Svg, WidthsAreInUserUnits) {
  const TestFolder folder;
  write_drawing(sample(""), folder("x.svg"));
  const std::vector<uint8_t> bytes = read_file(folder("x.svg"));
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_THAT(text, Not(HasSubstr("vector-effect")));
  EXPECT_THAT(text, HasSubstr("stroke-width=\"2.14\""));
  EXPECT_THAT(text, HasSubstr("width=\"1000\""));
}

TEST(Svg, EditedFilesKeepTheirMeaning) {
  const Drawing drawing = read(svg(R"svg(<defs><path d="M0 0L9 9"/></defs><!-- a note -->
<g transform="translate(100,0)"><g style="fill:none;stroke:#000" transform="scale(2)">
<path data-height-m="50" d="M0 0L10 0L10 -10Z"/><polyline points="0,0 5,5"/></g>
<polygon inkscape:label="reef" points="0,0 10,0 10,-10"/><rect x="1" y="2" width="3" height="4" fill="none"/>
<path data-name="two" d="M0 0H90V-90H0ZM10 -10H20V-20H10Z"/></g><text x="4">hello</text>)svg"));
  ASSERT_EQ(drawing.lines.size(), 3U);
  EXPECT_EQ(drawing.lines[0].points, (Polyline{{100, 0}, {120, 0}, {120, 20}}));
  EXPECT_TRUE(drawing.lines[0].closed);
  EXPECT_EQ(drawing.lines[0].value, 50.0);
  EXPECT_EQ(drawing.lines[1].points, (Polyline{{100, 0}, {110, -10}}));
  ASSERT_EQ(drawing.areas.size(), 2U);
  EXPECT_EQ(drawing.areas[0].name, "reef");
  EXPECT_EQ(drawing.areas[1].parts.at(0).holes.size(), 1U);
}

TEST(Svg, SaysWhatIsWrong) {
  const auto message = [](const std::string& text, const VectorOptions& options = {}) {
    return error_of([&] { read(text, options); });
  };
  EXPECT_THAT(message(""), HasSubstr("x.svg: "));
  EXPECT_THAT(message("<html></html>"), HasSubstr("is not an SVG"));
  EXPECT_THAT(message("<svg><path d='M0 0"), HasSubstr("x.svg: "));
  EXPECT_THAT(message(svg("<path id=\"p7\" d=\"M0 0 L\"/>")), HasSubstr("its path 'p7': d: a number is missing"));
  EXPECT_THAT(message(svg("")), HasSubstr("has no areas, lines or points"));
  EXPECT_THAT(message(svg("<path fill=\"none\" d=\"M0 0L9 9\"/>"), {.heights = true}), HasSubstr("has no height"));
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "<g>";
  EXPECT_THAT(message(svg(deep)), HasSubstr("x.svg: "));
  EXPECT_THAT(message("<!DOCTYPE svg [<!ENTITY a \"&b;&b;\"><!ENTITY b SYSTEM \"file:///etc/passwd\">]>" +
                      svg("<path data-name=\"&b;\" d=\"M0 0L9 0L9 9Z\"/>")),
              "");
}

TEST(Svg, EveryShorterTextIsHandled) {
  const TestFolder folder;
  write_drawing(sample(""), folder("x.svg"));
  const std::vector<uint8_t> bytes = read_file(folder("x.svg"));
  for (size_t length = 0; length < bytes.size(); ++length) {
    try {
      read_svg({bytes.data(), length}, "short.svg");
    } catch (const IoError&) {
    }
  }
}

}  // namespace
}  // namespace seamount::io
