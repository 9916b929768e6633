#include "buffer.h"

#include <fmt/format.h>

#include "seamount/base/error.h"

namespace seamount::python {
namespace {

/// A view of an array that is released with the interpreter's lock held.
std::shared_ptr<Py_buffer> view_of(py::handle array) {
  auto* view = new Py_buffer{};
  if (PyObject_GetBuffer(array.ptr(), view, PyBUF_FORMAT | PyBUF_C_CONTIGUOUS) != 0) {
    delete view;
    PyErr_Clear();
    throw InvalidArgument("array", "is no array of numbers that stand side by side in memory");
  }
  return {view, [](Py_buffer* held) {
            if (Py_IsInitialized() == 0) return;  // the interpreter is gone, and its memory with it
            const py::gil_scoped_acquire acquired;
            PyBuffer_Release(held);
            delete held;
          }};
}

std::string shape_text(const Py_buffer& view) {
  std::string text;
  for (int i = 0; i < view.ndim; ++i) text += (i > 0 ? " x " : "") + std::to_string(view.shape[i]);
  return text;
}

}  // namespace

HeldArray hold_array(py::handle array, char format, Py_ssize_t height, Py_ssize_t width, Py_ssize_t depth) {
  auto view = view_of(array);
  const bool fits = view->ndim == (depth > 1 ? 3 : 2) && view->shape[0] == height && view->shape[1] == width &&
                    (depth == 1 || view->shape[2] == depth);
  if (!fits)
    throw InvalidArgument("array", fmt::format("is {}; {} rows of {} columns{} are wanted", shape_text(*view), height,
                                               width, depth > 1 ? fmt::format(" of {}", depth) : ""));
  if (view->format == nullptr || std::string(view->format) != std::string(1, format))
    throw InvalidArgument("array", fmt::format("holds numbers of the type '{}', not '{}'",
                                               view->format == nullptr ? "B" : view->format, format));
  const void* data = view->buf;
  return {data, std::move(view)};
}

void add_buffer(py::module_& module) {
  py::class_<Buffer>(module, "Buffer", py::buffer_protocol()).def_buffer([](const Buffer& buffer) {
    return py::buffer_info(const_cast<void*>(buffer.data), buffer.item, buffer.format,
                           static_cast<Py_ssize_t>(buffer.shape.size()), buffer.shape, buffer.strides,
                           !buffer.writable);
  });
}

}  // namespace seamount::python
