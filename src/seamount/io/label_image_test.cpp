#include "seamount/io/label_image.h"

#include <gtest/gtest.h>

#include <cmath>

#include "seamount/base/error.h"
#include "seamount/base/rng.h"
#include "seamount/io/test_jpeg.h"

namespace seamount::io {
namespace {

/// Regions of an island as rings, wobbling, at a finer scale; `order` says which region lies at which ring.
Region island_at(double x, double y, const std::array<Region, 5>& order) {
  const double angle = std::atan2(y, x);
  const double r = std::hypot(x, y) * (1 + 0.12 * std::sin(3 * angle) + 0.05 * std::cos(7 * angle));
  constexpr std::array<double, 4> kRings = {0.25, 0.36, 0.62, 0.75};
  size_t ring = 0;
  while (ring < kRings.size() && r > kRings[ring]) ++ring;
  return order[ring];
}

LabelMap island(int size, const std::array<Region, 5>& order) {
  LabelMap labels(GridFrame::centred(size, size, 10));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) labels(x, y) = island_at(2 * (x + 0.5) / size - 1, 2 * (y + 0.5) / size - 1, order);
  return labels;
}

/// The same island with each pixel the mean of 8 x 8 samples.
Image antialiased(int size, const std::array<Region, 5>& order, double subsidence) {
  constexpr int kSamples = 8;
  const Image fine = encode_labels(island(size * kSamples, order), subsidence);
  Image image(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      for (int c = 0; c < 3; ++c) {
        int sum = 0;
        for (int k = 0; k < kSamples * kSamples; ++k)
          sum += fine.pixel(x * kSamples + k % kSamples, y * kSamples + k / kSamples)[c];
        image.pixel(x, y)[c] = static_cast<uint8_t>(sum / (kSamples * kSamples));
      }
    }
  }
  return image;
}

/// Gaussian blur by direct sums.
Image blurred(const Image& image, double sigma) {
  Image result = image;
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::array<double, 3> sum{};
      double weights = 0;
      for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
          const uint8_t* p = image.pixel(std::clamp(x + i, 0, image.width - 1), std::clamp(y + j, 0, image.height - 1));
          const double w = std::exp(-0.5 * (i * i + j * j) / (sigma * sigma));
          weights += w;
          for (size_t c = 0; c < 3; ++c) sum[c] += w * p[c];
        }
      }
      for (size_t c = 0; c < 3; ++c) result.pixel(x, y)[c] = static_cast<uint8_t>(std::lround(sum[c] / weights));
    }
  }
  return result;
}

Image noisy(Image image, double deviation) {
  Rng rng(Seed{5}.derive("noise"));
  for (uint8_t& value : image.rgb)
    value = static_cast<uint8_t>(std::clamp(value + deviation * rng.normal(), 0.0, 255.0));
  return image;
}

/// Cells that differ from the truth, of all and of those that are not next to another region.
struct Errors {
  double all = 0, inside = 0, invented = 0;
};

Errors errors(const LabelMap& found, const LabelMap& truth) {
  Errors result;
  double inside = 0;
  for (int y = 0; y < truth.height(); ++y) {
    for (int x = 0; x < truth.width(); ++x) {
      bool border = false, known = false;
      for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
          border = border || truth.clamped(x + i, y + j) != truth(x, y);
          known = known || truth.clamped(x + i, y + j) == found(x, y);
        }
      }
      inside += border ? 0 : 1;
      if (found(x, y) == truth(x, y)) continue;
      result.all += 1;
      result.inside += border ? 0 : 1;
      result.invented += known ? 0 : 1;  // a region that is nowhere near: a false seam
    }
  }
  const auto cells = static_cast<double>(truth.size());
  return {result.all / cells, result.inside / inside, result.invented / cells};
}

constexpr std::array<Region, 5> kInOrder = {Region::mountain, Region::beach, Region::lagoon, Region::reef,
                                            Region::abyss};
/// Every neighbourhood whose blend looks like a third region or like none: green|red, cyan|red, yellow|cyan,
/// yellow|blue.
constexpr std::array<Region, 5> kTraps = {Region::beach, Region::abyss, Region::lagoon, Region::mountain, Region::reef};
constexpr std::array<Region, 5> kMoreTraps = {Region::abyss, Region::beach, Region::reef, Region::abyss,
                                              Region::mountain};

