// OpenEXR: one float channel in metres.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <cstring>
#include <stdexcept>

#include "seamount/base/error.h"
#include "seamount/io/atomic_file.h"
#include "seamount/io/raster_files.h"

namespace seamount::io {
namespace {

/// Bytes in memory as OpenEXR wants to read them.
class MemoryStream : public Imf::IStream {
 public:
  MemoryStream(std::span<const uint8_t> file, const char* name) : Imf::IStream(name), file_(file) {}
  bool read(char to[], int count) override {
    if (count < 0 || static_cast<uint64_t>(count) > file_.size() - at_) throw std::runtime_error("the file ends early");
    std::memcpy(to, file_.data() + at_, static_cast<size_t>(count));
    at_ += static_cast<uint64_t>(count);
    return at_ < file_.size();
  }
  uint64_t tellg() override { return at_; }
  void seekg(uint64_t place) override {
    if (place > file_.size()) throw std::runtime_error("the file ends early");
    at_ = place;
  }
  void clear() override {}

 private:
  std::span<const uint8_t> file_;
  uint64_t at_ = 0;
};

std::string height_channel(const Imf::ChannelList& channels) {
  for (const char* name : {"Y", "Z", "height", "R"})
    if (channels.findChannel(name) != nullptr) return name;
  if (channels.begin() == channels.end() || ++channels.begin() != channels.end())
    throw std::runtime_error("none of its channels is called Y, Z, height or R");
  return channels.begin().name();
}

Stored decode(std::span<const uint8_t> file, const std::string& name, int64_t max_cells) {
  MemoryStream stream(file, name.c_str());
  Imf::InputFile input(stream);
  const Imath::Box2i box = input.header().dataWindow();
  const int64_t width = int64_t{box.max.x} - box.min.x + 1, height = int64_t{box.max.y} - box.min.y + 1;
  if (width < 1 || height < 1 || width > 1'000'000 || height > 1'000'000 || width * height > max_cells)
    throw std::runtime_error("more than " + std::to_string(max_cells) + " cells");
  const std::string channel = height_channel(input.header().channels());
  const Imf::Channel& kind = input.header().channels()[channel.c_str()];
  if (kind.xSampling != 1 || kind.ySampling != 1) throw std::runtime_error("its channel " + channel + " is subsampled");
  Stored stored{Grid<float>(GridFrame{static_cast<int>(width), static_cast<int>(height)}), 0.0, "EXR",
                kind.type == Imf::HALF    ? "float16"
                : kind.type == Imf::FLOAT ? "float32"
                                          : "uint32"};
  const size_t row_bytes = static_cast<size_t>(width) * sizeof(float);
  std::vector<float> row(static_cast<size_t>(width));
  for (int y = box.min.y; y <= box.max.y; ++y) {
    // One row at a time, always into `row`: a stride of 0 down and the column offset taken off.
    char* base = reinterpret_cast<char*>(row.data()) - static_cast<ptrdiff_t>(box.min.x) * ptrdiff_t{sizeof(float)};
    Imf::FrameBuffer buffer;
    buffer.insert(channel.c_str(), Imf::Slice(Imf::FLOAT, base, sizeof(float), 0));
    input.setFrameBuffer(buffer);
    input.readPixels(y);
    std::memcpy(stored.values.row(y - box.min.y).data(), row.data(), row_bytes);
  }
  return stored;
}

}  // namespace

Stored decode_exr(std::span<const uint8_t> file, const std::string& name, int64_t max_cells) {
  try {
    return decode(file, name, max_cells);
  } catch (const std::exception& error) {
    // OpenEXR begins with the name in quotes, which IoError says already.
    const std::string said = error.what();
    const size_t quote = said.rfind("\". ");
    throw IoError(name, "not a readable EXR: " + (quote == std::string::npos ? said : said.substr(quote + 3)));
  }
}

void encode_exr(const Grid<float>& grid, const std::string& temporary, const std::string& path, const char* channel) {
  try {
    Imf::Header header(grid.width(), grid.height());
    header.compression() = Imf::ZIP_COMPRESSION;
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    Imf::OutputFile output(temporary.c_str(), header);
    Imf::FrameBuffer buffer;
    char* base = reinterpret_cast<char*>(const_cast<float*>(grid.data()));
    const size_t row_bytes = sizeof(float) * static_cast<size_t>(grid.width());
    buffer.insert(channel, Imf::Slice(Imf::FLOAT, base, sizeof(float), row_bytes));
    output.setFrameBuffer(buffer);
    output.writePixels(grid.height());
  } catch (const std::exception& error) {
    throw IoError(path, std::string("cannot be written: ") + error.what());
  }
}

}  // namespace seamount::io
