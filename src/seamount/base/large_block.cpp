#include "seamount/base/large_block.h"

#include <new>

#ifdef __linux__
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace seamount {
namespace {

constexpr size_t kLarge = size_t{4} << 20;
constexpr std::align_val_t kHugePage{size_t{2} << 20};

}  // namespace

void* allocate_block(size_t bytes) {
  if (bytes < kLarge) return ::operator new(bytes);
  void* p = ::operator new(bytes, kHugePage);
#ifdef __linux__
  madvise(p, bytes, MADV_HUGEPAGE);  // advice: without huge pages nothing is lost
#endif
  return p;
}

void free_block(void* p, size_t bytes) noexcept {
  if (bytes < kLarge)
    ::operator delete(p);
  else
    ::operator delete(p, kHugePage);
}

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, static_cast<int>(kLarge));
  mallopt(M_TRIM_THRESHOLD, 128 << 20);
#endif
}

}  // namespace seamount
