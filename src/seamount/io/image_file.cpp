#include "seamount/io/image_file.h"

#include <algorithm>
#include <atomic>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/gdal_call.h"
#include "seamount/io/png_codec.h"

namespace seamount::io {
namespace {

constexpr int64_t kMostPixels = 300'000'000;
constexpr uint64_t kMostBytes = uint64_t{2} << 30;

bool is_jpeg(std::span<const uint8_t> file) {
  return file.size() >= 3 && file[0] == 0xff && file[1] == 0xd8 && file[2] == 0xff;
}

/// Alpha is blended over white, as on paper.
uint8_t over_white(int colour, int alpha) {
  return static_cast<uint8_t>((colour * alpha + 255 * (255 - alpha) + 127) / 255);
}

Image from_png(std::span<const uint8_t> file, const std::string& name) {
  PngSamples samples = decode_png_samples(file, name, kMostPixels);
  if (samples.bits == 16) {
    samples.bytes8.resize(samples.words16.size());
    std::transform(samples.words16.begin(), samples.words16.end(), samples.bytes8.begin(),
                   [](uint16_t word) { return static_cast<uint8_t>((word * 255u + 32767u) / 65535u); });
  }
  Image image(samples.width, samples.height);
  const size_t channels = static_cast<size_t>(samples.channels);
  const bool colour = channels >= 3, alpha = channels % 2 == 0;
  for (size_t i = 0; i < image.rgb.size() / 3; ++i) {
    const uint8_t* from = samples.bytes8.data() + i * channels;
    const int opacity = alpha ? from[channels - 1] : 255;
    for (size_t c = 0; c < 3; ++c) image.rgb[3 * i + c] = over_white(from[colour ? c : 0], opacity);
  }
  return image;
}

Image from_jpeg(std::span<const uint8_t> file, const std::string& name) {
  GdalCall call(name);
  const MemoryFile memory(file, "picture.jpg");
  call.hide(memory.path());
  constexpr const char* const kDrivers[] = {"JPEG", nullptr};
  const DatasetPtr dataset = open_dataset(call, memory.path(), GDAL_OF_RASTER, kDrivers, "a JPEG");
  const int width = dataset->GetRasterXSize(), height = dataset->GetRasterYSize();
  if (int64_t{width} * height > kMostPixels) call.fail("has too many pixels");
  const int bands = dataset->GetRasterCount();
  if (bands != 1 && bands != 3) call.fail("is neither a grey nor an RGB JPEG");
  Image image(width, height);
  int order[] = {1, bands == 3 ? 2 : 1, bands == 3 ? 3 : 1};
  for (int y = 0; y < height; ++y) {
    if (dataset->RasterIO(GF_Read, 0, y, width, 1, image.pixel(0, y), width, 1, GDT_Byte, 3, order, 3, 0, 1, nullptr) !=
        CE_None)
      call.fail("is a damaged JPEG");
  }
  return image;
}

}  // namespace

Image read_image(std::span<const uint8_t> bytes, const std::string& name) {
  if (is_png(bytes)) return from_png(bytes, name);
  if (is_jpeg(bytes)) return from_jpeg(bytes, name);
  throw IoError(name, bytes.empty() ? "is empty" : "is neither PNG nor JPEG");
}

Image read_image(const std::string& path) { return read_image(read_file(path, kMostBytes), path); }

std::vector<uint8_t> encode_png(const Image& image) {
  if (image.width < 1 || image.height < 1) throw InvalidArgument("image", "is empty");
  return encode_png8(image.rgb, image.width, image.height, 3);
}

void write_png(const Image& image, const std::string& path) { write_bytes(path, encode_png(image)); }

std::vector<uint8_t> encode_jpeg(const Image& image, int quality, const std::string& name) {
  if (image.width < 1 || image.height < 1) throw InvalidArgument("image", "is empty");
  constexpr int kLongest = 65500;
  if (std::max(image.width, image.height) > kLongest)
    throw IoError(name, "a JPEG has at most " + std::to_string(kLongest) + " pixels a side; write a PNG");
  static std::atomic<uint64_t> count{0};
  const std::string place = "/vsimem/seamount-jpeg-" + std::to_string(count++) + ".jpg";
  GdalCall call(name);
  call.hide(place);
  auto& drivers = *GetGDALDriverManager();
  const DatasetPtr memory(drivers.GetDriverByName("MEM")->Create("", image.width, image.height, 3, GDT_Byte, nullptr));
  std::vector<uint8_t> rgb = image.rgb;
  if (memory == nullptr ||
      memory->RasterIO(GF_Write, 0, 0, image.width, image.height, rgb.data(), image.width, image.height, GDT_Byte, 3,
                       nullptr, 3, GSpacing{3} * image.width, 1, nullptr) != CE_None)
    call.fail("cannot be made");
  CPLStringList how;
  how.SetNameValue("QUALITY", std::to_string(quality).c_str());
  DatasetPtr(
      drivers.GetDriverByName("JPEG")->CreateCopy(place.c_str(), memory.get(), FALSE, how.List(), nullptr, nullptr))
      .reset();
  vsi_l_offset length = 0;
  GByte* bytes = VSIGetMemFileBuffer(place.c_str(), &length, FALSE);
  std::vector<uint8_t> file;
  if (bytes != nullptr) file.assign(bytes, bytes + length);
  VSIUnlink(place.c_str());
  call.check("cannot be written as JPEG");
  if (file.empty()) call.fail("cannot be written as JPEG");
  return file;
}

const std::vector<std::string>& picture_extensions() {
  static const std::vector<std::string> kExtensions = {".png", ".jpg", ".jpeg"};
  return kExtensions;
}

void write_picture(const Image& image, const std::string& path) {
  constexpr int kQuality = 92;
  const std::string extension = extension_of(path);
  if (extension == ".png") return write_png(image, path);
  if (extension == ".jpg" || extension == ".jpeg") return write_bytes(path, encode_jpeg(image, kQuality, path));
  throw IoError(path, "'" + extension + "' is not a format that pictures are written to; there are .png, .jpg, .jpeg");
}

}  // namespace seamount::io
