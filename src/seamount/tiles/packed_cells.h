// Cells packed without loss, quickly: what lies on disk between two steps of a world in tiles.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace seamount::tiles {

/// Blosc's LZ4 over shuffled bytes: about 2 GB/s a thread both ways. Noise becomes 3/4, an even sea nearly nothing.
/// REQUIRES: fewer than 2^31 bytes.
std::vector<std::byte> pack_cells(std::span<const std::byte> cells, size_t cell_bytes);

/// Back into as many bytes as there were. False for what pack_cells() did not make of so many.
bool unpack_cells(std::span<const std::byte> packed, std::span<std::byte> cells);

}  // namespace seamount::tiles
