#include "seamount/io/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "seamount/io/info.h"
#include "seamount/io/png_codec.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

Image gradient(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixel(x, y)[0] = static_cast<uint8_t>(255 * x / width);
      image.pixel(x, y)[1] = static_cast<uint8_t>(255 * y / height);
      image.pixel(x, y)[2] = static_cast<uint8_t>((x * y) % 256);
    }
  }
  return image;
}

TEST(ImageFile, PngComesBackExactly) {
  const TestFolder folder;
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 9), std::pair(33, 20)}) {
    const Image image = gradient(width, height);
    EXPECT_EQ(read_image(encode_png(image), "memory"), image);
    write_png(image, folder("x.png"));
    EXPECT_EQ(read_image(folder("x.png")), image);
  }
  EXPECT_THAT(*describe_picture(folder("x.png")), Contains(Pair("size", "33 x 20")));
}

TEST(ImageFile, GreyAlphaAndDeepPngsBecomeRgb) {
  const std::vector<uint8_t> grey{0, 100, 255};
  EXPECT_EQ(read_image(encode_png8(grey, 3, 1, 1), "g").rgb,
            (std::vector<uint8_t>{0, 0, 0, 100, 100, 100, 255, 255, 255}));
  const std::vector<uint8_t> rgba{10, 20, 30, 255, 10, 20, 30, 0};
  EXPECT_EQ(read_image(encode_png8(rgba, 2, 1, 4), "a").rgb, (std::vector<uint8_t>{10, 20, 30, 255, 255, 255}));
  const std::vector<uint16_t> deep{0, 32768, 65535};
  EXPECT_EQ(read_image(encode_png16(deep, 3, 1), "d").rgb,
            (std::vector<uint8_t>{0, 0, 0, 128, 128, 128, 255, 255, 255}));
}

TEST(ImageFile, JpegIsRead) {
  Image image(40, 24);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 40; ++x) image.pixel(x, y)[0] = static_cast<uint8_t>(6 * x), image.pixel(x, y)[1] = 90;
  const Image back = read_image(encode_jpeg(image, 95), "x.jpg");
  ASSERT_EQ(back.width, 40);
  ASSERT_EQ(back.height, 24);
  for (size_t i = 0; i < image.rgb.size(); ++i) EXPECT_LE(std::abs(image.rgb[i] - back.rgb[i]), 12);
}

TEST(ImageFile, PicturesAreWrittenByTheirEnding) {
  const TestFolder folder;
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(64, 33), std::pair(200, 7)}) {
    Image image(width, height, {200, 120, 40});
    for (const std::string& ending : picture_extensions()) {
      write_picture(image, folder("x" + ending));
      write_picture(image, folder("again" + ending));
      EXPECT_EQ(read_file(folder("x" + ending)), read_file(folder("again" + ending)));
      const Image back = read_image(folder("x" + ending));
      ASSERT_EQ(back.width, width);
      ASSERT_EQ(back.height, height);
      for (size_t i = 0; i < image.rgb.size(); ++i) ASSERT_LE(std::abs(image.rgb[i] - back.rgb[i]), 4) << ending;
    }
  }
  EXPECT_THAT(error_of([&] { write_picture(Image(2, 2), folder("x.bmp")); }), HasSubstr(".png, .jpg, .jpeg"));
  EXPECT_THAT(error_of([&] { write_picture(Image(65501, 1), folder("x.jpg")); }), HasSubstr("65500"));
  EXPECT_NO_THROW(write_picture(Image(65501, 1), folder("x.png")));
}

TEST(ImageFile, EveryShorterFileIsAnErrorOrAPicture) {
  const Image image = gradient(9, 7);
  for (const std::vector<uint8_t>& bytes : {encode_png(image), encode_jpeg(image, 80)}) {
    for (size_t length = 0; length < bytes.size(); ++length) {
      try {
        EXPECT_EQ(read_image(std::span(bytes).first(length), "short").width, 9);
      } catch (const IoError&) {
      }
    }
  }
  EXPECT_THAT(error_of([&] { read_image(std::vector<uint8_t>{}, "none"); }), HasSubstr("none: is empty"));
  EXPECT_THAT(error_of([&] { read_image(std::vector<uint8_t>(20, 65), "text"); }), HasSubstr("neither PNG nor JPEG"));
}

/// A header that claims 60000 x 60000 pixels in a file of some bytes.
TEST(PngCodec, ClaimsAreChecked) {
  std::vector<uint8_t> bytes = encode_png8(std::vector<uint8_t>(4, 9), 2, 2, 1);
  bytes[16] = 0, bytes[17] = 0, bytes[18] = 0xea, bytes[19] = 0x60;
  bytes[20] = 0, bytes[21] = 0, bytes[22] = 0xea, bytes[23] = 0x60;
  EXPECT_THAT(error_of([&] { read_image(bytes, "claims"); }), HasSubstr("claims: not a readable PNG"));
}

}  // namespace
}  // namespace seamount::io
