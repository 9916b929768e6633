#include "seamount/ops/learned/sketch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/base/error.h"
#include "seamount/geom/solve/drain.h"
#include "seamount/ops/learned/island.h"
#include "seamount/ops/learned/sketch_map.h"
#include "seamount/ops/learned/sketch_planes.h"
#include "seamount/ops/learned/test_network.h"

namespace seamount::learned {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Small, and its plane about a tenth of the relief.
Network network_of(int planes, uint64_t seed = 1) {
  const Architecture architecture{planes, {8, 16, 24}};
  Weights weights = random_weights(architecture, seed);
  for (float& w : weights.tensors["outer.weight"].values) w *= 0.1F;
  return Network(weights, Precision::f32);
}

HeightField hills(const GridFrame& frame) {
  HeightField z(frame);
  for (int y = 0; y < z.height(); ++y) {
    for (int x = 0; x < z.width(); ++x)
      z(x, y) = 900 + 200 * std::sin(0.11F * static_cast<float>(x)) * std::cos(0.07F * static_cast<float>(y));
  }
  return z;
}

TEST(LearnedSketch, MeetsDrawnHeightsAndKeepsKnownGround) {
  const Network network = network_of(kSketchPlanes);
  for (const auto& [width, height] : {std::pair{100, 70}, {64, 64}, {33, 150}}) {
    const GridFrame frame = GridFrame::centred(width, height, 60);
    SketchParams params;
    params.heights = {{60, -120, 1800}, {-900, 600, 700}};
    params.ridges = {{{{-1800, 0}, {1500, 900}}}};
    params.low_m = 300;
    params.relief_m = 1500;
    const HeightField drawn = sketch({}, params, network, frame, Seed{4}, {});
    for (const SketchedHeight& h : params.heights) {
      const int x = static_cast<int>(std::lround(frame.column(h.x_m))),
                y = static_cast<int>(std::lround(frame.row(h.y_m)));
      EXPECT_NEAR(drawn(x, y), h.height_m, 0.01);
    }
    params.adherence = 0;
    const HeightField free = sketch({}, params, network, frame, Seed{4}, {});
    EXPECT_GT(std::abs(free(width / 2 + 1, height / 2 + 2) - 1800), 1);

    HeightField known = hills(frame);
    ScalarField erase(frame, 0.0F);
    for (int y = height / 4; y < height / 2; ++y) {
      for (int x = width / 4; x < width / 2; ++x) erase(x, y) = 1;
    }
    known(1, 1) = kNone;
    SketchInputs inputs;
    inputs.terrain = &known;
    inputs.erase = &erase;
    const HeightField filled = sketch(inputs, {}, network, frame, Seed{4}, {});
    for (size_t i = 0; i < filled.size(); ++i) {
      ASSERT_TRUE(std::isfinite(filled.data()[i]));
      const bool stays = erase.data()[i] == 0 && !std::isnan(known.data()[i]);
      if (stays) {
        EXPECT_EQ(filled.data()[i], known.data()[i]);
      }
    }
  }
}

TEST(LearnedSketch, ASeedIsAVariationAndThreadsDoNotCount) {
  const Network network = network_of(kSketchPlanes);
  const GridFrame frame = GridFrame::centred(90, 80, 30);
  RunContext one;
  one.threads = 1;
  const HeightField a = sketch({}, {}, network, frame, Seed{1}, one);
  EXPECT_EQ(a, sketch({}, {}, network, frame, Seed{1}, {}));
  EXPECT_NE(a, sketch({}, {}, network, frame, Seed{2}, {}));
}

TEST(LearnedSketch, ReadsLinesPicturesAndAreas) {
  const GridFrame frame = GridFrame::centred(40, 30, 10);
  Drawing lines;
  lines.lines = {{{{-150, 0}, {150, 0}}, 0}, {{{0, -100}, {0, 100}}, 1}};
  lines.points = {{{55, 45}, 812}};
  lines.areas = {{"high", {{{{20, 20}, {120, 20}, {120, 120}, {20, 120}}, {}}}}};
  Image image(80, 60);
  image.pixel(20, 10)[0] = 255;
  image.pixel(60, 50)[2] = 255;
  SketchInputs inputs;
  inputs.lines = &lines;
  inputs.image = &image;
  const SketchMap map = map_of(inputs, {}, frame, {});
  EXPECT_EQ(map.river(10, 15) + map.river(10, 14), 1);
  EXPECT_EQ(map.ridge(20, 5) + map.ridge(19, 5), 1);
  EXPECT_EQ(map.ridge(10, 5), 1);
  EXPECT_EQ(map.river(30, 25), 1);
  EXPECT_EQ(map.cue_m(25, 10), 812);
  EXPECT_EQ(map.level(25, 10), 1);
  EXPECT_EQ(map.level(5, 25), -1);
  lines.lines[0].value = 7;
  EXPECT_THROW(map_of(inputs, {}, frame, {}), InvalidArgument);
}

TEST(LearnedSketch, RefusesWhatDoesNotFit) {
  const GridFrame frame = GridFrame::centred(40, 30, 10);
  EXPECT_THROW(sketch({}, {}, network_of(kSketchPlanes - 1), frame, Seed{1}, {}), InvalidArgument);
  const ScalarField other(GridFrame::centred(10, 30, 10), 0.0F);
  SketchInputs inputs;
  inputs.river = &other;
  EXPECT_THROW(sketch(inputs, {}, network_of(kSketchPlanes), frame, Seed{1}, {}), IncompatibleInputs);
}

TEST(LearnedSketch, SaysWhatLiesBesideTheDomain) {
  const GridFrame frame = GridFrame::centred(40, 30, 10);
  SketchParams params;
  params.heights = {{0, 0, 500}, {5000, 0, 500}};
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said += line + "\n"; };
  map_of({}, params, frame, run);
  EXPECT_NE(said.find("1 of 2 lines and heights"), std::string::npos) << said;
  params.heights.erase(params.heights.begin());
  EXPECT_THROW(map_of({}, params, frame, run), InvalidArgument);
  const ScalarField erase(frame, 1.0F);
  SketchInputs inputs;
  inputs.erase = &erase;
  EXPECT_THROW(map_of(inputs, {}, frame, run), InvalidArgument);
}

