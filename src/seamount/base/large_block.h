// Memory for large arrays. A page fault per 4 KiB is a quarter of the time of a fast operator on a 4096 x 4096 grid;
// on huge pages, where the system has them, it is nothing.
#pragma once

#include <cstddef>

namespace seamount {

/// Uninitialised memory, aligned for any type; from 4 MiB on aligned to 2 MiB and on huge pages. Throws std::bad_alloc.
void* allocate_block(size_t bytes);

/// REQUIRES: p from allocate_block(bytes), or null.
void free_block(void* p, size_t bytes) noexcept;

/// For main(): blocks below 4 MiB that are freed stay with the program, so that the next operator finds its scratch
/// memory already mapped. A setting of the whole process, hence never made by the library itself.
void keep_freed_memory();

}  // namespace seamount
