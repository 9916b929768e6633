// New ground within an outline beside the old: no walls, no lakes, heights like those that were there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seamount/geom/grid/resample.h"
#include "seamount/geom/polygon/polygon.h"
#include "seamount/geom/scalar/noise.h"
#include "seamount/ops/contour/convert/extract.h"
#include "seamount/ops/contour/convert/reconstruct.h"
#include "seamount/ops/contour/edit/edit.h"
#include "seamount/ops/contour/edit/match.h"
#include "seamount/ops/contour/edit/outflow.h"
#include "seamount/ops/contour/edit/pattern.h"
#include "seamount/ops/contour/move/test_contours.h"

namespace seamount::contour {
namespace {

using ::testing::HasSubstr;

constexpr double kInterval = 40.0;

/// A range that a valley comes through from east to west, with side valleys.
HeightField range(uint64_t seed) {
  HeightField z = geom::fbm_grid(GridFrame::centred(220, 220, 60.0), Seed{seed},
                                 {.wavelength_m = 2500, .octaves = 5, .gain = 0.45, .cell_m = 120}, {});
  for (int y = 0; y < z.height(); ++y) {
    for (int x = 0; x < z.width(); ++x) {
      const double east = z.frame().x(x);
      const double off = std::abs(z.frame().y(y) - 500.0 * std::sin(east / 1800.0));
      const double bed = 300.0 + 0.03 * (east + 6600.0);
      const double flank = 800.0 * (1.0 - std::exp(-off / 1500.0));
      z(x, y) = static_cast<float>(bed + flank * (1.0 + 0.6 * static_cast<double>(z(x, y))));
    }
  }
  return z;
}

ContourSet contours_of(const HeightField& z) {
  ExtractParams params;
  params.interval_m = kInterval;
  return extract(z, params, {});
}

const std::vector<Ring> kOutlines = {{{-2000, -1700}, {2000, -1700}, {2000, 1700}, {-2000, 1700}},
                                     {{-4500, -1200}, {-1500, -1500}, {-900, 900}, {-3000, 2000}},
                                     {{1000, 800}, {4500, 800}, {4500, 4300}, {1000, 4300}}};

struct Ground {
  double mean = 0.0, steep = 0.0, pond = 0.0;
};

/// Of heights: the mean within a ring; the share of cells about it that are steeper than 50 degrees.
Ground measure(const HeightField& z, const HeightField& before, const Ring& ring) {
  const EditArea all{Patch(z.frame()), ScalarField(z.frame(), 1.0F), before};
  Ground ground;
  double inside = 0.0;
  double rim = 0.0;
  for (int y = 1; y + 1 < z.height(); ++y) {
    for (int x = 1; x + 1 < z.width(); ++x) {
      const Vec2 p = {z.frame().x(x), z.frame().y(y)};
      if (geom::contains(ring, p)) {
        ground.mean += static_cast<double>(z(x, y));
        inside += 1.0;
      }
      double nearest = 1e9;
      for (size_t i = 0; i < ring.size(); ++i) {
        const Vec2 d = ring[(i + 1) % ring.size()] - ring[i];
        const double t = std::clamp(dot(p - ring[i], d) / dot(d, d), 0.0, 1.0);
        const Vec2 off = p - (ring[i] + t * d);
        nearest = std::min(nearest, std::hypot(off.x, off.y));
      }
      if (nearest > 250.0) continue;
      const float slope = std::hypot(z(x + 1, y) - z(x - 1, y), z(x, y + 1) - z(x, y - 1)) / 120.0F;
      ground.steep += slope > 1.19F ? 1.0 : 0.0;
      rim += 1.0;
    }
  }
  ground.mean /= inside;
  ground.steep /= rim;
  for (const Pond& pond : find_ponds(all, z, 1.0, {})) ground.pond = pond.depth_m;
  return ground;
}

void expect_like(const Edit& tool, const Ring& ring, uint64_t seed, double most_off) {
  const ContourSet set = contours_of(range(seed));
  std::vector<std::string> notes;
  RunContext run;
  run.note = [&](const std::string& line) { notes.push_back(line); };
  const ContourSet made = edit(set, {{tool}}, {}, Seed{seed}, run);
  EXPECT_TRUE(is_sound(made));
  const HeightField before = reconstruct(set, {}, {});
  const HeightField after = reconstruct(made, {}, {});
  const Ground was = measure(before, before, ring);
  const Ground is = measure(after, before, ring);
  EXPECT_NEAR(is.mean, was.mean, most_off);
  EXPECT_LE(is.steep, was.steep + 0.02);
  const bool said = std::any_of(notes.begin(), notes.end(),
                                [](const std::string& note) { return note.find("held back") != std::string::npos; });
  EXPECT_TRUE(said || is.pond <= was.pond + kInterval) << was.pond << " m before, " << is.pond;
}

TEST(ContourFill, BuildsNoWallAndDamsNoValley) {
  for (uint64_t seed = 1; seed <= 2; ++seed) {
    for (size_t i = 0; i < kOutlines.size(); ++i) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", outline " + std::to_string(i));
      expect_like(FillTool{.within = {{kOutlines[i], {}}}}, kOutlines[i], seed, 120.0);
    }
  }
}

