// Memory of somebody else in a container whose allocator is that of large_block.h: what stands in an array of another
// library becomes a grid without a copy.
//
//   const BorrowedBlock block(p, bytes);
//   std::vector<float, Allocator> cells(n);   // lies at p; elements are as they were if construct() leaves them so
#pragma once

#include <cstddef>

namespace seamount {

/// The next allocate_block(bytes) of this thread, within the life of this object, gives `p`; free_block() of it frees
/// nothing. Who borrows keeps the memory alive for as long as the container. The same memory may be borrowed more than
/// once at a time. A block of another size is allocated as ever.
class BorrowedBlock {
 public:
  BorrowedBlock(void* p, size_t bytes);
  ~BorrowedBlock();
  BorrowedBlock(const BorrowedBlock&) = delete;
  BorrowedBlock& operator=(const BorrowedBlock&) = delete;
};

}  // namespace seamount
