#include "seamount/io/raster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "seamount/io/projection.h"
#include "seamount/io/test_files.h"

namespace seamount::io {
namespace {

using ::testing::HasSubstr;

GridFrame utm_frame(int width, int height) {
  return {width, height, 30.0 / 7.0, 432'100.123456789, 2'441'000.987654321, "EPSG:32604"};
}

TEST(GeoTiff, ComesBackExactly) {
  const TestFolder folder;
  const std::vector<GridFrame> frames = {utm_frame(67, 41),
                                         utm_frame(1, 1),
                                         utm_frame(1, 9),
                                         utm_frame(300, 2),
                                         GridFrame::centred(13, 17, 0.1),
                                         GridFrame{5, 5, 1.0, 0.0, 0.0, ""}};
  for (GridFrame frame : frames) {
    for (const bool cloud : {false, true}) {
      const HeightField heights = test_terrain(frame);
      const std::string path = folder("height.tif");
      write_heights(heights, path, {.cloud_optimised = cloud});
      EXPECT_EQ(read_heights(path), heights) << frame.width << " x " << frame.height << " cloud " << cloud;
    }
  }
  EXPECT_EQ(folder.files(), 1U) << "no side files";
}

TEST(GeoTiff, KeepsALocalSystemWordForWord) {
  const TestFolder folder;
  GridFrame frame = GridFrame::centred(20, 10, 25.0);
  frame.crs = local_crs(-159.5312, 22.0517);
  const HeightField heights = test_terrain(frame);
  write_heights(heights, folder("height.tif"));
  EXPECT_EQ(read_heights(folder("height.tif")).frame(), frame);
}

TEST(GeoTiff, SameBytesTwice) {
  const TestFolder folder;
  const HeightField heights = test_terrain(utm_frame(600, 500));
  for (const bool cloud : {false, true}) {
    write_heights(heights, folder("a.tif"), {.cloud_optimised = cloud});
    write_heights(heights, folder("b.tif"), {.cloud_optimised = cloud});
    EXPECT_EQ(read_file(folder("a.tif")), read_file(folder("b.tif")));
  }
}

class FloatFormats : public ::testing::TestWithParam<std::string> {};

TEST_P(FloatFormats, ComeBackExactly) {
  const TestFolder folder;
  for (const auto& [width, height] : {std::pair(33, 20), std::pair(1, 1), std::pair(1, 7), std::pair(9, 1)}) {
    const HeightField heights = test_terrain(utm_frame(width, height));
    const std::string path = folder("height" + GetParam());
    write_heights(heights, path);
    const HeightField back = read_heights(path);
    EXPECT_EQ(largest_difference(back, heights), 0.0F);
    EXPECT_EQ(back.frame().crs, heights.frame().crs);
    EXPECT_NEAR(back.frame().north_m, heights.frame().north_m, 1e-6);
    EXPECT_NEAR(back.frame().west_m, heights.frame().west_m, 1e-6);
    EXPECT_EQ(back.frame().cell_m, heights.frame().cell_m);
  }
}

INSTANTIATE_TEST_SUITE_P(Raster, FloatFormats, ::testing::Values(".asc", ".exr", ".npy", ".r32"));

class CodedFormats : public ::testing::TestWithParam<std::string> {};

TEST_P(CodedFormats, ComeBackWithinHalfAStep) {
  const TestFolder folder;
  const HeightField heights = test_terrain(utm_frame(64, 33));
  const std::string path = folder("height" + GetParam());
  write_heights(heights, path);
  const HeightField back = read_heights(path);
  const Sidecar sidecar = *read_sidecar(path);
  const double step = (sidecar.range->high_m - sidecar.range->low_m) / 65535.0;
  EXPECT_LE(largest_difference(back, heights), 0.5 * step + 2e-4);  // and the rounding of floats around 1000 m
  EXPECT_EQ(back.frame(), heights.frame());
}

TEST_P(CodedFormats, WithoutSidecarAskForTheRangeAndTheCell) {
  const TestFolder folder;
  const HeightField heights = test_terrain(utm_frame(16, 16));
  const std::string path = folder("height" + GetParam());
  write_heights(heights, path, {.range = HeightRange{-2000, 2000}, .sidecar = false});
  EXPECT_THAT(error_of([&] { read_heights(path, {.cell_m = 10.0}); }), HasSubstr("low_m, high_m"));
  EXPECT_THAT(error_of([&] { read_heights(path, {.range = HeightRange{-2000, 2000}}); }), HasSubstr("give cell_m"));
  const HeightField back = read_heights(path, {.cell_m = 10.0, .range = HeightRange{-2000, 2000}});
  EXPECT_LE(largest_difference(back, heights), 2000.0 / 65535.0 + 2e-4);
  EXPECT_EQ(back.frame(), GridFrame::centred(16, 16, 10.0));
}

INSTANTIATE_TEST_SUITE_P(Raster, CodedFormats, ::testing::Values(".png", ".r16", ".raw"));

TEST(Raster, CompanionsOfAnEarlierFileDoNotStay) {
  const TestFolder folder;
  const HeightField placed = test_terrain(utm_frame(8, 8)), local = test_terrain(GridFrame::centred(8, 8, 2));
  write_heights(placed, folder("x.asc"));
  write_heights(local, folder("x.asc"));
  EXPECT_EQ(read_heights(folder("x.asc")).frame().crs, "");
  write_heights(placed, folder("x.r32"));
  write_heights(local, folder("x.r32"), {.sidecar = false});
  EXPECT_FALSE(read_sidecar(folder("x.r32")).has_value());
}

TEST(Raster, FlatTerrainHasARange) {
  const TestFolder folder;
  write_heights(HeightField(GridFrame::centred(8, 8, 1), 12.5F), folder("flat.r16"));
  EXPECT_NEAR(read_heights(folder("flat.r16"))(3, 3), 12.5, 1e-5);
}

TEST(Raster, RangeOnRealValuesMapsZeroToOne) {
  const TestFolder folder;
  HeightField shares(GridFrame::centred(2, 1, 1));
  shares(0, 0) = 0.0F, shares(1, 0) = 0.5F;
  write_heights(shares, folder("unit.npy"));
  const HeightField metres = read_heights(folder("unit.npy"), {.range = HeightRange{-100, 300}});
  EXPECT_EQ(metres(0, 0), -100.0F);
  EXPECT_EQ(metres(1, 0), 100.0F);
}

TEST(Raster, MasksAndLabelsComeBack) {
  const TestFolder folder;
  const GridFrame frame = utm_frame(12, 8);
  Mask mask(frame);
  LabelMap labels(frame);
  for (size_t i = 0; i < mask.size(); ++i) {
    mask.cells()[i] = static_cast<float>(i) / static_cast<float>(mask.size() - 1);
    labels.cells()[i] = kRegions[i / 3 % kRegionCount];
  }
  for (const std::string extension : {".png", ".tif", ".npy"}) {
    write_mask(mask, folder("mask" + extension));
    const Mask back = read_mask(folder("mask" + extension));
    EXPECT_LE(largest_difference(back, mask), 0.5 / 255 + 1e-6) << extension;
    EXPECT_EQ(back.frame(), frame) << extension;
  }
  write_labels(labels, folder("labels.tif"));
  EXPECT_EQ(read_labels(folder("labels.tif")), labels);
  write_labels(labels, folder("labels.png"));
  const PlacedImage picture = read_placed_image(folder("labels.png"));
  EXPECT_EQ(picture.frame, frame);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) EXPECT_EQ(picture.image.colour(x, y), painted_colour(labels(x, y)));
}

TEST(Raster, WritersRefuseWhatTheirFormatCannotHold) {
  const TestFolder folder;
  HeightField heights = test_terrain(GridFrame::centred(4, 3, 1));
  heights(2, 1) = std::numeric_limits<float>::infinity();
  for (const std::string& extension : writable_raster_extensions())
    EXPECT_THAT(error_of([&] { write_heights(heights, folder("x" + extension)); }), HasSubstr("cell (2, 1)"));
  heights(2, 1) = std::nanf("");
  for (const std::string& extension : writable_raster_extensions()) {
    if (can_hold_voids("x" + extension)) continue;
    EXPECT_THAT(error_of([&] { write_heights(heights, folder("x" + extension)); }), HasSubstr("cell (2, 1)"));
  }
  EXPECT_THAT(error_of([&] { write_heights(HeightField(), folder("x.tif")); }), HasSubstr("no cells"));
  EXPECT_EQ(folder.files(), 0U);
}

TEST(Raster, WrongNamesAreExplained) {
  const TestFolder folder;
  const HeightField heights = test_terrain(GridFrame::centred(4, 4, 1));
  EXPECT_THAT(error_of([&] { write_heights(heights, folder("x.tfi")); }), HasSubstr("did you mean '.tif'"));
  EXPECT_THAT(error_of([&] { read_heights(folder("x.tif")); }), HasSubstr("no such file"));
  write_text(folder("x.bmp"), "BM");
  EXPECT_THAT(error_of([&] { read_heights(folder("x.bmp")); }), HasSubstr("not a raster format"));
}

/// ASC text with the given cells.
std::string asc(const std::string& cells, const std::string& cell_size = "cellsize 10") {
  return "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\n" + cell_size + "\nNODATA_value -9999\n" + cells;
}

TEST(Warp, OblongCellsBecomeSquare) {
  const TestFolder folder;
  write_text(folder("oblong.asc"), asc("1 1 1\n3 3 3\n", "dx 10\ndy 40"));
  const HeightField heights = read_heights(folder("oblong.asc"));
  EXPECT_NEAR(heights.frame().cell_m, 20.0, 1e-9);
  EXPECT_EQ(heights.width(), 1);
  EXPECT_EQ(heights.height(), 4);
  EXPECT_NEAR(heights(0, 0), 1.0, 1e-6);
  EXPECT_NEAR(heights(0, 1), 1.5, 1e-6);
  EXPECT_NEAR(heights(0, 3), 3.0, 1e-6);
}

/// Heights in degrees are 1000 * (longitude - 8) + 100 * (latitude - 60), so that places can be checked by value.
TEST(Warp, DegreesComeToTheRightPlace) {
  const TestFolder folder;
  std::string text = "ncols 200\nnrows 200\nxllcorner 8\nyllcorner 60\ncellsize 0.005\n";
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 200; ++column)
      text +=
          std::to_string(1000 * (column + 0.5) * 0.005 + 100 * (199.5 - row) * 0.005) + (column == 199 ? "\n" : " ");
  write_text(folder("degrees.asc"), text);
  const HeightField heights = read_heights(folder("degrees.asc"));
  const GridFrame& frame = heights.frame();
  EXPECT_NEAR(frame.cell_m, std::sqrt(555.0 * 278.0), 8.0);
  for (const auto& [x, y] : {std::pair(1, 1), std::pair(frame.width - 2, 1),
                             std::pair(frame.width / 2, frame.height / 2), std::pair(2, frame.height - 2)}) {
    const Vec2 degrees = to_lonlat({{frame.x(x), frame.y(y)}}, frame.crs)[0];
    EXPECT_NEAR(heights(x, y), 1000 * (degrees.x - 8) + 100 * (degrees.y - 60), 0.05) << x << " " << y;
  }
  EXPECT_TRUE(raster_info(folder("degrees.asc")).geographic);
}

TEST(Warp, TheWholeGlobeIsRefused) {
  const TestFolder folder;
  write_text(folder("globe.asc"), "ncols 2\nnrows 1\nxllcorner -180\nyllcorner -90\ncellsize 180\n1 2\n");
  write_text(folder("globe.prj"),
             R"(GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],)"
             R"(PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]])");
  EXPECT_THAT(error_of([&] { read_heights(folder("globe.asc")); }), HasSubstr("spans 360 degrees of longitude"));
}

TEST(Limits, DeclaredSizesAreCheckedFirst) {
  const TestFolder folder;
  write_text(folder("huge.asc"), "ncols 1000000\nnrows 1000000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n");
  EXPECT_THAT(error_of([&] { read_heights(folder("huge.asc")); }), HasSubstr("more than the limit of 300000000"));
  write_text(folder("rect.r16"), std::string(2 * 12, 'x'));
  EXPECT_THAT(error_of([&] { read_heights(folder("rect.r16")); }), HasSubstr("must be square unless"));
  write_text(folder("zero.r16"), "");
  EXPECT_THAT(error_of([&] { read_heights(folder("zero.r16")); }), HasSubstr("is empty"));
}

/// One tile of SRTM: 1201 x 1201 big-endian samples whose outer ones lie on whole degrees.
TEST(Hgt, LiesWhereItsNameSays) {
  const TestFolder folder;
  std::vector<uint8_t> bytes(1201 * 1201 * 2, 0);
  const auto set = [&](size_t column, size_t row, uint16_t value) {
    bytes[2 * (row * 1201 + column)] = static_cast<uint8_t>(value >> 8);
    bytes[2 * (row * 1201 + column) + 1] = static_cast<uint8_t>(value & 0xff);
  };
  for (size_t column = 0; column < 1201; ++column)
    for (size_t row = 600; row <= 601; ++row) set(column, row, 1000);
  const std::string path = folder("N22W160.hgt");
  write_bytes(path, bytes);
  const HeightField heights = read_heights(path);
  const GridFrame& frame = heights.frame();
  const double latitude = 22 + 599.5 / 1200;  // between the two rows
  const Vec2 place = from_lonlat({{-159.4, latitude}}, frame.crs)[0];
  const int x = static_cast<int>(std::lround(frame.column(place.x))),
            y = static_cast<int>(std::lround(frame.row(place.y)));
  EXPECT_GT(heights(x, y), 900);
  EXPECT_EQ(heights(x, y - 4), 0);
  EXPECT_EQ(heights(x, y + 4), 0);
  set(300, 300, 0x8000);
  write_bytes(path, bytes);
  const HeightField holed = read_heights(path);
  EXPECT_EQ(holed.size(), heights.size());
  EXPECT_GT(std::count_if(holed.cells().begin(), holed.cells().end(), [](float z) { return std::isnan(z); }), 0);
  write_bytes(path, std::span(bytes).first(1000));
  EXPECT_THAT(error_of([&] { read_heights(path); }), HasSubstr("is no HGT file: those are named"));
}

TEST(Raster, GeoTiffsThatCannotBeUsedAreExplained) {
  const TestFolder folder;
  write_text(folder("plain.tif"), "not a TIFF at all");
  EXPECT_THAT(error_of([&] { read_heights(folder("plain.tif")); }),
              HasSubstr("plain.tif: is not a GeoTIFF, HGT or ASC file"));
  write_heights(test_terrain(utm_frame(8, 8)), folder("good.tif"));
  EXPECT_THAT(error_of([&] { read_heights(folder("good.tif"), {.band = 2}); }), HasSubstr("has 1 band, band 2 was"));
  EXPECT_THAT(error_of([&] { read_heights(folder("good.tif"), {.max_cells = 63}); }), HasSubstr("limit of 63"));
  EXPECT_THAT(error_of([&] { read_labels(folder("good.tif")); }), HasSubstr("is not one of 0 (mountain) to 4 (abyss)"));
}

/// Whatever ends the writing, there is one line, the earlier file and nothing else.
TEST(Raster, FullDiskLeavesTheEarlierFile) {
  const TestFolder folder;
  const HeightField heights = test_terrain(utm_frame(200, 200));
  for (const std::string& extension : writable_raster_extensions()) {
    const std::string path = folder("height" + extension);
    write_heights(heights, path, {.sidecar = false});
    const std::vector<uint8_t> before = read_file(path);
    const size_t files = folder.files();
    std::string message;
    {
      const FileSizeLimit limit(4096);
      message = error_of([&] { write_heights(heights, path, {.sidecar = false}); });
    }
    EXPECT_THAT(message, HasSubstr("cannot be written")) << extension;
    EXPECT_EQ(read_file(path), before) << extension;
    EXPECT_EQ(folder.files(), files) << extension;
  }
}

class Truncated : public ::testing::TestWithParam<std::string> {};

/// Every shorter version of a small file is an error, never a crash.
TEST_P(Truncated, EveryLengthIsAnError) {
  const TestFolder folder;
  const std::string path = folder("small" + GetParam());
  write_heights(test_terrain(GridFrame::centred(6, 6, 2.0)), path);
  const std::vector<uint8_t> bytes = read_file(path);
  const ReadOptions options{.cell_m = 1.0, .range = HeightRange{0, 1}, .max_cells = 10000};
  ASSERT_FALSE(read_heights(bytes, path, options).empty());
  size_t read = 0;
  for (size_t length = 0; length < bytes.size(); ++length) {
    try {
      read += read_heights(std::span(bytes).first(length), path, options).size() > 0 ? 1 : 0;
    } catch (const IoError&) {
    }
  }
  // The last digits of a text file may be missing unnoticed, and a shorter raw file may be a smaller square.
  EXPECT_LE(read, 20U);
}

INSTANTIATE_TEST_SUITE_P(Raster, Truncated, ::testing::Values(".tif", ".asc", ".png", ".exr", ".r16", ".r32", ".npy"));

TEST(Sidecar, ComesBackAndRefusesNonsense) {
  const TestFolder folder;
  Sidecar sidecar;
  sidecar.frame = utm_frame(7, 9);
  sidecar.range = HeightRange{-10.25, 99.5};
  sidecar.south_first = true;
  sidecar.target = "unity";
  sidecar.import = {{"Terrain Height", "109.75"}};
  sidecar.provenance = {"Seamount 0.1.0", "isle.json", 0xffffffffffffffffULL};
  const std::string path = folder("x.raw");
  write_text(path, "codes");
  write_sidecar(sidecar, path);
  const Sidecar back = *read_sidecar(path);
  EXPECT_EQ(back.frame, sidecar.frame);
  EXPECT_EQ(back.range, sidecar.range);
  EXPECT_EQ(back.south_first, true);
  EXPECT_EQ(back.import, sidecar.import);
  EXPECT_EQ(back.provenance, sidecar.provenance);
  for (const std::string text : {"", "[]", "{\"width\":1}", "{\"width\":-1,\"height\":2,\"cell_m\":1}",
                                 "{\"width\":1,\"height\":2,\"cell_m\":0}", "{\"width\":\"a\"}",
                                 "{\"width\":1,\"height\":2,\"cell_m\":1,\"low_m\":5,\"high_m\":5}",
                                 "{\"width\":1,\"height\":2,\"cell_m\":1,\"first_row\":\"west\"}"}) {
    write_text(sidecar_path(path), text);
    EXPECT_THAT(error_of([&] { read_sidecar(path); }), HasSubstr("x.raw.json: ")) << text;
  }
  EXPECT_EQ(read_sidecar(folder("other.raw")), std::nullopt);
}

/// Two runs into one folder, the second one killed between its raster and its side-car.
TEST(Sidecar, IsBelievedForItsOwnRasterOnly) {
  for (const std::string name : {"x.r16", "x.png", "x.exr", "x.npy"}) {
    const TestFolder folder;
    const std::string path = folder(name);
    write_heights(test_terrain(GridFrame::centred(16, 16, 10), 1), path);
    EXPECT_EQ(error_of([&] { read_heights(path); }), "");
    const std::vector<uint8_t> earlier = read_file(sidecar_path(path));
    write_heights(test_terrain(GridFrame::centred(16, 16, 10), 2), path);
    write_bytes(sidecar_path(path), earlier);
    for (const std::string& message : {error_of([&] { read_heights(path); }), error_of([&] { raster_info(path); })})
      EXPECT_THAT(message, HasSubstr(name + ".json: does not belong to the '" + name + "' that is there")) << name;
  }
}

TEST(Sidecar, IsBelievedWithoutADigestAndForPicturesThatArePainted) {
  const TestFolder folder;
  write_heights(test_terrain(GridFrame::centred(16, 16, 10)), folder("x.r16"));
  write_text(sidecar_path(folder("x.r16")), R"({"width":16,"height":16,"cell_m":5,"low_m":0,"high_m":1})");
  EXPECT_EQ(read_heights(folder("x.r16")).cell_m(), 5);
  LabelMap labels(GridFrame::centred(16, 16, 7), Region::abyss);
  write_labels(labels, folder("labels.png"));
  const std::vector<uint8_t> sidecar = read_file(sidecar_path(folder("labels.png")));
  labels.cells()[40] = Region::mountain;
  write_labels(labels, folder("labels.png"));
  write_bytes(sidecar_path(folder("labels.png")), sidecar);
  EXPECT_EQ(read_placed_image(folder("labels.png")).frame.cell_m, 7);
}

}  // namespace
}  // namespace seamount::io
