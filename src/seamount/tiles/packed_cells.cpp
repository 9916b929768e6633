#include "seamount/tiles/packed_cells.h"

#include <blosc.h>

#include <algorithm>

namespace seamount::tiles {

std::vector<std::byte> pack_cells(std::span<const std::byte> cells, size_t cell_bytes) {
  std::vector<std::byte> packed(cells.size() + BLOSC_MAX_OVERHEAD);
  const int bytes = blosc_compress_ctx(3, BLOSC_SHUFFLE, cell_bytes, cells.size(), cells.data(), packed.data(),
                                       packed.size(), BLOSC_LZ4_COMPNAME, 0, 1);
  packed.resize(static_cast<size_t>(std::max(bytes, 0)));
  return packed;
}

bool unpack_cells(std::span<const std::byte> packed, std::span<std::byte> cells) {
  size_t bytes = 0;
  if (blosc_cbuffer_validate(packed.data(), packed.size(), &bytes) != 0 || bytes != cells.size()) return false;
  return blosc_decompress_ctx(packed.data(), cells.data(), cells.size(), 1) == static_cast<int>(cells.size());
}

}  // namespace seamount::tiles
