// Pictures side by side with a line under each: what a sweep made, at a glance.
#pragma once

#include <string>
#include <vector>

#include "seamount/model/image.h"

namespace seamount::render {

/// A picture and what stands under it.
struct SheetCell {
  Image picture;
  std::string caption;
};

/// The cells in rows of `columns`, in their order, on white. Pictures larger than a cell are made smaller by the mean
/// of what a pixel covers; a cell is as wide as the widest of them, but the sheet about 2400 pixels at most where that
/// leaves them 160. A caption that is too long is written smaller, then cut. Throws InvalidArgument{"columns"} below 1,
/// IncompatibleInputs for no cells, Error without a font. Linear in the pixels of all pictures.
Image contact_sheet(const std::vector<SheetCell>& cells, int columns);

}  // namespace seamount::render
