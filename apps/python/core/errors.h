// The library's errors as exceptions of Python.
#pragma once

#include <pybind11/pybind11.h>

#include "seamount/recipe/diagnostics.h"

namespace seamount::python {

namespace py = pybind11;

/// Adds the classes to the module and translates from then on.
void add_errors(py::module_& module);

/// Throws what a set of defects of one call's parameters is: InvalidArgument of the first one, which knows them all as
/// `diagnostics`. REQUIRES: there is one.
[[noreturn]] void throw_defects(const recipe::Diagnostics& defects);

}  // namespace seamount::python