TEST(ContourFill, CuttingLeavesNoWallAndDamsNoValley) {
  for (uint64_t seed = 1; seed <= 3; ++seed)
    expect_like(CutTool{{.within = {{kOutlines[0], {}}}}}, kOutlines[0], seed, 120.0);
}

TEST(ContourFill, SaysWhichGroundItTook) {
  const ContourSet set = contours_of(range(4));
  std::vector<std::string> notes;
  RunContext run;
  run.note = [&](const std::string& line) { notes.push_back(line); };
  edit(set, {{FillTool{.within = {{kOutlines[0], {}}}}}}, {}, Seed{1}, run);
  ASSERT_FALSE(notes.empty());
  EXPECT_THAT(notes[0], HasSubstr("edits[0] (fill): took the ground at ("));
  EXPECT_THAT(notes[0], HasSubstr("of these contours"));
}

TEST(ContourFill, ChoosesThePatternOfALibraryThatFits) {
  // Of a pattern of a range and one of a plain: the first.
  const ContourSet set = contours_of(range(5));
  const Drawing own = make_pattern(set, {{{{-6000, -6000}, {6000, -6000}, {6000, 6000}, {-6000, 6000}}, {}}, -1});
  HeightField plane(GridFrame::centred(200, 200, 60.0));
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x) plane(x, y) = static_cast<float>(500.0 + 0.03 * plane.frame().x(x));
  const Polygon whole{{{-5900, -5900}, {5900, -5900}, {5900, 5900}, {-5900, 5900}}, {}};
  const Drawing other = make_pattern(contours_of(plane), {whole, -1});
  const auto read = [&](const FilePath& file) { return file.path == "own" ? own : other; };
  std::vector<std::string> notes;
  RunContext run;
  run.note = [&](const std::string& line) { notes.push_back(line); };
  const ContourSet made = edit(set, {{FillTool{.within = {{kOutlines[0], {}}}, .files = {{"other"}, {"own"}}}}},
                               {nullptr, read}, Seed{1}, run);
  EXPECT_TRUE(is_sound(made));
  ASSERT_FALSE(notes.empty());
  EXPECT_THAT(notes[0], HasSubstr(" of own"));
}

TEST(ContourFill, LeavesAPlainWithoutContoursAlone) {
  ContourSet set{GridFrame::centred(100, 100, 100), {}};
  set.contours.push_back({50, {{3000, 3000}, {4500, 3000}, {4500, 4500}, {3000, 4500}}, -1});
  set.contours.push_back({60, {{3300, 3300}, {4200, 3300}, {4200, 4200}, {3300, 4200}}, 0});
  const Polygon outline{{{-3000, -3000}, {-1000, -3000}, {-1000, -1000}, {-3000, -1000}}, {}};
  EXPECT_EQ(edit(set, {{FillTool{.within = {outline}}}}, {}, Seed{1}, {}), set);
}

TEST(FindMatch, FindsGroundThatWasTurnedMirroredAndRaised) {
  const HeightField source = range(6);
  for (const bool mirrored : {false, true}) {
    const Placement placed{.from = {1500, -2200}, .at = {100, 200}, .turn = {0.8, 0.6}, .mirrored = mirrored};
    ScalarField ground(GridFrame::centred(80, 80, 60.0));
    for (int y = 0; y < ground.height(); ++y) {
      for (int x = 0; x < ground.width(); ++x) {
        const Vec2 p = placed.to_source({ground.frame().x(x), ground.frame().y(y)});
        ground(x, y) = 77.0F + geom::sample_bilinear(source, source.frame().column(p.x), source.frame().row(p.y));
      }
    }
    const Polygon outline{{{-1400, -1200}, {1600, -1200}, {1600, 1600}, {-1400, 1600}}, {}};
    const auto found =
        find_match(ground, ground, outline, {{source, ScalarField(source.frame(), 1.0F), 1.0}}, Seed{1}, {});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->placement.mirrored, mirrored);
    EXPECT_LT(found->misfit_m, 25.0);
    EXPECT_LT(std::hypot(found->placement.from.x - 1500, found->placement.from.y + 2200), 200.0);
  }
}

TEST(FindMatch, NothingHasRoomForALargeOutline) {
  const HeightField source = range(7);
  const Polygon outline{{{-6000, -6000}, {6000, -6000}, {6000, 6000}, {-6000, 6000}}, {}};
  EXPECT_FALSE(find_match(source, source, outline, {{source, ScalarField(source.frame(), -1.0F), 1.0}}, Seed{1}, {}));
}

}  // namespace
}  // namespace seamount::contour