TEST(LearnedSketch, SaysWhereNothingIsLeftToMake) {
  HeightField known = hills(GridFrame::centred(40, 30, 10));
  std::string said;
  RunContext run;
  run.note = [&](const std::string& line) { said += line + "\n"; };
  SketchInputs inputs;
  inputs.terrain = &known;
  map_of(inputs, {}, known.frame(), run);
  EXPECT_NE(said.find("all ground is known and stays"), std::string::npos) << said;
  said.clear();
  known(7, 8) = kNone;
  map_of(inputs, {}, known.frame(), run);
  EXPECT_EQ(said, "");
}

/// Lines of a drawing, those of the parameters, pictures and grids add up.
TEST(LearnedSketch, DrawnLinesAndThoseOfParametersAddUp) {
  const GridFrame frame = GridFrame::centred(40, 30, 10);
  Drawing lines;
  lines.lines = {{{{-150, 100}, {150, 100}}, 1}};
  SketchParams params;
  params.ridges = {{{{-150, -100}, {150, -100}}}};
  SketchInputs inputs;
  inputs.lines = &lines;
  const SketchMap map = map_of(inputs, params, frame, {});
  for (const int y : {static_cast<int>(std::lround(frame.row(100))), static_cast<int>(std::lround(frame.row(-100)))})
    EXPECT_EQ(map.ridge(20, y), 1);
}

TEST(LearnedSketch, AHoleInAPlainIsFilledAtThePlainsScale) {
  HeightField plain(GridFrame::centred(80, 60, 90), 200.0F);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 80; ++x) plain(x, y) += 3 * std::sin(0.2F * static_cast<float>(x)) + static_cast<float>(y) / 20;
  }
  for (int y = 20; y < 40; ++y) {
    for (int x = 20; x < 50; ++x) plain(x, y) = kNone;
  }
  SketchInputs inputs;
  inputs.terrain = &plain;
  const SketchMap map = map_of(inputs, {}, plain.frame(), {});
  EXPECT_LT(map.relief_m, 15);
  const HeightField filled = sketch(inputs, {}, network_of(kSketchPlanes), plain.frame(), Seed{1}, {});
  for (const float z : filled.cells()) EXPECT_NEAR(z, 202, 25);
}

