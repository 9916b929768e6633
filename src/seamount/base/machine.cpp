#include "seamount/base/machine.h"

#include <unistd.h>

namespace seamount {

uint64_t machine_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), bytes = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && bytes > 0 ? static_cast<uint64_t>(pages) * static_cast<uint64_t>(bytes) : 0;
}

int machine_processors() {
  const long found = ::sysconf(_SC_NPROCESSORS_ONLN);
  return found > 0 ? static_cast<int>(found) : 1;
}

}  // namespace seamount
