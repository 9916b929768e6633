#include "seamount/geom/contour/close_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/geom/contour/contour.h"
#include "seamount/geom/contour/lines.h"
#include "seamount/geom/contour/nesting.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/noise.h"

namespace seamount::geom {
namespace {

ScalarField hills(const GridFrame& frame, uint64_t seed) {
  ScalarField field(frame);
  const Fbm shape{.wavelength_m = 0.6 * frame.width_m(), .octaves = 4, .gain = 0.5, .cell_m = frame.cell_m};
  for (int y = 0; y < frame.height; ++y) {
    fbm_row(Seed{seed}, shape, frame.x(0), frame.cell_m, frame.y(y), field.row(y));
    for (float& z : field.row(y)) z *= 500.0F;
  }
  return field;
}

/// As a sheet of another program has them: open at the edge, in pieces, running either way, in any order.
std::vector<ValuedLine> sheet_lines(const ScalarField& field, const std::vector<double>& levels, Seed seed) {
  std::vector<ValuedLine> lines;
  Rng rng(seed);
  for (const double level : levels) {
    for (Polyline line : trace_lines(field, level)) {
      const bool closed = line.size() > 3 && line.front() == line.back();
      if (rng.chance(0.5)) std::reverse(line.begin(), line.end());
      const auto middle = static_cast<std::ptrdiff_t>(line.size() / 2);
      if (!closed && line.size() > 4 && rng.chance(0.3)) {
        lines.push_back({{line.begin(), line.begin() + middle + 1}, level, false, {}});
        lines.push_back({{line.begin() + middle, line.end()}, level, false, {}});
        continue;
      }
      if (closed) line.pop_back();
      lines.push_back({std::move(line), level, closed, {}});
    }
  }
  for (size_t i = lines.size(); i > 1; --i)
    std::swap(lines[i - 1], lines[static_cast<size_t>(rng.integer(0, static_cast<int>(i) - 1))]);
  return lines;
}

/// Cells in which the contours say another side of some level than the field does, of those inside the set's frame. Of
/// a level without contours they say nothing.
int wrong_cells(const ContourSet& set, const ScalarField& field, const std::vector<double>& levels) {
  int wrong = 0;
  const GridFrame& frame = field.frame();
  for (const double level : levels) {
    const bool drawn = std::any_of(set.contours.begin(), set.contours.end(),
                                   [&](const Contour& contour) { return contour.height_m == level; });
    if (!drawn) continue;
    ScalarField depth(frame, 0.0F);
    for (const Contour& contour : set.contours) {
      if (contour.height_m != level) continue;
      const Grid<uint8_t> inside = rasterise({{contour.ring, {}}}, frame);
      for (size_t c = 0; c < depth.size(); ++c)
        if (inside.cells()[c] != 0) depth.cells()[c] += is_hill(contour) ? 1.0F : -1.0F;
    }
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        const bool within = frame.x(x) > set.frame.west_m && frame.x(x) < set.frame.east_m() &&
                            frame.y(y) > set.frame.south_m() && frame.y(y) < set.frame.north_m;
        if (within && depth(x, y) != (field(x, y) >= level ? 1.0F : 0.0F)) ++wrong;
      }
  }
  return wrong;
}

const std::vector<double> kLevels = {-200, -150, -100, -50, 0, 50, 100, 150, 200, 250};

TEST(CloseLines, FindTheGroundThatTheyWereCutFrom) {
  for (const uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}) {
    for (const auto& [width, height] : {std::pair(64, 64), {90, 40}, {33, 70}}) {
      const GridFrame frame = {width, height, 10.0, 5000, -300, {}};
      const ScalarField field = hills(frame, seed);
      Drawing drawing;
      drawing.lines = sheet_lines(field, kLevels, Seed{seed});
      drawing.frame = frame;
      const ContourSet set = contours_from_lines(drawing, GridFrame::centred(10, 10, 1), "contours");
      EXPECT_EQ(set.frame, frame);
      EXPECT_EQ(wrong_cells(set, field, kLevels), 0) << "seed " << seed << ", " << width << " x " << height;
      EXPECT_FALSE(find_contour_crossing(set.contours).has_value());
    }
  }
}

TEST(CloseLines, FindTheirSheetThemselves) {
  for (const uint64_t seed : {11U, 12U, 13U, 14U, 15U}) {
    const GridFrame frame = {80, 60, 10.0, 400000, 5000000, {}};
    const ScalarField field = hills(frame, seed);
    Drawing drawing;
    drawing.lines = sheet_lines(field, kLevels, Seed{seed});
    const ContourSet set = contours_from_lines(drawing, frame, "contours");
    EXPECT_EQ(wrong_cells(set, field, kLevels), 0) << "seed " << seed;
    EXPECT_GT(set.frame.width_m() * set.frame.height_m(), 0.8 * frame.width_m() * frame.height_m());
  }
}

TEST(CloseLines, LieOnASheetThatIsTurned) {
  const GridFrame frame = {80, 60, 10.0, 0, 600, {}};
  const ScalarField field = hills(frame, 3);
  Drawing drawing;
  drawing.lines = sheet_lines(field, kLevels, Seed{3});
  const double angle = 0.03;
  const auto turned = [&](Vec2 p) {
    return Vec2{p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)};
  };
  Ring sheet = frame_ring(frame);
  for (Vec2& p : sheet) p = turned(p);
  for (ValuedLine& line : drawing.lines)
    for (Vec2& p : line.points) p = turned(p);
  const ContourSet set = contours_from_lines(drawing, frame, "contours", sheet);
  for (const Vec2 corner : frame_ring(set.frame))
    EXPECT_TRUE(contains(sheet, 0.999 * corner + 0.001 * turned({400, 300})));
  EXPECT_GT(set.frame.width_m(), 700);
  EXPECT_FALSE(find_contour_crossing(set.contours).has_value());
}

