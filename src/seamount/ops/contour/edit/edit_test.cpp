// Editing sessions on random sets: whatever is done, contours nest.
#include "seamount/ops/contour/edit/edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "seamount/geom/polygon/polygon.h"
#include "seamount/ops/contour/edit/edit_area.h"
#include "seamount/ops/contour/edit/pattern.h"
#include "seamount/ops/contour/move/test_contours.h"

namespace seamount::contour {
namespace {

using ::testing::HasSubstr;

ContourSet edited(const ContourSet& set, std::vector<Edit> edits, OnCrossing on_crossing = OnCrossing::limit,
                  std::vector<std::string>* notes = nullptr) {
  RunContext run;
  if (notes != nullptr) run.note = [notes](const std::string& line) { notes->push_back(line); };
  return edit(set, {std::move(edits), on_crossing}, {}, Seed{3}, run);
}

std::string error_of(const ContourSet& set, std::vector<Edit> edits, OnCrossing on_crossing = OnCrossing::limit) {
  try {
    edited(set, std::move(edits), on_crossing);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

Polyline random_stroke(Rng& rng, int points, double within) {
  Polyline stroke;
  for (int i = 0; i < points; ++i) stroke.push_back({rng.uniform(-within, within), rng.uniform(-within, within)});
  return stroke;
}

Polygon disc(Vec2 middle, double radius, int points = 60) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double a = 6.283185307179586 * i / points;
    ring.push_back(middle + radius * (1 + 0.15 * std::sin(3 * a)) * Vec2{std::cos(a), std::sin(a)});
  }
  return {ring, {}};
}

const ContourSet& island() {
  static const ContourSet set = noise_contours(11, 200, 60);
  return set;
}

TEST(Edit, NothingAskedNothingDone) { EXPECT_EQ(edited(island(), {}), island()); }

TEST(Edit, WarpsKeepNestingOnRandomStrokes) {
  Rng rng(Seed{5});
  for (int trial = 0; trial < 8; ++trial) {
    const WarpTool warp{.stroke = random_stroke(rng, 2 + trial % 3, 7000),
                        .radius_m = rng.uniform(300, 1500),
                        .strength = rng.uniform(0.5, 1.0),
                        .k = 1 + trial % 3};
    std::vector<std::string> notes;
    const ContourSet set = edited(island(), {warp, warp}, OnCrossing::limit, &notes);
    EXPECT_TRUE(is_sound(set)) << trial;
    EXPECT_FALSE(set == island());
    EXPECT_EQ(set.contours.size(), island().contours.size());
  }
}

TEST(Edit, SlopesKeepNestingOnRandomCurves) {
  Rng rng(Seed{6});
  for (int trial = 0; trial < 8; ++trial) {
    const SlopeTool slope{.stroke = random_stroke(rng, 1 + trial % 4, 7000),
                          .radius_m = rng.uniform(500, 2500),
                          .strength = rng.uniform(-1.0, 1.0)};
    EXPECT_TRUE(is_sound(edited(island(), {slope}))) << trial;
  }
}

TEST(Edit, SlopeBringsContoursTogetherOrApart) {
  ContourSet set{GridFrame::centred(100, 100, 100), {}};
  for (int i = 0; i < 20; ++i) {
    const double w = 4000 - 150 * i;
    set.contours.push_back({10.0 * i, geom::densify({{-w, -w}, {w, -w}, {w, w}, {-w, w}}, 100), i - 1});
  }
  const auto spacing_at_stroke = [&](double strength) {
    const SlopeTool slope{.stroke = {{-2800, -1000}, {-2800, 1000}}, .radius_m = 700, .strength = strength};
    const ContourSet made = edited(set, {slope});
    std::vector<double> x;  // of contours along y = 0
    for (const Contour& contour : made.contours) {
      for (size_t i = 0; i < contour.ring.size(); ++i) {
        const Vec2 a = contour.ring[i];
        const Vec2 b = contour.ring[(i + 1) % contour.ring.size()];
        if ((a.y > 0) != (b.y > 0) && a.x < 0) x.push_back(a.x);
      }
    }
    std::sort(x.begin(), x.end());
    const auto after = std::upper_bound(x.begin(), x.end(), -2800 - 250) - x.begin();
    return x[static_cast<size_t>(after) + 1] - x[static_cast<size_t>(after)];
  };
  EXPECT_LT(spacing_at_stroke(0.8), 140);
  EXPECT_NEAR(spacing_at_stroke(0), 150, 1e-6);
  EXPECT_GT(spacing_at_stroke(-0.8), 160);
}

TEST(Edit, FractalizeKeepsNestingAndRoughensNeighboursAlike) {
  const ContourSet set = edited(island(), {FractalizeTool{.amplitude_m = 150, .wavelength_m = 900, .octaves = 4}});
  EXPECT_TRUE(is_sound(set));
  EXPECT_GT(geom::ring_length(set.contours[0].ring), 1.1 * geom::ring_length(island().contours[0].ring));
  const Polygon where = disc({2000, 1000}, 2500);
  const ContourSet local = edited(island(), {FractalizeTool{.within = {where}, .amplitude_m = 150}});
  EXPECT_TRUE(is_sound(local));
  EXPECT_FALSE(local == island());
}

TEST(Edit, FractalizeIsBoundedBySayingSo) {
  const ContourSet small = noise_contours(11, 60, 200);
  for (const FractalizeTool& tool :
       {FractalizeTool{.amplitude_m = 1e5},
        FractalizeTool{.amplitude_m = 3000, .wavelength_m = 5000, .octaves = 3, .gain = 1.0}}) {
    std::vector<std::string> notes;
    EXPECT_TRUE(is_sound(edited(small, {tool}, OnCrossing::limit, &notes)));
    ASSERT_FALSE(notes.empty());
    EXPECT_THAT(notes[0], HasSubstr("edits[0] (fractalize): "));
    EXPECT_THAT(notes[0], HasSubstr("; applied with "));
    EXPECT_NE(error_of(small, {tool}, OnCrossing::refuse), "");
  }
  EXPECT_THAT(error_of(island(), {FractalizeTool{.amplitude_m = 0.3, .wavelength_m = 1, .octaves = 1}}),
              HasSubstr("edits[0].wavelength_m: 1 is too short for "));
}

TEST(Edit, DeletedContoursLeaveTheTreeSound) {
  const ContourSet set = edited(island(), {DeleteTool{{.low_m = 300, .high_m = 500}}});
  EXPECT_TRUE(is_sound(set));
  EXPECT_LT(set.contours.size(), island().contours.size());
  for (const Contour& contour : set.contours) EXPECT_TRUE(contour.height_m < 300 || contour.height_m > 500);
}

TEST(Edit, SelectsByHeightAreaPlaceNumberAndPolygon) {
  const ContourSet& set = island();
  EXPECT_EQ(select(set, {}, "s").size(), set.contours.size());
  for (const size_t i : select(set, {.low_m = 200, .high_m = 200}, "s")) EXPECT_EQ(set.contours[i].height_m, 200);
  for (const size_t i : select(set, {.min_area_m2 = 1e7}, "s"))
    EXPECT_GE(std::abs(geom::signed_area(set.contours[i].ring)), 1e7);
  EXPECT_EQ(select(set, {.at = {set.contours[7].ring[0]}}, "s"), std::vector<size_t>{7});
  EXPECT_EQ(select(set, {.index = {4, 2}}, "s"), (std::vector<size_t>{2, 4}));
  EXPECT_EQ(select(set, {.index = {0}, .inner = true}, "s").size() > 1, true);
  const Polygon polygon = disc({}, 6000);
  const std::vector<size_t> within = select(set, {.within = {polygon}}, "s");
  ASSERT_FALSE(within.empty());
  for (const size_t i : within)
    for (const Vec2 p : set.contours[i].ring) EXPECT_TRUE(geom::contains(polygon, p));
}

TEST(Edit, PatternsHoldWhatLiesWithinTheOutline) {
  const Polygon outline = disc({1500, -800}, 2800);
  const Drawing pattern = make_pattern(island(), {outline, -1});
  check_pattern(pattern, "pattern");
  const geom::Box box = geom::bounding_box(outline.outer);
  const Vec2 middle = 0.5 * (box.low + box.high);
  const double spare = 0.06 * std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const Ring around = {{box.low.x - spare, box.low.y - spare},
                       {box.high.x + spare, box.low.y - spare},
                       {box.high.x + spare, box.high.y + spare},
                       {box.low.x - spare, box.high.y + spare}};
  double length = 0.0;
  for (const ValuedLine& line : pattern.lines) {
    length += line.closed ? geom::ring_length(line.points) : geom::line_length(line.points);
    for (size_t i = 1; i < line.points.size(); ++i)
      EXPECT_TRUE(geom::contains(around, middle + 0.5 * (line.points[i] + line.points[i - 1])));
  }
  double expected = 0.0;
  for (const Contour& contour : island().contours) {
    const Ring fine = geom::densify(contour.ring, 5);
    for (size_t i = 0; i < fine.size(); ++i) {
      const Vec2 a = fine[i];
      const Vec2 b = fine[(i + 1) % fine.size()];
      if (geom::contains(around, 0.5 * (a + b))) expected += std::hypot(b.x - a.x, b.y - a.y);
    }
  }
  EXPECT_NEAR(length, expected, 0.01 * expected);
}

/// Mean distance of the contours of one set to those of the same height in the other, within a polygon.
double mean_distance(const ContourSet& a, const ContourSet& b, const Polygon& within) {
  double sum = 0.0;
  double count = 0.0;
  for (const Contour& contour : a.contours) {
    for (size_t i = 0; i < contour.ring.size(); i += 3) {
      const Vec2 p = contour.ring[i];
      if (!geom::contains(within, p)) continue;
      double best = 1e9;
      for (const Contour& other : b.contours) {
        if (other.height_m != contour.height_m) continue;
        for (size_t j = 0; j < other.ring.size(); ++j) {
          const Vec2 q = other.ring[j];
          const Vec2 d = other.ring[(j + 1) % other.ring.size()] - q;
          const double t = std::clamp(dot(p - q, d) / dot(d, d), 0.0, 1.0);
          const Vec2 off = p - (q + t * d);
          best = std::min(best, dot(off, off));
        }
      }
      sum += std::sqrt(best);
      count += 1.0;
    }
  }
  return sum / count;
}

TEST(Edit, CopyAndPasteInPlaceIsARoundTrip) {
  const Polygon outline = disc({1500, -800}, 2800);
  const geom::Box box = geom::bounding_box(outline.outer);
  const ContourSet set =
      edited(island(), {CopyTool{.within = {outline}}, PasteTool{.at = 0.5 * (box.low + box.high), .blend_m = 0}});
  EXPECT_TRUE(is_sound(set));
  EXPECT_LT(mean_distance(set, island(), outline), 12.0);  // the lattice's cells are 56 m
  EXPECT_LT(mean_distance(island(), set, disc({1500, -800}, 2600)), 12.0);
}

TEST(Edit, CutAndPasteBackIsARoundTrip) {
  const Polygon outline = disc({-1500, 2000}, 2500);
  const geom::Box box = geom::bounding_box(outline.outer);
  const Edit cut = CutTool{CopyTool{.within = {outline}}};
  EXPECT_TRUE(is_sound(edited(island(), {cut})));
  const ContourSet back = edited(island(), {cut, PasteTool{.at = 0.5 * (box.low + box.high), .blend_m = 0}});
  EXPECT_TRUE(is_sound(back));
  EXPECT_LT(mean_distance(back, island(), disc({-1500, 2000}, 2200)), 40.0);
}

TEST(Edit, PastesAnywhereAtAnyTurnAndScale) {
  Rng rng(Seed{9});
  const Drawing pattern = make_pattern(noise_contours(12, 150, 45), {disc({0, 0}, 3000), -1});
  for (int trial = 0; trial < 10; ++trial) {
    const PasteTool paste{.at = Vec2{rng.uniform(-5000, 5000), rng.uniform(-5000, 5000)},
                          .rotation_deg = rng.uniform(-180, 180),
                          .scale = rng.uniform(0.3, 1.2),
                          .height_scale = rng.uniform(-1.5, 2.5),
                          .raise_m = rng.uniform(-100, 100),
                          .blend_m = rng.uniform(0, 800)};
    const ContourSet set = edit(island(), {{paste, paste}}, {&pattern, {}}, Seed{1}, {});
    EXPECT_TRUE(is_sound(set)) << trial;
    EXPECT_FALSE(set == island());
  }
}

TEST(Edit, FillsAContourWithGroundOfItsSurroundings) {
  // The largest contour of 440 m that holds others.
  int chosen = -1;
  for (size_t i = 0; i < island().contours.size(); ++i) {
    const Contour& contour = island().contours[i];
    if (contour.height_m != 440.0 || !geom::is_hill(contour)) continue;
    if (chosen < 0 ||
        geom::signed_area(contour.ring) > geom::signed_area(island().contours[static_cast<size_t>(chosen)].ring))
      chosen = static_cast<int>(i);
  }
  ASSERT_GE(chosen, 0);
  const Contour& own = island().contours[static_cast<size_t>(chosen)];
  const ContourSet set = edited(island(), {FillTool{.select = {.index = {chosen}}, .wavelength_m = 2000}});
  EXPECT_TRUE(is_sound(set));
  size_t inside = 0;
  for (const Contour& contour : set.contours) {
    if (!geom::contains(own.ring, contour.ring[0]) || contour.ring == own.ring) continue;
    EXPECT_GT(contour.height_m, own.height_m);
    EXPECT_TRUE(geom::is_hill(contour)) << "a basin";
    ++inside;
  }
  EXPECT_GT(inside, 0U);
}

TEST(Edit, FillsAPolygonAcrossContours) {
  for (uint64_t seed = 0; seed < 3; ++seed) {
    const Polygon outline = disc({2500.0 - 2000.0 * static_cast<double>(seed), 1500}, 2200);
    const ContourSet set = edited(island(), {FillTool{.within = {outline}}, FillTool{.within = {outline}}});
    EXPECT_TRUE(is_sound(set)) << seed;
    EXPECT_FALSE(set == island());
  }
}

TEST(Edit, AFoldingSlopeIsLimitedOrRefusedWithThePossibleStrength) {
  // A hairpin narrower than the tool: space folds at its middle.
  const SlopeTool slope{
      .stroke = {{-3000, -700}, {2500, -650}, {2600, 650}, {-3000, 700}}, .radius_m = 2000, .strength = -1};
  std::vector<std::string> notes;
  const ContourSet set = edited(island(), {slope}, OnCrossing::limit, &notes);
  EXPECT_TRUE(is_sound(set));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], HasSubstr("edits[0] (slope): contours would cross at ("));
  EXPECT_THAT(error_of(island(), {slope}, OnCrossing::refuse),
              HasSubstr("edits[0].strength: contours would cross at ("));
  EXPECT_THAT(error_of(island(), {slope}, OnCrossing::refuse), HasSubstr("nothing crosses up to -0"));
}

