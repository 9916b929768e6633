#include "seamount/io/png_codec.h"

#include <png.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "seamount/base/error.h"

namespace seamount::io {
namespace {

static_assert(std::endian::native == std::endian::little, "16-bit samples are swapped for little-endian machines");

/// libpng's error callback must not return: an exception passes through its frames, which hold no resources of ours.
[[noreturn]] void on_error(png_structp, png_const_charp message) { throw std::runtime_error(message); }
void on_warning(png_structp, png_const_charp) {}

/// A reader over bytes in memory, freed on every way out.
class Reader {
 public:
  explicit Reader(std::span<const uint8_t> file) : rest_(file) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) throw std::runtime_error("out of memory");
    png_set_read_fn(png_, this, take);
    png_set_chunk_malloc_max(png_, size_t{64} << 20);
    png_set_user_limits(png_, 1'000'000, 1'000'000);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// Reads up to the first pixel data and asks for 8 or 16 bits a sample without palettes.
  PngSamples header() {
    png_read_info(png_, info_);
    png_set_expand(png_);
    png_set_swap(png_);
    interlaced_ = png_set_interlace_handling(png_) > 1;
    png_read_update_info(png_, info_);
    PngSamples samples;
    samples.width = static_cast<int>(png_get_image_width(png_, info_));
    samples.height = static_cast<int>(png_get_image_height(png_, info_));
    samples.channels = png_get_channels(png_, info_);
    samples.bits = png_get_bit_depth(png_, info_);
    return samples;
  }

  /// Rows are stored as they come, so that a short file does not cost the memory that its header claims.
  void pixels(PngSamples& samples) {
    const size_t row_bytes = png_get_rowbytes(png_, info_);
    if (interlaced_) return interlaced_pixels(samples, row_bytes);
    std::vector<uint8_t> row(row_bytes);
    for (int y = 0; y < samples.height; ++y) {
      png_read_row(png_, row.data(), nullptr);
      append(samples, row);
    }
    png_read_end(png_, nullptr);
  }

 private:
  static void take(png_structp png, png_bytep to, size_t count) {
    Reader& reader = *static_cast<Reader*>(png_get_io_ptr(png));
    if (count > reader.rest_.size()) png_error(png, "the file ends early");
    std::memcpy(to, reader.rest_.data(), count);
    reader.rest_ = reader.rest_.subspan(count);
  }

  static void append(PngSamples& samples, const std::vector<uint8_t>& row) {
    if (samples.bits == 8) {
      samples.bytes8.insert(samples.bytes8.end(), row.begin(), row.end());
    } else {
      const size_t count = row.size() / 2, old = samples.words16.size();
      samples.words16.resize(old + count);
      std::memcpy(samples.words16.data() + old, row.data(), count * 2);
    }
  }

  void interlaced_pixels(PngSamples& samples, size_t row_bytes) {
    std::vector<uint8_t> all(row_bytes * static_cast<size_t>(samples.height));
    std::vector<png_bytep> rows(static_cast<size_t>(samples.height));
    for (size_t y = 0; y < rows.size(); ++y) rows[y] = all.data() + y * row_bytes;
    png_read_image(png_, rows.data());
    png_read_end(png_, nullptr);
    append(samples, all);
  }

  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::span<const uint8_t> rest_;
  bool interlaced_ = false;
};

/// row(y) points to the samples of a row; it is asked for each once, in order.
template <class Row>
std::vector<uint8_t> encode(Row row, int width, int height, int channels, int bits) {
  std::vector<uint8_t> file;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  try {
    if (info == nullptr) throw std::runtime_error("out of memory");
    const auto put = [](png_structp to, png_bytep from, size_t count) {
      auto& bytes = *static_cast<std::vector<uint8_t>*>(png_get_io_ptr(to));
      bytes.insert(bytes.end(), from, from + count);
    };
    png_set_write_fn(png, &file, put, [](png_structp) {});
    constexpr int kColourTypes[] = {0, PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                    PNG_COLOR_TYPE_RGB_ALPHA};
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
                 kColourTypes[channels], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, 4);
    png_set_filter(png, 0, bits == 16 ? PNG_FILTER_SUB : PNG_FILTER_SUB | PNG_FILTER_UP);
    png_write_info(png, info);
    if (bits == 16) png_set_swap(png);
    for (int y = 0; y < height; ++y) png_write_row(png, row(y));
    png_write_end(png, nullptr);
  } catch (...) {
    png_destroy_write_struct(&png, &info);
    throw;
  }
  png_destroy_write_struct(&png, &info);
  return file;
}

}  // namespace

bool is_png(std::span<const uint8_t> file) { return file.size() >= 8 && png_sig_cmp(file.data(), 0, 8) == 0; }

PngSamples png_header(std::span<const uint8_t> file, const std::string& name) {
  try {
    return Reader(file).header();
  } catch (const std::runtime_error& error) {
    throw IoError(name, std::string("not a readable PNG: ") + error.what());
  }
}

PngSamples decode_png_samples(std::span<const uint8_t> file, const std::string& name, int64_t max_pixels) {
  try {
    Reader reader(file);
    PngSamples samples = reader.header();
    const int64_t pixels = int64_t{samples.width} * samples.height;
    if (pixels > max_pixels)
      throw std::runtime_error(std::to_string(samples.width) + " x " + std::to_string(samples.height) +
                               " pixels are more than " + std::to_string(max_pixels));
    // Deflate packs at most 1032 to 1.
    if (pixels * samples.channels / 8 > static_cast<int64_t>(file.size()) * 1032)
      throw std::runtime_error("the file ends early");
    reader.pixels(samples);
    return samples;
  } catch (const std::runtime_error& error) {
    throw IoError(name, std::string("not a readable PNG: ") + error.what());
  }
}

std::vector<uint8_t> encode_png8(std::span<const uint8_t> samples, int width, int height, int channels) {
  const size_t row_bytes = static_cast<size_t>(width) * static_cast<size_t>(channels);
  return encode([&](int y) { return samples.data() + static_cast<size_t>(y) * row_bytes; }, width, height, channels, 8);
}

std::vector<uint8_t> encode_png16(std::span<const uint16_t> samples, int width, int height) {
  const auto row = [&](int y) {
    return reinterpret_cast<const uint8_t*>(samples.data() + static_cast<size_t>(y) * static_cast<size_t>(width));
  };
  return encode(row, width, height, 1, 16);
}

std::vector<uint8_t> encode_png_rows(int width, int height, int channels,
                                     const std::function<void(int y, std::span<uint8_t> row)>& fill) {
  std::vector<uint8_t> line(static_cast<size_t>(width) * static_cast<size_t>(channels));
  const auto row = [&](int y) {
    fill(y, line);
    return line.data();
  };
  return encode(row, width, height, channels, 8);
}

}  // namespace seamount::io