TEST(LearnedSketch, AnAbsentKindIsAnEmptyPlane) {
  SketchMap map;
  map.frame = GridFrame::centred(20, 20, 60);
  const SketchPlanes planes(map, Seed{3}, {});
  std::vector<float> values(400 * kSketchPlanes);
  planes.planes().fill(0, 20, values);
  for (size_t cell = 0; cell < 400; ++cell) {
    for (size_t p = 0; p < 9; ++p) EXPECT_EQ(values[cell * kSketchPlanes + p], 0);
    EXPECT_FLOAT_EQ(values[cell * kSketchPlanes + 9], 0.35F);
    EXPECT_EQ(values[cell * kSketchPlanes + 14], 0);
    EXPECT_EQ(values[cell * kSketchPlanes + 15], 0);
  }
}

TEST(LearnedSketch, KnownGroundIsInTheBaseAlone) {
  SketchMap map;
  map.known_m = hills(GridFrame::centred(20, 20, 60));
  map.known_m(4, 5) = kNone;
  map.frame = map.known_m.frame();
  const SketchPlanes planes(map, Seed{3}, {});
  std::vector<float> values(400 * kSketchPlanes);
  planes.planes().fill(0, 20, values);
  for (size_t cell = 0; cell < 400; ++cell) {
    const float* const p = values.data() + cell * kSketchPlanes;
    EXPECT_EQ(p[7], 0);
    EXPECT_EQ(p[8], 0);
    if (cell == 5 * 20 + 4) continue;
    EXPECT_NEAR(p[9], (map.known_m.data()[cell] - map.low_m) / map.relief_m, 1e-5);
  }
}

TEST(LearnedIsland, SharesSumToOneAndCodesComeBack) {
  LabelMap labels(GridFrame::centred(50, 41, 80), Region::abyss);
  for (int y = 10; y < 30; ++y) {
    for (int x = 12; x < 33; ++x) labels(x, y) = x < 20 ? Region::mountain : Region::reef;
  }
  IslandMap map;
  map.frame = labels.frame();
  map.shares = shares_of(labels, {});
  for (size_t i = 0; i < labels.size(); ++i) {
    float sum = 0;
    for (const Mask& share : map.shares) sum += share.data()[i];
    EXPECT_NEAR(sum, 1, 1e-6F);
  }
  for (const double z : {-1500.0, -20.0, 0.0, 3.0, 2400.0})
    EXPECT_NEAR(island_height_m(island_code(z, 0.4), 0.4), z, 1e-3 * std::abs(z) + 1e-9);
  const HeightField a = island(map, network_of(kIslandPlanes), Seed{1}, {});
  for (const float z : a.cells()) EXPECT_TRUE(std::isfinite(z));
  EXPECT_NE(a, island(map, network_of(kIslandPlanes), Seed{2}, {}));
  EXPECT_THROW(island(map, network_of(kIslandPlanes + 1), Seed{1}, {}), InvalidArgument);
}

TEST(LearnedSketch, OpensShallowHollowsButThoseThatAreDrawnOrKnown) {
  const Network network = network_of(kSketchPlanes);
  const GridFrame frame = GridFrame::centred(96, 96, 60);
  SketchParams params;
  params.low_m = 0;
  params.relief_m = 1000;
  params.heights = {{30, 30, -400}};
  HeightField known(frame, kNone);
  for (int y = 10; y < 15; ++y)
    for (int x = 10; x < 15; ++x) known(x, y) = y == 12 && x == 12 ? 200.0F : 210.0F;
  const HeightField made = sketch({.terrain = &known}, params, network, frame, Seed{1}, {});
  EXPECT_EQ(made(12, 12), 200);
  int shallow = 0;
  bool drawn = false;
  for (const int64_t sink : geom::find_sinks(made, {})) {
    const auto x = static_cast<int>(sink % 96), y = static_cast<int>(sink / 96);
    const double from_drawn = std::hypot(frame.x(x) - 30, frame.y(y) - 30);
    drawn |= from_drawn < 130;
    if (from_drawn < 130 || (x >= 10 && x < 15 && y >= 10 && y < 15)) continue;
    HeightField rest = made;
    geom::drain_shallow(rest, {sink}, 11, {});
    shallow += rest != made && rest.data()[sink] != made.data()[sink];
  }
  EXPECT_TRUE(drawn) << "a basin that is drawn keeps its water";
  EXPECT_EQ(shallow, 0);
}

