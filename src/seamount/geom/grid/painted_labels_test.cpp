#include "seamount/geom/grid/painted_labels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/geom/grid/test_pictures.h"

namespace seamount::geom {
namespace {

TEST(PaintedLabels, EncodesAsThePaperSays) {
  EXPECT_EQ(painted_colour(Region::abyss), (Colour{255, 0, 0}));
  EXPECT_EQ(painted_colour(Region::mountain), (Colour{255, 255, 0}));
  EXPECT_EQ(painted_colour(Region::beach), (Colour{0, 255, 0}));
  EXPECT_EQ(painted_colour(Region::lagoon), (Colour{0, 255, 255}));
  EXPECT_EQ(painted_colour(Region::reef), (Colour{0, 0, 255}));
  EXPECT_EQ(painted_colour(Region::reef, 1.0), (Colour{0, 0, 51}));
  EXPECT_THROW(painted_colour(Region::reef, 1.5), InvalidArgument);
}

/// Any label map, even one of noise with regions of one cell, comes back exactly.
TEST(PaintedLabels, CleanPicturesComeBackExactly) {
  for (const double subsidence : {0.0, 0.3, 0.7, 1.0}) {
    for (const auto& [width, height] : {std::pair(64, 48), std::pair(1, 1), std::pair(1, 30), std::pair(30, 2)}) {
      LabelMap labels(GridFrame::centred(width, height, 5));
      Rng rng(Seed{3}.derive("labels"));
      for (Region& region : labels.cells()) region = kRegions[static_cast<size_t>(rng.integer(0, 4))];
      const PaintedLabels painted = decode_labels(encode_labels(labels, subsidence), labels.frame(), {});
      EXPECT_EQ(painted.labels, labels) << subsidence << " " << width << " x " << height;
      EXPECT_NEAR(painted.subsidence, subsidence, 0.005);
    }
    const LabelMap labels = island(96, kInOrder);
    EXPECT_EQ(decode_labels(encode_labels(labels, subsidence), labels.frame(), {}).labels, labels);
  }
}

TEST(PaintedLabels, SeamsInventNoRegion) {
  for (const auto& order : {kInOrder, kTraps, kMoreTraps}) {
    const LabelMap truth = island(128, order);
    for (const double subsidence : {0.0, 0.5}) {
      const Image picture = antialiased(128, order, subsidence);
      for (const double sigma : {0.0, 0.7, 1.5}) {
        const Image seen = sigma > 0 ? blurred(picture, sigma) : picture;
        const Errors wrong = errors(decode_labels(seen, truth.frame(), {}).labels, truth);
        EXPECT_EQ(wrong.inside, 0) << "sigma " << sigma << " subsidence " << subsidence;
        EXPECT_LE(wrong.invented, 0.0002) << "sigma " << sigma << " subsidence " << subsidence;
        EXPECT_LE(wrong.all, 0.01) << "sigma " << sigma << " subsidence " << subsidence;
      }
    }
  }
}

TEST(PaintedLabels, SurvivesNoise) {
  for (const auto& order : {kInOrder, kTraps}) {
    const LabelMap truth = island(128, order);
    for (const double deviation : {6.0, 14.0}) {
      const PaintedLabels painted = decode_labels(noisy(antialiased(128, order, 0.25), deviation), truth.frame(), {});
      const Errors wrong = errors(painted.labels, truth);
      EXPECT_LE(wrong.inside, 0.0005) << deviation;
      EXPECT_LE(wrong.all, 0.012) << deviation;
      EXPECT_NEAR(painted.subsidence, 0.25, 0.05);
    }
  }
}

TEST(PaintedLabels, PixelsWithoutHueTakeTheirNeighbours) {
  const LabelMap truth = island(96, kInOrder);
  Image image = encode_labels(truth, 0.1);
  Rng rng(Seed{9}.derive("dirt"));
  for (int i = 0; i < 300; ++i) {
    uint8_t* p = image.pixel(rng.integer(0, 95), rng.integer(0, 95));
    p[0] = p[1] = p[2] = static_cast<uint8_t>(std::array{0, 128, 255}[static_cast<size_t>(i % 3)]);
  }
  const Errors wrong = errors(decode_labels(image, truth.frame(), {}).labels, truth);
  EXPECT_EQ(wrong.inside, 0);
  EXPECT_LE(wrong.all, 0.01);
}

/// Left red, right blue, between them a painted half-and-half.
TEST(PaintedLabels, HuesBetweenRegionsAreMixes) {
  Image image(60, 20, {255, 0, 0});
  for (int y = 0; y < 20; ++y) {
    for (int x = 20; x < 60; ++x) {
      const Colour colour = x < 40 ? Colour{255, 0, 255} : Colour{0, 0, 255};
      image.pixel(x, y)[0] = colour.r, image.pixel(x, y)[1] = colour.g, image.pixel(x, y)[2] = colour.b;
    }
  }
  const PaintedLabels painted = decode_labels(image, GridFrame::centred(60, 20, 1), {});
  EXPECT_NEAR(painted.shares[static_cast<size_t>(Region::abyss)](30, 10), 0.5, 0.02);
  EXPECT_NEAR(painted.shares[static_cast<size_t>(Region::reef)](30, 10), 0.5, 0.02);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 60; ++x) {
      float sum = 0;
      for (const Mask& share : painted.shares) sum += share(x, y);
      EXPECT_NEAR(sum, 1.0, 1e-5);
      EXPECT_TRUE(painted.labels(x, y) == Region::abyss || painted.labels(x, y) == Region::reef);
    }
  }
}