TEST(Edit, SaysWhatIsWrong) {
  EXPECT_THAT(
      error_of(island(), {WarpTool{.stroke = {{0, 0}, {99000, 0}}}}),
      HasSubstr("edits[0].stroke: point 1 (99000, 0) is outside the domain, which reaches from (-10240, -10240)"));
  EXPECT_EQ(error_of(island(), {WarpTool{.stroke = {{0, 0}, {0, 0}}}}),
            "edits[0].stroke: has 1 different points; it needs at least 2");
  EXPECT_THAT(
      error_of(island(), {WarpTool{.stroke = {{0, 0}, {500, 0}}, .k = 1, .step_m = 300}}),
      HasSubstr("edits[0].step_m: 300 would fold space: a drag of radius 500 m is one to one up to steps of 250"));
  EXPECT_THAT(error_of(island(), {WarpTool{.stroke = {{0, 0}, {9000, 0}}, .radius_m = 0.2}}), HasSubstr("too small"));
  EXPECT_THAT(error_of(island(), {DeleteTool{}}), HasSubstr("edits[0].select: says nothing"));
  EXPECT_THAT(error_of(island(), {DeleteTool{{.low_m = 8000}}}),
              HasSubstr("edits[0].select: there is no such contour: heights from 8000 m"));
  EXPECT_THAT(error_of(island(), {DeleteTool{{.index = {123456}}}}), HasSubstr("there is no contour 123456"));
  EXPECT_THAT(error_of(island(), {PasteTool{}}), HasSubstr("there is nothing to paste"));
  EXPECT_THAT(error_of(island(), {CopyTool{}}), HasSubstr("needs \"within\""));
  EXPECT_THAT(error_of(island(), {FillTool{.within = {{{{0, 0}, {900, 900}, {900, 0}, {0, 900}}, {}}}}}),
              HasSubstr("cross or touch"));
  EXPECT_THAT(error_of(island(), {SmoothTool{.radius_m = -1}}), HasSubstr("edits[0].radius_m: -1 is outside [0.01, 1"));
}

TEST(Edit, SaysWhereContoursCrossAlready) {
  ContourSet set{GridFrame::centred(100, 100, 100), {}};
  set.contours.push_back({0, {{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}}, -1});
  set.contours.push_back({10, {{-500, -500}, {1500, -500}, {1500, 500}, {-500, 500}}, 0});
  EXPECT_THAT(error_of(set, {WarpTool{.stroke = {{800, 0}, {1200, 0}}}}),
              HasSubstr("cross already before the edit, at (1000,"));
  EXPECT_THAT(error_of(set, {SmoothTool{}}), HasSubstr("cross already before the edit"));
}

TEST(Edit, IsTheSameOnAnyNumberOfThreads) {
  const std::vector<Edit> edits = {WarpTool{.stroke = {{-4000, 0}, {0, 2000}, {4000, 0}}}, FractalizeTool{.octaves = 2},
                                   SmoothTool{}, FillTool{.within = {disc({1000, 1000}, 2000)}}};
  const ContourSet one = edit(island(), {edits}, {}, Seed{1}, {.threads = 1});
  EXPECT_EQ(edit(island(), {edits}, {}, Seed{1}, {.threads = 2}), one);
}

}  // namespace
}  // namespace seamount::contour
