#include "seamount/tiles/stored_raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "seamount/base/hash.h"
#include "seamount/io/atomic_file.h"
#include "seamount/tiles/packed_cells.h"
#include "seamount/tiles/windows.h"

namespace seamount::tiles {
namespace fs = std::filesystem;
namespace {

constexpr uint64_t kMagic = 0x323045544c494d53ULL;  // "SMILTE02"
constexpr int kBandRows = 64;

/// What a tile's file begins with. Its packed bands follow, then a list of them.
struct Header {
  uint64_t magic = kMagic;
  int32_t tile = 0, width = 0, height = 0, cell_bytes = 0;
  bool operator==(const Header&) const = default;

  int bands() const { return (height + kBandRows - 1) / kBandRows; }
};

struct Band {
  uint64_t end = 0;  ///< in the file
  Digest digest;     ///< of the packed bytes
};

Header header_of(const Layout& layout, int tile, size_t bytes) {
  const Rect rect = layout.tile(tile);
  return {kMagic, tile, rect.width, rect.height, static_cast<int32_t>(bytes)};
}

/// The bands of a tile's file, as far as it is whole; none if it is missing or another's.
std::vector<Band> bands_of(std::ifstream& file, const Header& wanted) {
  Header found;
  if (!file.read(reinterpret_cast<char*>(&found), sizeof found) || !(found == wanted)) return {};
  std::vector<Band> bands(static_cast<size_t>(wanted.bands()));
  const auto bytes = static_cast<std::streamoff>(bands.size() * sizeof(Band));
  file.seekg(-bytes, std::ios::end);
  const std::streamoff end_of_cells = file.tellg();
  if (!file.read(reinterpret_cast<char*>(bands.data()), bytes)) return {};
  uint64_t end = sizeof(Header);
  for (const Band& band : bands) {
    if (band.end < end) return {};
    end = band.end;
  }
  return end == static_cast<uint64_t>(end_of_cells) ? bands : std::vector<Band>();
}

/// False if the file is damaged there.
bool read_band(std::ifstream& file, const std::vector<Band>& bands, int number, std::span<std::byte> cells) {
  const Band& band = bands[static_cast<size_t>(number)];
  const uint64_t begin = number == 0 ? sizeof(Header) : bands[static_cast<size_t>(number) - 1].end;
  std::vector<std::byte> packed(band.end - begin);
  file.seekg(static_cast<std::streamoff>(begin));
  return file.read(reinterpret_cast<char*>(packed.data()), static_cast<std::streamsize>(packed.size())) &&
         hash_bytes(packed) == band.digest && unpack_cells(packed, cells);
}

template <class T>
std::span<const uint8_t> raw(const T& value) {
  return {reinterpret_cast<const uint8_t*>(&value), sizeof value};
}

}  // namespace

StoredRaster::StoredRaster(std::string folder, const recipe::Kind& kind, GridFrame whole, int tile_size)
    : folder_(std::move(folder)),
      kind_(&kind),
      whole_(std::move(whole)),
      layout_(whole_, tile_size),
      use_(std::make_unique<FolderUse>(folder_)) {}

std::string StoredRaster::path_of(int tile) const {
  return (fs::path(folder_) / fmt::format("{}_{}.tile", tile / layout_.columns(), tile % layout_.columns())).string();
}

bool StoredRaster::has(int tile) const {
  std::ifstream file(path_of(tile), std::ios::binary);
  return file && !bands_of(file, header_of(layout_, tile, cell_bytes(*kind_))).empty();
}

bool StoredRaster::complete() const {
  for (int tile = 0; tile < layout_.count(); ++tile) {
    if (!has(tile)) return false;
  }
  return true;
}

void StoredRaster::write(int tile, const recipe::Value& cells) const {
  const Header header = header_of(layout_, tile, cell_bytes(*kind_));
  const auto row_bytes = static_cast<size_t>(header.width) * static_cast<size_t>(header.cell_bytes);
  const auto* data = static_cast<const std::byte*>(cells_of(cells));
  io::write_atomically(
      path_of(tile),
      [&](const std::string& temporary) {
        io::FileWriter file(temporary, path_of(tile));
        file.write(raw(header));
        std::vector<Band> bands;
        for (int row = 0; row < header.height; row += kBandRows) {
          const std::span<const std::byte> band{
              data + static_cast<size_t>(row) * row_bytes,
              static_cast<size_t>(std::min(kBandRows, header.height - row)) * row_bytes};
          const std::vector<std::byte> packed = pack_cells(band, cell_bytes(*kind_));
          file.write_raw<std::byte>(packed);
          bands.push_back({(bands.empty() ? sizeof header : bands.back().end) + packed.size(), hash_bytes(packed)});
        }
        file.write_raw<Band>(bands);
        file.close();
      },
      io::Durable::later);
}

recipe::Value StoredRaster::read(const Rect& rect) const {
  const Blank blank = blank_raster(*kind_, whole_.window(rect.column, rect.row, rect.width, rect.height));
  read_to(rect, blank.cells);
  return blank.value;
}

void StoredRaster::read_to(const Rect& rect, void* out) const {
  const size_t row_bytes = static_cast<size_t>(rect.width) * cell_bytes(*kind_);
  const int size = layout_.size;
  for (int row = rect.row / size; row <= (rect.row + rect.height - 1) / size; ++row) {
    for (int column = rect.column / size; column <= (rect.column + rect.width - 1) / size; ++column) {
      const int tile = row * layout_.columns() + column;
      const Rect part = common(layout_.tile(tile), rect);
      std::byte* to = static_cast<std::byte*>(out) + static_cast<size_t>(part.row - rect.row) * row_bytes +
                      static_cast<size_t>(part.column - rect.column) * cell_bytes(*kind_);
      read_part(tile, part, to, row_bytes);
    }
  }
}

void StoredRaster::read_part(int tile, const Rect& rect, std::byte* out, size_t row_bytes) const {
  const std::string path = path_of(tile);
  const Header header = header_of(layout_, tile, cell_bytes(*kind_));
  const Rect all = layout_.tile(tile);
  const size_t cell = cell_bytes(*kind_), tile_row = static_cast<size_t>(all.width) * cell;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError(path, "a tile that this run needs has gone; run again");
  const std::vector<Band> bands = bands_of(file, header);
  const int last = rect.row - all.row + rect.height;
  for (int row = (rect.row - all.row) / kBandRows * kBandRows; row < last; row += kBandRows) {
    const int rows = std::min(kBandRows, header.height - row);
    std::vector<std::byte> band(static_cast<size_t>(rows) * tile_row);
    if (bands.empty() || !read_band(file, bands, row / kBandRows, band)) {
      std::error_code gone;
      fs::remove(path, gone);
      throw IoError(path, "a tile of the cache is damaged and was removed; run again");
    }
    for (int y = std::max(row, rect.row - all.row); y < std::min(row + rows, last); ++y)
      std::memcpy(
          out + static_cast<size_t>(y - (rect.row - all.row)) * row_bytes,
          band.data() + static_cast<size_t>(y - row) * tile_row + static_cast<size_t>(rect.column - all.column) * cell,
          static_cast<size_t>(rect.width) * cell);
  }
}

}  // namespace seamount::tiles
