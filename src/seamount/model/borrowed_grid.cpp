#include "seamount/model/borrowed_grid.h"

#include <utility>

#include "seamount/base/borrowed_block.h"

namespace seamount {
namespace {

template <class T>
struct Loan {
  std::shared_ptr<const void> owner;
  Grid<T> grid;  ///< after its owner: gone before it
};

template <class T>
std::shared_ptr<const Grid<T>> borrow(GridFrame frame, const T* cells, std::shared_ptr<const void> owner) {
  const size_t bytes = static_cast<size_t>(frame.cells()) * sizeof(T);
  auto loan = std::make_shared<Loan<T>>();
  loan->owner = std::move(owner);
  {
    const BorrowedBlock block(const_cast<T*>(cells), bytes);  // the grid is const: nobody writes
    loan->grid = Grid<T>(std::move(frame));
  }
  const Grid<T>* grid = &loan->grid;
  return {std::move(loan), grid};
}

}  // namespace

std::shared_ptr<const Grid<float>> borrow_cells(GridFrame frame, const float* cells,
                                                std::shared_ptr<const void> owner) {
  return borrow(std::move(frame), cells, std::move(owner));
}

std::shared_ptr<const LabelMap> borrow_cells(GridFrame frame, const Region* cells, std::shared_ptr<const void> owner) {
  return borrow(std::move(frame), cells, std::move(owner));
}

}  // namespace seamount
