#include "json.h"

#include "seamount/base/error.h"

namespace seamount::python {
namespace {

constexpr int kDeepest = 64;

template <class AnyJson>
AnyJson convert(py::handle value, const std::string& place, int depth);

/// As UTF-8; names of files that are none come as they are on disk.
std::string text_of(py::handle value) {
  const auto bytes =
      py::reinterpret_steal<py::bytes>(PyUnicode_AsEncodedString(value.ptr(), "utf-8", "surrogateescape"));
  if (!bytes) throw py::error_already_set();
  return bytes;
}

template <class AnyJson>
AnyJson convert_whole(py::handle value, const std::string& place) {
  int overflow = 0;
  const auto number = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
  if (overflow == 0 && number < 0) return static_cast<int64_t>(number);
  if (overflow == 0) return static_cast<uint64_t>(number);  // as text of JSON is read
  const auto large = PyLong_AsUnsignedLongLong(value.ptr());
  if (PyErr_Occurred() == nullptr) return static_cast<uint64_t>(large);
  PyErr_Clear();
  throw InvalidArgument(place, "is a number of more than 64 bits");
}

template <class AnyJson>
AnyJson convert_mapping(py::handle value, const std::string& place, int depth) {
  AnyJson object = AnyJson::object();
  for (const auto& item : py::reinterpret_borrow<py::dict>(value)) {
    if (!py::isinstance<py::str>(item.first)) throw InvalidArgument(place, "has a name that is no text");
    const std::string name = text_of(item.first);
    object[name] = convert<AnyJson>(item.second, place + "." + name, depth + 1);
  }
  return object;
}

template <class AnyJson>
AnyJson convert_list(py::handle value, const std::string& place, int depth) {
  AnyJson list = AnyJson::array();
  size_t index = 0;
  for (const py::handle item : py::reinterpret_borrow<py::sequence>(value))
    list.push_back(convert<AnyJson>(item, place + "[" + std::to_string(index++) + "]", depth + 1));
  return list;
}

/// What is no value of the language itself but says what it is: numbers and arrays of NumPy, paths.
template <class AnyJson>
AnyJson convert_other(py::handle value, const std::string& place, int depth) {
  if (PyIndex_Check(value.ptr()) != 0)
    return convert_whole<AnyJson>(py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr())), place);
  if (py::hasattr(value, "__fspath__")) return convert<AnyJson>(value.attr("__fspath__")(), place, depth + 1);
  if (py::hasattr(value, "tolist")) return convert<AnyJson>(value.attr("tolist")(), place, depth + 1);
  if (PyMapping_Check(value.ptr()) != 0 && py::hasattr(value, "items"))
    return convert_mapping<AnyJson>(py::dict(py::reinterpret_borrow<py::object>(value)), place, depth);
  throw InvalidArgument(place, "is of the type '" + std::string(Py_TYPE(value.ptr())->tp_name) +
                                   "', which is no number, text, list or mapping");
}

template <class AnyJson>
AnyJson convert(py::handle value, const std::string& place, int depth) {
  if (depth > kDeepest) throw InvalidArgument(place, "is nested too deeply");
  if (value.is_none()) return nullptr;
  if (PyBool_Check(value.ptr())) return value.ptr() == Py_True;
  if (PyFloat_Check(value.ptr())) return PyFloat_AS_DOUBLE(value.ptr());
  if (PyLong_Check(value.ptr())) return convert_whole<AnyJson>(value, place);
  if (PyUnicode_Check(value.ptr())) return text_of(value);
  if (PyDict_Check(value.ptr())) return convert_mapping<AnyJson>(value, place, depth);
  if (PyList_Check(value.ptr()) || PyTuple_Check(value.ptr())) return convert_list<AnyJson>(value, place, depth);
  return convert_other<AnyJson>(value, place, depth);
}

template <class AnyJson>
py::object restore(const AnyJson& json) {
  using Type = recipe::Json::value_t;
  switch (json.type()) {
    case Type::boolean:
      return py::bool_(json.template get<bool>());
    case Type::number_integer:
      return py::int_(json.template get<int64_t>());
    case Type::number_unsigned:
      return py::int_(json.template get<uint64_t>());
    case Type::number_float:
      return py::float_(json.template get<double>());
    case Type::string:
      return to_text(json.template get<std::string>());
    case Type::array: {
      py::list list;
      for (const AnyJson& item : json) list.append(restore(item));
      return list;
    }
    case Type::object: {
      py::dict object;
      for (const auto& [name, item] : json.items()) object[to_text(name)] = restore(item);
      return object;
    }
    default:
      return py::none();
  }
}

}  // namespace

py::str to_text(const std::string& bytes) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "surrogateescape"));
}

py::list to_texts(const std::vector<std::string>& lines) {
  py::list list;
  for (const std::string& line : lines) list.append(to_text(line));
  return list;
}

recipe::Json to_json(py::handle value, const std::string& place) { return convert<recipe::Json>(value, place, 0); }
recipe::OrderedJson to_ordered_json(py::handle value, const std::string& place) {
  return convert<recipe::OrderedJson>(value, place, 0);
}
py::object from_json(const recipe::Json& json) { return restore(json); }
py::object from_json(const recipe::OrderedJson& json) { return restore(json); }

}  // namespace seamount::python
