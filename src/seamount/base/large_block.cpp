#include "seamount/base/large_block.h"

#include <atomic>
#include <map>
#include <mutex>
#include <new>
#include <utility>

#include "seamount/base/borrowed_block.h"

#ifdef __linux__
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace seamount {
namespace {

constexpr size_t kLarge = size_t{4} << 20;
constexpr std::align_val_t kHugePage{size_t{2} << 20};

/// What this thread is to be given next; null: nothing in particular.
thread_local void* offered = nullptr;
thread_local size_t offered_bytes = 0;

/// How often each block of somebody else is in use. Asked by every free_block(), of which few programs have any.
struct Borrowed {
  std::atomic<size_t> count{0};
  std::mutex mutex;
  std::map<void*, size_t> uses;

  void take(void* p) {
    const std::lock_guard lock(mutex);
    ++uses[p];
    ++count;
  }

  /// False: the block is not borrowed.
  bool give_back(void* p) {
    if (count.load(std::memory_order_relaxed) == 0) return false;
    const std::lock_guard lock(mutex);
    const auto found = uses.find(p);
    if (found == uses.end()) return false;
    if (--found->second == 0) uses.erase(found);
    --count;
    return true;
  }
};

Borrowed& borrowed() {
  static auto* const all = new Borrowed;  // never destroyed: static containers are freed after everything else
  return *all;
}

}  // namespace

BorrowedBlock::BorrowedBlock(void* p, size_t bytes) {
  offered = p;
  offered_bytes = bytes;
}
BorrowedBlock::~BorrowedBlock() { offered = nullptr; }

void* allocate_block(size_t bytes) {
  if (offered != nullptr && bytes == offered_bytes) {
    borrowed().take(offered);
    return std::exchange(offered, nullptr);
  }
  if (bytes < kLarge) return ::operator new(bytes);
  void* p = ::operator new(bytes, kHugePage);
#ifdef __linux__
  madvise(p, bytes, MADV_HUGEPAGE);  // advice: without huge pages nothing is lost
#endif
  return p;
}

void free_block(void* p, size_t bytes) noexcept {
  if (borrowed().give_back(p)) return;
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
