// Python's plain values as JSON and back.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "seamount/recipe/edit.h"

namespace seamount::python {

namespace py = pybind11;

/// Text that may be no UTF-8, such as names of files: what is none comes as Python has it from the file system.
py::str to_text(const std::string& bytes);
py::list to_texts(const std::vector<std::string>& lines);

/// None, bool, whole and real numbers, text, paths, mappings, sequences, and NumPy's numbers and arrays. Throws
/// InvalidArgument{place} for anything else, and beyond 64 levels.
recipe::Json to_json(py::handle value, const std::string& place);
/// The same with the members of mappings in their order.
recipe::OrderedJson to_ordered_json(py::handle value, const std::string& place);

py::object from_json(const recipe::Json& json);
py::object from_json(const recipe::OrderedJson& json);

}  // namespace seamount::python
