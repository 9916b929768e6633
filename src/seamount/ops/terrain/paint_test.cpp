#include "seamount/ops/terrain/paint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/geom/brush/brush_rows.h"
#include "seamount/geom/grid/resample.h"

namespace seamount::terrain {
namespace {

using ::testing::HasSubstr;

const GridFrame kFrame = GridFrame::centred(90, 70, 40.0);
const Brush kBrush{{{-900, -300}, {-200, 250}, {700, 100}}, {}, 300, 0.2};

ScalarField painted(std::vector<PaintStroke> strokes, double base = 0.0, bool unknown = false,
                    const ScalarField* values = nullptr) {
  return paint(kFrame, values, {base, unknown, std::move(strokes)}, {});
}

ScalarField weights(const Brush& brush) {
  ScalarField out(kFrame, 0.0F);
  geom::BrushBand band;
  band.read(geom::brush_path(brush, kFrame, ""), kFrame, 0, kFrame.height);
  band.each_row([&](int y, int x, std::span<const float> w) { std::copy(w.begin(), w.end(), &out(x, y)); });
  return out;
}

TEST(Paint, LaysValuesOverEachOtherInOrder) {
  const ScalarField w = weights(kBrush);
  const ScalarField once = painted({PaintBrush{kBrush, 0.8, 0.5}}, 0.2);
  const ScalarField twice = painted({PaintBrush{kBrush, 0.8, 0.5}, PaintBrush{kBrush, -3, 1}}, 0.2);
  for (size_t i = 0; i < w.size(); ++i) {
    const double share = std::min(1.0F, w.cells()[i]), first = 0.2 + 0.5 * share * 0.6;
    ASSERT_NEAR(once.cells()[i], first, 1e-6);
    ASSERT_NEAR(twice.cells()[i], first + share * (-3 - first), 1e-5);
    if (share == 0.0) {
      ASSERT_EQ(twice.cells()[i], 0.2F);
    }
  }
  EXPECT_EQ(painted({}, 0.7), ScalarField(kFrame, 0.7F));
}

TEST(Paint, StaysBetweenWhatIsThereAndWhatIsPainted) {
  Brush curl = kBrush;
  for (int i = 0; i < 60; ++i) curl.points.push_back({700 + 60 * std::cos(0.9 * i), 100 + 60 * std::sin(0.9 * i)});
  const ScalarField curled = painted({PaintBrush{curl, 1, 1}});
  for (const float v : curled.cells()) ASSERT_TRUE(v >= 0.0F && v <= 1.0F);
}

TEST(Paint, FillsAreasAndFeathersThem) {
  const Polygon square{{{-800, -600}, {600, -600}, {600, 600}, {-800, 600}}, {{{-200, -200}, {0, -200}, {0, 0}}}};
  const ScalarField out = painted({PaintArea{{square}, 2.0, 1.0, 400}});
  const auto at = [&](double x, double y) {
    return out(static_cast<int>(std::lround(kFrame.column(x))), static_cast<int>(std::lround(kFrame.row(y))));
  };
  EXPECT_EQ(at(-500, 300), 2.0F);
  EXPECT_EQ(at(-60, -120) < 2.0F, true);  // in the hole
  EXPECT_NEAR(at(820, 0), 1.0, 0.2);      // half way out
  EXPECT_EQ(at(1100, 0), 0.0F);
  // An outline that crosses itself is inside by the even-odd rule.
  const ScalarField bow = painted({PaintArea{{{{{-800, -600}, {800, 600}, {800, -600}, {-800, 600}}, {}}}}});
  EXPECT_EQ(bow(30, 35), 1.0F);
  EXPECT_EQ(bow(45, 25), 0.0F);
  EXPECT_GT(bow(60, 35), 0.9F);
}

TEST(Paint, EraseBringsBackWhatCameIn) {
  const ScalarField before = painted({PaintBrush{kBrush, 0.4, 1}}, 0.1);
  Brush wide = kBrush;
  wide.radius_m = 900;
  wide.hardness = 0.9;
  const PaintArea area{{{{{-400, -300}, {300, -300}, {0, 300}}, {}}}, 9};
  EXPECT_EQ(painted({area, PaintErase{wide, 1}}, 0.0, false, &before), before);
}

TEST(Paint, UnknownIsPaintedWhereTheStrokeHasHalfItsWeight) {
  const ScalarField w = weights(kBrush);
  const ScalarField out = painted({PaintBrush{kBrush, 1, 0.3}}, 0.0, true);
  for (size_t i = 0; i < w.size(); ++i) {
    if (std::abs(w.cells()[i] - 0.5F) < 1e-3) continue;
    ASSERT_EQ(std::isnan(out.cells()[i]), w.cells()[i] < 0.5F);
    if (w.cells()[i] > 0.5F) {
      ASSERT_EQ(out.cells()[i], 1.0F);
    }
  }
  const ScalarField none = painted({PaintBrush{kBrush, 1, 0}}, 0.0, true);
  for (const float v : none.cells()) ASSERT_TRUE(std::isnan(v));
  Brush wide = kBrush;
  wide.radius_m = 900;
  const ScalarField erased = painted({PaintBrush{kBrush}, PaintErase{wide, 1}}, 0.0, true);
  for (const float v : erased.cells()) ASSERT_TRUE(std::isnan(v));
  std::vector<std::string> notes;
  const ScalarField values(kFrame, 0.0F);
  paint(kFrame, &values, {0.0, true, {}}, {.note = [&](const std::string& line) { notes.push_back(line); }});
  EXPECT_EQ(notes.size(), 1U);
}

TEST(Paint, CoarseCellsShowWhatFineOnesDo) {
  const std::vector<PaintStroke> strokes = {PaintBrush{kBrush, 1, 0.8},
                                            PaintArea{{{{{0, 0}, {900, -200}, {500, 800}}, {}}}, 0.5, 1, 200},
                                            PaintErase{{{{-600, 0}, {0, 500}}, {}, 200, 0.4}, 1}};
  const GridFrame fine = GridFrame::centred(1024, 1024, 4), coarse = GridFrame::centred(256, 256, 16);
  const ScalarField shown = geom::box_downsample(paint(fine, nullptr, {0, false, strokes}, {}), 4, {});
  const ScalarField out = paint(coarse, nullptr, {0, false, strokes}, {});
  for (size_t i = 0; i < out.size(); ++i) ASSERT_NEAR(out.cells()[i], shown.cells()[i], 0.02);
}

TEST(Paint, MistakesAreNamed) {
  const auto error_of = [](const PaintStroke& stroke) -> std::string {
    try {
      painted({stroke});
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of(PaintBrush{}), "strokes[0].points: has no point");
  EXPECT_EQ(error_of(PaintArea{}), "strokes[0].polygons: has no polygon");
  EXPECT_THAT(error_of(PaintArea{{{{{0, 0}, {1, 1}}, {}}}}), HasSubstr("strokes[0].polygons: has a ring of 2 points"));
  EXPECT_THAT(error_of(PaintArea{{{{{0, 0}, {1, 1}, {std::nan(""), 0}}, {}}}}), HasSubstr("a point that is no place"));
  EXPECT_THAT(error_of(PaintErase{{{{0, 0}}, {0.5, 0.5}, 10, 0}}), HasSubstr("strokes[0].pressure: has 2 values"));
  const ScalarField other(GridFrame::centred(3, 3, 1), 0.0F);
  EXPECT_THROW(painted({}, 0, false, &other), IncompatibleInputs);
}

}  // namespace
}  // namespace seamount::terrain
