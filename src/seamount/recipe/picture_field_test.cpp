#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "seamount/io/image_file.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/raster.h"
#include "seamount/io/test_files.h"
#include "seamount/recipe/kind.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/laid_over.h"

namespace seamount::recipe {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Read {
  ScalarField field;
  std::string said;
};

Read read_field(const std::string& path, const GridFrame& frame) {
  Read read;
  RunContext run;
  run.note = [&](const std::string& note) { read.said += note + "\n"; };
  read.field = *std::static_pointer_cast<const ScalarField>(kinds::Field::kind().read_file({path, frame, false, run}));
  return read;
}

/// White to the right of the middle, black to the left, a grey column between.
uint8_t painted(int x, int width) { return 2 * x + 1 > width ? 255 : 2 * x + 1 < width ? 0 : 128; }

std::vector<uint8_t> halves(int width, int height, int channels) {
  std::vector<uint8_t> samples;
  for (int i = 0; i < width * height; ++i)
    for (int c = 0; c < channels; ++c) samples.push_back(c == 3 ? 255 : painted(i % width, width));
  return samples;
}

void expect_halves(const ScalarField& mask, float tolerance) {
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      const double place = (x + 0.5) / mask.width();
      if (std::abs(place - 0.5) > 0.1) {
        EXPECT_NEAR(mask(x, y), place > 0.5 ? 1 : 0, tolerance) << x << " " << y;
      }
      EXPECT_GE(mask(x, y), 0.0F);
      EXPECT_LE(mask(x, y), 1.0F);
    }
  }
}

TEST(PictureField, LiesOverTheFrameBlackZeroWhiteOne) {
  const io::TestFolder folder;
  const GridFrame frame{60, 40, 25.0, 1000.0, 2000.0, ""};
  for (const auto& [width, height] : {std::pair{60, 40}, {30, 20}, {301, 200}, {90, 60}}) {
    for (const int channels : {1, 3, 4}) {
      io::write_bytes(folder("m.png"), io::encode_png8(halves(width, height, channels), width, height, channels));
      const Read read = read_field(folder("m.png"), frame);
      EXPECT_EQ(read.field.frame(), frame);
      expect_halves(read.field, 0);
      EXPECT_THAT(read.said, HasSubstr("black 0 and white 1"));
      EXPECT_THAT(read.said, Not(HasSubstr("another shape"))) << width;
    }
    Image image(width, height);
    for (int i = 0; i < width * height; ++i) std::memset(image.rgb.data() + 3 * i, painted(i % width, width), 3);
    io::write_bytes(folder("m.jpg"), io::encode_jpeg(image, 90));
    expect_halves(read_field(folder("m.jpg"), frame).field, 0.03F);
  }
}

TEST(PictureField, OfSixteenBitsKeepsThem) {
  const io::TestFolder folder;
  std::vector<uint16_t> samples(12);
  for (size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<uint16_t>(5000 * i);
  io::write_bytes(folder("deep.png"), io::encode_png16(samples, 4, 3));
  const ScalarField field = read_field(folder("deep.png"), GridFrame::centred(4, 3, 10)).field;
  for (size_t i = 0; i < samples.size(); ++i) EXPECT_NEAR(field.data()[i], samples[i] / 65535.0, 1e-6);
}

TEST(PictureField, SaysWhenItIsStretchedOrTransparentOrColoured) {
  const io::TestFolder folder;
  const GridFrame frame = GridFrame::centred(20, 20, 10);
  io::write_bytes(folder("wide.png"), io::encode_png8(halves(40, 20, 1), 40, 20, 1));
  EXPECT_THAT(read_field(folder("wide.png"), frame).said, HasSubstr("40 x 20 pixels are of another shape"));

  std::vector<uint8_t> clear = halves(20, 20, 4);
  for (size_t i = 3; i < clear.size() / 2; i += 4) clear[i] = 0;
  io::write_bytes(folder("clear.png"), io::encode_png8(clear, 20, 20, 4));
  const Read half = read_field(folder("clear.png"), frame);
  EXPECT_THAT(half.said, HasSubstr("200 transparent pixels count as black"));
  EXPECT_EQ(half.field(19, 0), 0.0F);
  EXPECT_EQ(half.field(19, 19), 1.0F);

  io::write_png(Image(20, 20, {255, 0, 0}), folder("red.png"));
  const Read red = read_field(folder("red.png"), frame);
  EXPECT_THAT(red.said, HasSubstr("brightness"));
  EXPECT_NEAR(red.field(3, 3), 0.299, 1e-3);
}

TEST(PictureField, OfOursLiesWhereItWas) {
  const io::TestFolder folder;
  ScalarField mask(GridFrame::centred(8, 6, 5), 0.0F);
  mask(2, 1) = 1.0F;
  io::write_field(mask, folder("ours.png"));
  const Read read = read_field(folder("ours.png"), GridFrame::centred(50, 50, 1));
  EXPECT_EQ(read.field.frame(), mask.frame());
  EXPECT_NEAR(read.field(2, 1), 1.0F, 1e-4);
}

TEST(LaidOver, KeepsTheMeanAndWhatIsTheSameEverywhere) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {64, 64}, {130, 50}}) {
    const ScalarField flat(GridFrame::centred(width, height, 1), 0.3F);
    const ScalarField laid = laid_over(flat, GridFrame::centred(33, 47, 2), {});
    for (const float value : laid.cells()) ASSERT_EQ(value, 0.3F);
  }
  ScalarField fine(GridFrame::centred(100, 100, 1));
  for (size_t i = 0; i < fine.size(); ++i) fine.data()[i] = static_cast<float>(i % 2);  // finer than cells
  const ScalarField coarse = laid_over(fine, GridFrame::centred(10, 10, 10), {});
  for (const float value : coarse.cells()) ASSERT_NEAR(value, 0.5, 0.03);
}

}  // namespace
}  // namespace seamount::recipe