TEST(PaintedLabels, SubsidenceMayDifferFromPlaceToPlace) {
  Image image = encode_labels(LabelMap(GridFrame::centred(40, 10, 1), Region::reef), 0.0);
  const Colour deep = painted_colour(Region::reef, 0.75);
  for (int y = 0; y < 10; ++y)
    for (int x = 20; x < 40; ++x) image.pixel(x, y)[2] = deep.b;
  const PaintedLabels painted = decode_labels(image, GridFrame::centred(40, 10, 1), {});
  EXPECT_NEAR(painted.subsidence_per_cell(5, 5), 0.0, 0.01);
  EXPECT_NEAR(painted.subsidence_per_cell(35, 5), 0.75, 0.01);
  EXPECT_EQ(painted.labels, LabelMap(GridFrame::centred(40, 10, 1), Region::reef));
}

TEST(PaintedLabels, DarkSeamsHaveNotSunk) {
  // As JPEG leaves them: two pixels between yellow and red at three quarters of their brightness.
  LabelMap labels(GridFrame::centred(60, 20, 1), Region::abyss);
  for (int y = 0; y < 20; ++y)
    for (int x = 20; x < 40; ++x) labels(x, y) = Region::mountain;
  Image image = encode_labels(labels);
  for (int y = 0; y < 20; ++y)
    for (const int x : {17, 18, 19, 20, 21, 22, 39, 40})
      for (int k = 0; k < 3; ++k) image.pixel(x, y)[k] = static_cast<uint8_t>(0.75 * image.pixel(x, y)[k]);
  const PaintedLabels painted = decode_labels(image, labels.frame(), {});
  EXPECT_EQ(painted.labels, labels);
  for (const float sunk : painted.subsidence_per_cell.cells()) EXPECT_LT(sunk, 0.02F);
}

TEST(PaintedLabels, OtherSizesKeepShares) {
  const LabelMap truth = island(120, kInOrder);
  const Image image = encode_labels(truth);
  const PaintedLabels coarse = decode_labels(image, GridFrame::centred(40, 40, 30), {});
  EXPECT_LE(errors(coarse.labels, island(40, kInOrder)).all, 0.04);
  const PaintedLabels fine = decode_labels(image, GridFrame::centred(240, 240, 5), {});
  EXPECT_LE(errors(fine.labels, island(240, kInOrder)).all, 0.02);
}

TEST(PaintedLabels, RefusesPicturesWithoutRegions) {
  EXPECT_THROW(decode_labels(Image(8, 8, {255, 255, 255}), GridFrame::centred(8, 8, 1), {}), InvalidArgument);
  EXPECT_THROW(decode_labels(Image(), GridFrame::centred(8, 8, 1), {}), InvalidArgument);
}

TEST(PaintedLabels, SameForAnyNumberOfThreads) {
  const Image image = noisy(antialiased(150, kTraps, 0.4), 10);
  RunContext one, four;
  one.threads = 1, four.threads = 4;
  const GridFrame frame = GridFrame::centred(100, 90, 1);
  const PaintedLabels a = decode_labels(image, frame, one), b = decode_labels(image, frame, four);
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.shares, b.shares);
}

}  // namespace
}  // namespace seamount::geom
