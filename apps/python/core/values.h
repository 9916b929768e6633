// Values of recipes as objects of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "seamount/recipe/value.h"

namespace seamount::python {

namespace py = pybind11;

/// A value, and whether its numbers may be changed: what an operator made for this caller alone may be, what a recipe
/// keeps may not.
struct Held {
  recipe::Value value;
  bool own = false;
};

/// (width, height, cell_m, west_m, north_m, crs), as the class Frame of the package has it.
py::tuple frame_tuple(const GridFrame& frame);
/// Throws InvalidArgument for a frame that no raster can have.
GridFrame frame_of(const py::tuple& frame);
/// None: nothing.
std::optional<GridFrame> frame_of_any(py::handle frame);

/// Adds the class Value, what reads and makes values, and what they hold.
void add_values(py::module_& module);
/// What is in values that are no rasters: features, networks, tables.
void add_contents(py::module_& module);
/// How values become files.
void add_save(py::module_& module);

}  // namespace seamount::python