TEST(CutLines, AreOpenAtTheFrameAndCloseAgain) {
  for (const uint64_t seed : {21U, 22U, 23U, 24U}) {
    const GridFrame frame = {50, 70, 12.5, -100, 77, {}};
    const ScalarField field = hills(frame, seed);
    ContourSet set{frame, trace_contours(field, kLevels)};
    nest_contours(set.contours);
    const Drawing cut = to_cut_lines(set);
    for (const ValuedLine& line : cut.lines) {
      for (const Vec2 p : line.points) {
        EXPECT_TRUE(p.x >= frame.west_m && p.x <= frame.east_m() && p.y >= frame.south_m() && p.y <= frame.north_m);
      }
      for (size_t i = 0; i + 1 < line.points.size(); ++i) {
        const Vec2 a = line.points[i], b = line.points[i + 1];
        const bool along = (a.x == b.x && (a.x == frame.west_m || a.x == frame.east_m())) ||
                           (a.y == b.y && (a.y == frame.south_m() || a.y == frame.north_m));
        EXPECT_FALSE(along) << "runs along the border";
      }
    }
    EXPECT_EQ(wrong_cells(contours_from_lines(cut, frame, "contours"), field, kLevels), 0) << "seed " << seed;
  }
}

/// A plane that rises eastwards, its lines from south to north.
Drawing plane() {
  Drawing drawing;
  for (int i = 1; i < 10; ++i) drawing.lines.push_back({{{100.0 * i, 0}, {100.0 * i, 500}}, 10.0 * i, false, {}});
  drawing.lines.push_back({{{50, 0}, {50, 500}}, 5, false, {}});
  drawing.lines.push_back({{{950, 500}, {950, 0}}, 95, false, {}});
  return drawing;
}

TEST(CloseLines, JoinBrokenOnesOrSayWhere) {
  std::vector<std::string> notes;
  RunContext run;
  run.note = [&](const std::string& line) { notes.push_back(line); };
  Drawing drawing = plane();
  const GridFrame frame = {90, 50, 10, 50, 500, {}};
  drawing.lines[4].points = {{500, 0}, {500, 200}};
  drawing.lines.push_back({{{501, 206}, {500, 500}}, 50, false, {}});
  const ContourSet set = contours_from_lines(drawing, frame, "contours", {}, run);
  EXPECT_EQ(set.contours.size(), 11U);
  EXPECT_THAT(notes, ::testing::ElementsAre(::testing::HasSubstr("2 broken lines were joined")));
  drawing.lines.back().points[0] = {500, 300};
  try {
    contours_from_lines(drawing, frame, "contours", {}, run);
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("the line of 50 m from (500, 0) to (500, 200) ends inside the sheet, at "
                                     "(500, 200)"));
  }
}

TEST(CloseLines, OfOneHeightRunAsTheyAreWritten) {
  std::vector<std::string> notes;
  RunContext run;
  run.note = [&](const std::string& line) { notes.push_back(line); };
  Drawing drawing;
  drawing.lines = {
      {{{0, 0}, {0, 100}}, 7, false, {}}, {{{-50, 100}, {-50, 0}}, 7, false, {}}, {{{60, 100}, {60, 0}}, 7, false, {}}};
  drawing.frame = GridFrame{20, 10, 10, -100, 100, {}};
  const ContourSet left = contours_from_lines(drawing, *drawing.frame, "contours", {}, run);
  EXPECT_TRUE(notes.empty()) << "a file of ours has its high ground on the left";
  const auto around = [&](Vec2 p) {
    return std::count_if(left.contours.begin(), left.contours.end(),
                         [&](const Contour& c) { return contains(c.ring, p); });
  };
  EXPECT_EQ(around({-75, 50}), 0);
  EXPECT_EQ(around({-25, 50}), 1);
  EXPECT_EQ(around({30, 50}), 0);
  EXPECT_EQ(around({80, 50}), 1);
}

TEST(CloseLines, BasinsUnderAHighBorderStayBasins) {
  Drawing drawing = plane();
  drawing.lines.push_back({{{420, 200}, {440, 200}, {440, 240}, {420, 240}}, 40, true, {}});
  drawing.lines.push_back({{{425, 205}, {435, 205}, {435, 235}, {425, 235}}, 2, true, {}});  // far below the border
  const ContourSet set = contours_from_lines(drawing, {90, 50, 10, 50, 500, {}}, "contours");
  int basins = 0, around = 0;
  for (const Contour& contour : set.contours) {
    basins += !is_hill(contour);
    around += contour.height_m == 2.0 && is_hill(contour);
  }
  EXPECT_EQ(basins, 2);
  EXPECT_EQ(around, 1) << "the whole sheet lies above 2 m";
}

TEST(CloseLines, ContradictionsAreErrors) {
  Drawing drawing = plane();
  drawing.lines.push_back({{{520, 0}, {560, 500}}, 50, false, {}});
  drawing.lines.push_back({{{570, 0}, {580, 500}}, 20, false, {}});
  EXPECT_THROW(contours_from_lines(drawing, {90, 50, 10, 50, 500, {}}, "contours"), InvalidArgument);
}

}  // namespace
}  // namespace seamount::geom