TEST(SketchGuide, WideCellsHoldWhatIsDrawnInThem) {
  SketchMap map;
  map.frame = GridFrame::centred(10, 9, 50);
  map.river = Grid<uint8_t>(map.frame, 0);
  map.river(5, 1) = 1;
  map.cue = Grid<uint8_t>(map.frame, 0);
  map.cue_m = ScalarField(map.frame, 0.0F);
  map.cue(0, 8) = map.cue(1, 8) = 1;
  map.cue_m(0, 8) = 100;
  map.cue_m(1, 8) = 300;
  map.known_m = HeightField(map.frame, kNone);
  map.known_m(9, 0) = 70;
  map.level = Grid<int8_t>(map.frame, 0);
  map.level(4, 4) = -1;
  map.relief_m = 400;
  const SketchMap wide = coarser(map);
  EXPECT_EQ(wide.frame.width, 3);
  EXPECT_EQ(wide.frame.height, 3);
  EXPECT_EQ(wide.frame.cell_m, 200);
  EXPECT_EQ(wide.frame.west_m, map.frame.west_m);
  EXPECT_EQ(wide.river(1, 0), 1);
  EXPECT_EQ(wide.river(0, 0), 0);
  EXPECT_TRUE(wide.ridge.empty());
  EXPECT_EQ(wide.cue(0, 2), 1);
  EXPECT_EQ(wide.cue_m(0, 2), 200);
  EXPECT_EQ(wide.known_m(2, 0), 70);
  EXPECT_TRUE(std::isnan(wide.known_m(0, 0)));
  EXPECT_EQ(wide.level(1, 1), -1);
  EXPECT_EQ(wide.relief_m, 400);
}

TEST(SketchGuide, FillsWideGapsAloneAndFarFromStrokes) {
  const GridFrame frame = GridFrame::centred(200, 180, 40);
  SketchMap map;
  map.frame = frame;
  map.ridge = Grid<uint8_t>(frame, 0);
  draw_cells({{-3900, 1000}, {3900, 1000}}, map.ridge);
  const auto distance = distance_in_gaps(map, {});
  ASSERT_TRUE(distance);
  const SketchMap before = map;
  Drawing guide;
  guide.lines = {{{{20, -3500}, {20, 3500}}, 0}};
  guide.points = {{{100, 1100}, 900}, {{-2000, -2000}, 400}};
  add_guide(guide, *distance, map);
  EXPECT_EQ(map.ridge, before.ridge);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (std::abs(std::abs(frame.y(y)) - 3500) < 60) continue;  // its ends
      const bool line = x == static_cast<int>(std::lround(frame.column(20))) && std::abs(frame.y(y)) < 3500;
      const bool far = std::abs(frame.y(y) - 1000) > 17 * 40;
      if (line && far) {
        EXPECT_EQ(map.river(x, y), 1);
      }
      if (!line || std::abs(frame.y(y) - 1000) < 15 * 40) {
        EXPECT_EQ(map.river(x, y), 0);
      }
    }
  }
  int cues = 0;
  for (const uint8_t cue : map.cue.cells()) cues += cue;
  EXPECT_EQ(cues, 1) << "the height beside the stroke is left out";

  for (int y = 0; y < frame.height; y += 20) draw_cells({{-3900, frame.y(y)}, {3900, frame.y(y)}}, map.ridge);
  EXPECT_FALSE(distance_in_gaps(map, {}));
  map = before;
  map.frame.cell_m = 150;
  map.ridge.set_frame(map.frame);
  EXPECT_FALSE(distance_in_gaps(map, {})) << "wide cells would be wider than what the network knows";
}