TEST(LabelImage, EncodesAsThePaperSays) {
  EXPECT_EQ(region_colour(Region::abyss), (Colour{255, 0, 0}));
  EXPECT_EQ(region_colour(Region::mountain), (Colour{255, 255, 0}));
  EXPECT_EQ(region_colour(Region::beach), (Colour{0, 255, 0}));
  EXPECT_EQ(region_colour(Region::lagoon), (Colour{0, 255, 255}));
  EXPECT_EQ(region_colour(Region::reef), (Colour{0, 0, 255}));
  EXPECT_EQ(region_colour(Region::reef, 1.0), (Colour{0, 0, 51}));
  EXPECT_THROW(region_colour(Region::reef, 1.5), InvalidArgument);
}

/// Any label map, even one of noise with regions of one cell, comes back exactly.
TEST(LabelImage, CleanPicturesComeBackExactly) {
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

TEST(LabelImage, SeamsInventNoRegion) {
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

TEST(LabelImage, SurvivesNoise) {
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

/// JPEG halves the resolution of hue and rings at edges.
TEST(LabelImage, SurvivesJpeg) {
  for (const auto& order : {kInOrder, kTraps, kMoreTraps}) {
    const LabelMap truth = island(256, order);
    const Image picture = antialiased(256, order, 0.2);
    for (const int quality : {90, 60, 30}) {
      const PaintedLabels painted =
          decode_labels(read_image(encode_jpeg(picture, quality), "picture.jpg"), truth.frame(), {});
      const Errors wrong = errors(painted.labels, truth);
      EXPECT_LE(wrong.inside, 0.0002) << quality;
      EXPECT_LE(wrong.invented, 0.0002) << quality;
      EXPECT_LE(wrong.all, 0.008) << quality;
      EXPECT_NEAR(painted.subsidence, 0.2, 0.02);
    }
  }
}

TEST(LabelImage, PixelsWithoutHueTakeTheirNeighbours) {
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
TEST(LabelImage, HuesBetweenRegionsAreMixes) {
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

TEST(LabelImage, SubsidenceMayDifferFromPlaceToPlace) {
  Image image = encode_labels(LabelMap(GridFrame::centred(40, 10, 1), Region::reef), 0.0);
  const Colour deep = region_colour(Region::reef, 0.75);
  for (int y = 0; y < 10; ++y)
    for (int x = 20; x < 40; ++x) image.pixel(x, y)[2] = deep.b;
  const PaintedLabels painted = decode_labels(image, GridFrame::centred(40, 10, 1), {});
  EXPECT_NEAR(painted.subsidence_per_cell(5, 5), 0.0, 0.01);
  EXPECT_NEAR(painted.subsidence_per_cell(35, 5), 0.75, 0.01);
  EXPECT_EQ(painted.labels, LabelMap(GridFrame::centred(40, 10, 1), Region::reef));
}

TEST(LabelImage, OtherSizesKeepShares) {
  const LabelMap truth = island(120, kInOrder);
  const Image image = encode_labels(truth);
  const PaintedLabels coarse = decode_labels(image, GridFrame::centred(40, 40, 30), {});
  EXPECT_LE(errors(coarse.labels, island(40, kInOrder)).all, 0.04);
  const PaintedLabels fine = decode_labels(image, GridFrame::centred(240, 240, 5), {});
  EXPECT_LE(errors(fine.labels, island(240, kInOrder)).all, 0.02);
}

TEST(LabelImage, RefusesPicturesWithoutRegions) {
  EXPECT_THROW(decode_labels(Image(8, 8, {255, 255, 255}), GridFrame::centred(8, 8, 1), {}), InvalidArgument);
  EXPECT_THROW(decode_labels(Image(), GridFrame::centred(8, 8, 1), {}), InvalidArgument);
}

TEST(LabelImage, SameForAnyNumberOfThreads) {
  const Image image = noisy(antialiased(150, kTraps, 0.4), 10);
  RunContext one, four;
  one.threads = 1, four.threads = 4;
  const GridFrame frame = GridFrame::centred(100, 90, 1);
  const PaintedLabels a = decode_labels(image, frame, one), b = decode_labels(image, frame, four);
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.shares, b.shares);
}

}  // namespace
}  // namespace seamount::io
