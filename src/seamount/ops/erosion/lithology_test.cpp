#include "seamount/ops/erosion/lithology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace seamount::erosion {
namespace {

const std::vector<BedParams> kThree = {{"cap", 50, 4}, {"shale", 200, 0.25}, {"limestone", 30, 2}};

Lithology rock(LithologyParams params) {
  if (params.beds.empty()) params.beds = kThree;
  return {params, Seed{3}};
}

double slope(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

TEST(Lithology, LevelBedsByHand) {
  const Lithology once = rock({.repeat = false, .top_m = 1000});
  for (const auto& [height, bed] : {std::pair{2000.0, 0},
                                    {1000.1, 0},
                                    {950.1, 0},
                                    {949.9, 1},
                                    {750.1, 1},
                                    {749.9, 2},
                                    {720.1, 2},
                                    {719.0, 2},
                                    {-5000.0, 2}}) {
    EXPECT_EQ(once.bed(12, -7, height), bed) << height;
    EXPECT_FLOAT_EQ(static_cast<float>(once.hardness(12, -7, height)), static_cast<float>(kThree[bed].hardness));
  }
  const Lithology again = rock({.top_m = 1000});
  for (const auto& [height, bed] :
       {std::pair{1000.1, 2}, {1030.1, 1}, {1230.1, 0}, {999.9, 0}, {719.9, 0}, {669.9, 1}, {469.9, 2}, {439.9, 0}}) {
    EXPECT_EQ(again.bed(0, 0, height), bed) << height;
    EXPECT_EQ(again.bed(0, 0, height - 280 * 37), bed) << height;
  }
}

TEST(Lithology, BedsDipToTheRightOfTheStrike) {
  struct Case {
    double strike, x, y;  // a kilometre down dip
  };
  for (const auto& [strike, x, y] :
       {Case{0, 1000, 0}, {90, 0, -1000}, {180, -1000, 0}, {270, 0, 1000}, {-90, 0, 1000}}) {
    const Lithology tilted = rock({.top_m = 500, .top_x_m = 70, .top_y_m = -30, .dip_deg = 10, .strike_deg = strike});
    EXPECT_NEAR(tilted.datum(70 + x, -30 + y, 0), 500 - 1000 * slope(10), 1e-6) << strike;
    EXPECT_NEAR(tilted.datum(70 - y, -30 + x, 0), 500, 1e-6) << strike;  // along the strike
    EXPECT_NEAR(tilted.datum(70 - x, -30 - y, 0), 500 + 1000 * slope(10), 1e-6) << strike;
  }
}

TEST(Lithology, ThicknessIsMeasuredAcrossTheBeds) {
  // Beds that dip by 60 degrees are twice as thick along the vertical.
  const Lithology steep = rock({.dip_deg = 60});
  EXPECT_EQ(steep.bed(0, 0, -99), 0);
  EXPECT_EQ(steep.bed(0, 0, -101), 1);
  EXPECT_EQ(steep.bed(0, 0, -499), 1);
  EXPECT_EQ(steep.bed(0, 0, -501), 2);
}

TEST(Lithology, FoldsRiseAndFallAcrossTheirAxis) {
  const LithologyParams params{.strike_deg = 30, .fold_height_m = 400, .fold_wavelength_m = 2000, .fold_axis_deg = 0.0};
  const Lithology folded = rock(params);
  // The axis runs north: along it heights change slowly, and across it by all of the height.
  double low = 1e9, high = -1e9, along = 0, across = 0;
  for (int i = 0; i < 400; ++i) {
    const double at = 25.0 * i, here = folded.datum(at, 0, 0);
    low = std::min(low, here), high = std::max(high, here);
    across += std::abs(folded.datum(at + 25, 0, 0) - here);
    along += std::abs(folded.datum(at, 25, 0) - here);
  }
  EXPECT_GT(high - low, 250);
  EXPECT_LT(high - low, 2.2 * 400);
  EXPECT_GT(across, 2 * along);
}

TEST(Lithology, FaultsLowerTheBedsToTheirRight) {
  // A vertical fault that runs north, and one that dips by 45 degrees east of it.
  const Lithology upright = rock({.top_m = 100, .faults = {{{{500, 0}, {500, 1000}}, 90, 120}}});
  for (const double z : {-3000.0, 0.0, 2000.0}) {
    EXPECT_NEAR(upright.datum(499, 5000, z), 100, 1e-9);
    EXPECT_NEAR(upright.datum(501, -5000, z), -20, 1e-9);
  }
  EXPECT_FALSE(upright.faults_dip());
  const Lithology dipping = rock({.top_m = 100, .faults = {{{{500, 0}, {500, 1000}}, 45, -80}}});
  EXPECT_TRUE(dipping.faults_dip());
  EXPECT_NEAR(dipping.datum(600, 0, 1), 180, 1e-9);    // over the plane, which lies at 0 there
  EXPECT_NEAR(dipping.datum(600, 0, -1), 100, 1e-9);   // under it
  EXPECT_NEAR(dipping.datum(400, 0, 201), 180, 1e-9);  // the plane goes on up to the west
  EXPECT_NEAR(dipping.datum(400, 0, 199), 100, 1e-9);
}

TEST(Lithology, AFaultsTraceMayTurnAndGoesOnBeyondItsEnds) {
  // East, then north: what lies south and east of it has gone down.
  const Lithology bent = rock({.faults = {{{{-100, 0}, {0, 0}, {0, 100}}, 90, 50}}});
  for (const auto& [x, y, down] : {std::tuple{-50, -10, true},
                                   {-50, 10, false},
                                   {10, 50, true},
                                   {-10, 50, false},
                                   {20, -20, true},
                                   {1, -900, true},
                                   {-20, 20, false},
                                   {-5000, -1, true},
                                   {-5000, 1, false},
                                   {1, 5000, true},
                                   {-1, 5000, false}}) {
    EXPECT_EQ(bent.thrown(x, y, 0), down ? 50 : 0) << x << " " << y;
  }
}

TEST(Lithology, RowsAreThePlainFunctions) {
  const Lithology all = rock({.top_m = 300,
                              .dip_deg = 20,
                              .strike_deg = 70,
                              .fold_height_m = 200,
                              .fold_wavelength_m = 900,
                              .thickness_variation = 0.5,
                              .faults = {{{{0, 0}, {100, 50}}, 60, 70}}});
  const GridFrame frame = GridFrame::centred(60, 7, 40);
  std::vector<float> datum(60), stretch(60);
  double thinnest = 1e9, thickest = 0;
  for (int y = 0; y < 7; ++y) {
    all.datum_row(frame, y, datum);
    all.stretch_row(frame, y, stretch);
    for (int x = 0; x < 60; ++x) {
      const double east = frame.x(x), north = frame.y(y);
      EXPECT_NEAR(datum[static_cast<size_t>(x)] - all.thrown(east, north, 5), all.datum(east, north, 5), 0.02);
      EXPECT_NEAR(stretch[static_cast<size_t>(x)], all.stretch(east, north), 1e-4);
      thinnest = std::min(thinnest, 1 / all.stretch(east, north));
      thickest = std::max(thickest, 1 / all.stretch(east, north));
    }
  }
  EXPECT_GT(thickest, 1.02 * thinnest);
}

TEST(Lithology, WalksThroughBedsAsTheyLie) {
  for (const bool repeat : {false, true}) {
    const BedSequence beds(kThree, repeat);
    BedSequence::Bed down = beds.at(10), up = beds.at(270);
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(down.index, i);
      down = beds.under(down);
      EXPECT_EQ(up.index, 2 - i);
      up = beds.over(up);
    }
    EXPECT_EQ(std::isinf(down.bottom), !repeat);
    EXPECT_EQ(std::isinf(up.top), !repeat);
    if (!repeat) continue;
    for (int i = 0; i < 100; ++i) {
      const BedSequence::Bed next = beds.under(down);
      EXPECT_EQ(next.top, down.bottom);
      EXPECT_EQ(beds.at(0.5F * (next.top + next.bottom)).index, next.index);
      EXPECT_EQ(beds.over(next).index, down.index);
      down = next;
    }
  }
}

TEST(Lithology, SaysWhatIsWrong) {
  EXPECT_THROW(rock({.faults = {{{{0, 0}}, 60, 10}}}), InvalidArgument);
  EXPECT_THROW(rock({.faults = {{{{5, 5}, {5, 5}}, 60, 10}}}), InvalidArgument);
  EXPECT_THROW(rock({.beds = {{"none", 0, 1}}}), InvalidArgument);
  EXPECT_THROW(rock({.dip_deg = 90}), InvalidArgument);
}

}  // namespace
}  // namespace seamount::erosion
