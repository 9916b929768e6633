// The part of the package `seamount` that is compiled.
#include <pybind11/pybind11.h>

#include "buffer.h"
#include "errors.h"
#include "operators.h"
#include "recipes.h"
#include "seamount/base/version.h"
#include "values.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of the package seamount; use that.";
  module.attr("version") = seamount::kVersion;
  seamount::python::add_errors(module);
  seamount::python::add_buffer(module);
  seamount::python::add_values(module);
  seamount::python::add_contents(module);
  seamount::python::add_save(module);
  seamount::python::add_operators(module);
  seamount::python::add_recipes(module);
}
