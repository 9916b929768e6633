// Recipes that are edited and run.
#pragma once

#include <pybind11/pybind11.h>

namespace seamount::python {

namespace py = pybind11;

void add_recipes(py::module_& module);

}  // namespace seamount::python
