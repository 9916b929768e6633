#include "errors.h"

#include <string>

#include "json.h"
#include "seamount/base/error.h"

namespace seamount::python {
namespace {

/// InvalidArgument with all that was found.
class InvalidArguments : public InvalidArgument {
 public:
  InvalidArguments(std::string field, const std::string& problem, std::vector<recipe::Diagnostic> all)
      : InvalidArgument(std::move(field), problem), diagnostics(std::move(all)) {}
  std::vector<recipe::Diagnostic> diagnostics;
};

/// Exception classes; they live as long as the interpreter.
struct Classes {
  py::object error, invalid_argument, incompatible_inputs, io_error, write_error, cancelled, recipe_error;
};
Classes& classes() {
  static auto* const all = new Classes;
  return *all;
}

py::object new_class(py::module_& module, const char* name, const py::tuple& bases, const char* doc) {
  py::dict body;
  body["__doc__"] = doc;
  body["__module__"] = "seamount";
  py::object made = py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(&PyType_Type))(name, bases, body);
  module.attr(name) = made;
  return made;
}

py::object make(const py::object& of, const std::exception& error) { return of(to_text(error.what())); }

void raise(const py::object& exception) {
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(exception.ptr())), exception.ptr());
}

py::list diagnostics_list(const std::vector<recipe::Diagnostic>& diagnostics) {
  py::list list;
  for (const recipe::Diagnostic& one : diagnostics) {
    py::dict row;
    row["pointer"] = to_text(one.pointer);
    row["message"] = to_text(one.message);
    row["line"] = one.line;
    row["column"] = one.column;
    list.append(row);
  }
  return list;
}

void raise_invalid(const InvalidArgument& error, const std::vector<recipe::Diagnostic>& diagnostics) {
  const py::object exception = make(classes().invalid_argument, error);
  exception.attr("field") = to_text(error.field());
  exception.attr("diagnostics") = diagnostics_list(diagnostics);
  raise(exception);
}

void raise_io(const py::object& of, const IoError& error) {
  const py::object exception = make(of, error);
  exception.attr("path") = to_text(error.path());
  raise(exception);
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const recipe::RecipeError& error) {
    const py::object exception = make(classes().recipe_error, error);
    exception.attr("diagnostics") = diagnostics_list(error.diagnostics());
    exception.attr("field") = to_text(error.diagnostics().empty() ? "" : error.diagnostics().front().pointer);
    raise(exception);
  } catch (const InvalidArguments& error) {
    raise_invalid(error, error.diagnostics);
  } catch (const InvalidArgument& error) {
    raise_invalid(error, {});
  } catch (const IncompatibleInputs& error) {
    raise(make(classes().incompatible_inputs, error));
  } catch (const WriteError& error) {
    raise_io(classes().write_error, error);
  } catch (const IoError& error) {
    raise_io(classes().io_error, error);
  } catch (const Cancelled& error) {
    raise(make(classes().cancelled, error));
  } catch (const Error& error) {
    raise(make(classes().error, error));
  }
}

/// "/edits/2/radius_m" as "edits[2].radius_m".
std::string field_of(const std::string& pointer) {
  std::string field;
  for (size_t begin = 1; begin < pointer.size();) {
    const size_t end = std::min(pointer.find('/', begin), pointer.size());
    const std::string part = pointer.substr(begin, end - begin);
    const bool index = part.find_first_not_of("0123456789") == std::string::npos;
    field += index ? "[" + part + "]" : (field.empty() ? "" : ".") + part;
    begin = end + 1;
  }
  return field;
}

}  // namespace

void throw_defects(const recipe::Diagnostics& defects) {
  const recipe::Diagnostic& first = defects.items().front();
  std::string message = first.message;
  const std::string name = first.pointer.substr(first.pointer.rfind('/') + 1) + ": ";
  if (message.starts_with(name)) message.erase(0, name.size());  // it is said once
  throw InvalidArguments(field_of(first.pointer), message, defects.items());
}

void add_errors(py::module_& module) {
  const auto builtin = [](PyObject* type) { return py::reinterpret_borrow<py::object>(type); };
  const py::object value_error = builtin(PyExc_ValueError);
  Classes& all = classes();
  all.error = new_class(module, "Error", py::make_tuple(builtin(PyExc_Exception)),
                        "Base of everything that Seamount raises on purpose; its text is one line for people.");
  all.invalid_argument = new_class(
      module, "InvalidArgument", py::make_tuple(all.error, value_error),
      "A parameter breaks its rule. `field` is its name, `diagnostics` a list of all that was found in the call.");
  all.incompatible_inputs = new_class(module, "IncompatibleInputs", py::make_tuple(all.error, value_error),
                                      "Inputs are fine one by one but not together.");
  all.io_error = new_class(module, "IoError", py::make_tuple(all.error, builtin(PyExc_OSError)),
                           "A file cannot be read, understood or written. `path` is the file.");
  all.write_error = new_class(module, "WriteError", py::make_tuple(all.io_error),
                              "A file cannot be written; what it was made of may be fine.");
  all.cancelled = new_class(module, "Cancelled", py::make_tuple(all.error), "The work was asked to stop.");
  all.recipe_error =
      new_class(module, "RecipeError", py::make_tuple(all.error, value_error),
                "A document cannot be used. `diagnostics` lists every defect: pointer, message, line, column; `field` "
                "is the pointer of the first.");
  py::register_exception_translator(translate);
}

}  // namespace seamount::python
