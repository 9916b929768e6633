// What the machine has.
#pragma once

#include <cstdint>

namespace seamount {

/// Bytes of its memory; 0 where that cannot be found out.
uint64_t machine_memory();

/// Its processors, whatever this process may use of them; at least 1.
int machine_processors();

}  // namespace seamount