TEST(SketchGuide, DrawnHeightsStayMetAndThreadsDoNotCount) {
  const Network network = network_of(kSketchPlanes);
  const GridFrame frame = GridFrame::centred(260, 200, 60);
  SketchParams params;
  params.heights = {{60, -120, 1800}};
  params.low_m = 300;
  params.relief_m = 1500;
  int calls = 0;
  const Redraw redraw = [&](const HeightField& rough, double least_m2, Seed, const RunContext&) {
    ++calls;
    EXPECT_NEAR(least_m2, 16.0 * 240 * 240, 1);
    EXPECT_NEAR(rough.frame().west_m, frame.west_m, 1e-6);
    Drawing guide;
    guide.lines = {{{{-7000, -5000}, {7000, -4800}}, 1}};
    return guide;
  };
  RunContext one;
  one.threads = 1;
  const HeightField a = sketch({.redraw = redraw}, params, network, frame, Seed{4}, {});
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(a, sketch({.redraw = redraw}, params, network, frame, Seed{4}, one));
  EXPECT_NE(a, sketch({}, params, network, frame, Seed{4}, {}));
  EXPECT_NEAR(a(static_cast<int>(std::lround(frame.column(60))), static_cast<int>(std::lround(frame.row(-120)))), 1800,
              0.01);
}

TEST(LearnedIsland, SpecksVanishAndStripsStay) {
  LabelMap labels(GridFrame::centred(30, 20, 80), Region::abyss);
  labels(7, 7) = Region::mountain;
  labels(20, 10) = labels(21, 11) = Region::lagoon;
  for (int x = 0; x < 30; ++x) labels(x, 15) = Region::beach;
  std::array<Mask, kRegionCount> shares;
  for (size_t region = 0; region < kRegionCount; ++region) {
    shares[region] = Mask(labels.frame(), 0.0F);
    for (size_t i = 0; i < labels.size(); ++i)
      shares[region].data()[i] = static_cast<size_t>(labels.data()[i]) == region;
  }
  const auto clean = without_specks(shares, {});
  EXPECT_EQ(clean[static_cast<size_t>(Region::mountain)](7, 7), 0);
  EXPECT_EQ(clean[static_cast<size_t>(Region::abyss)](7, 7), 1);
  EXPECT_LT(clean[static_cast<size_t>(Region::lagoon)](20, 10), 0.2F);
  for (int x = 1; x < 29; ++x) EXPECT_EQ(clean[static_cast<size_t>(Region::beach)](x, 15), 1);
}

TEST(LearnedIsland, MeetsCoastsPeaksFloorsAndReefs) {
  LabelMap labels(GridFrame::centred(128, 128, 80), Region::abyss);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const double r = std::hypot(x - 64, y - 64);
      labels(x, y) = r < 20   ? Region::mountain
                     : r < 24 ? Region::beach
                     : r < 34 ? Region::lagoon
                     : r < 40 ? Region::reef
                              : Region::abyss;
    }
  }
  IslandMap map;
  map.frame = labels.frame();
  map.shares = shares_of(labels, {});
  map.peak_m = 1234;
  map.floor_m = -1500;
  map.reef_depth_m = 2.5;
  Weights weights = random_weights(Architecture{kIslandPlanes, {8, 16, 24}}, 3);
  for (float& w : weights.tensors["outer.weight"].values) w *= 0.01F;
  weights.tensors["outer.bias"].values[0] = -0.1F;  // some ten metres under water
  const Network network(weights, Precision::f32);
  const HeightField heights = island(map, network, Seed{1}, {});
  int both = 0, either = 0, off = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const double r = std::hypot(x - 64, y - 64);
      const bool land = r < 24;
      both += land && r > 20 && heights(x, y) > 0;
      either += land && r > 20;
      if (r > 36 && r < 38) off += std::abs(heights(x, y) + 2.5F) > 0.01F;
    }
  }
  EXPECT_GT(both, 0.95 * either) << "the beach stands above water though the network drowned it";
  EXPECT_EQ(off, 0) << "reefs crest where they are asked to";
  EXPECT_NEAR(*std::max_element(heights.cells().begin(), heights.cells().end()), 1234, 0.1);
}

}  // namespace
}  // namespace seamount::learned
