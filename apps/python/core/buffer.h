// Memory of values as NumPy sees it, and arrays of NumPy as grids see them: neither is copied. Through Python's buffer
// protocol, so that any version of NumPy fits.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

namespace seamount::python {

namespace py = pybind11;

/// A block of numbers that a value owns, handed out to arrays; numpy.asarray() of it makes one without a copy, which
/// keeps the value alive.
struct Buffer {
  std::shared_ptr<const void> owner;
  const void* data = nullptr;
  Py_ssize_t item = 1;
  std::string format;  ///< of the module struct
  std::vector<Py_ssize_t> shape;
  std::vector<Py_ssize_t> strides;  ///< in bytes
  bool writable = false;
};

/// Of a contiguous block of numbers.
template <class T>
Buffer buffer_of(std::shared_ptr<const void> owner, const T* data, std::vector<Py_ssize_t> shape, bool writable) {
  Buffer buffer{std::move(owner), data, sizeof(T), py::format_descriptor<T>::format(), std::move(shape), {}, writable};
  buffer.strides.assign(buffer.shape.size(), sizeof(T));
  for (size_t i = buffer.shape.size(); i-- > 1;) buffer.strides[i - 1] = buffer.strides[i] * buffer.shape[i];
  return buffer;
}

/// An array that somebody else owns, held until `keeper` is let go, in whichever thread.
struct HeldArray {
  const void* data = nullptr;
  std::shared_ptr<const void> keeper;
};

/// `array` of width columns and height rows (times `depth` numbers each, if that is above 1) of a format of the module
/// struct, contiguous row by row. Throws InvalidArgument{"array"} for another shape or type.
HeldArray hold_array(py::handle array, char format, Py_ssize_t height, Py_ssize_t width, Py_ssize_t depth = 1);

void add_buffer(py::module_& module);

}  // namespace seamount::python
