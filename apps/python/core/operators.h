// Operators as functions, and what is known of them.
#pragma once

#include <pybind11/pybind11.h>

namespace seamount::python {

namespace py = pybind11;

void add_operators(py::module_& module);

}  // namespace seamount::python
