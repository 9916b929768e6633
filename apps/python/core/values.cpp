#include "values.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "buffer.h"
#include "json.h"
#include "seamount/base/text.h"
#include "seamount/io/find_model.h"
#include "seamount/io/image_file.h"
#include "seamount/io/projection.h"
#include "seamount/model/borrowed_grid.h"
#include "seamount/recipe/domain.h"
#include "seamount/recipe/kinds.h"
#include "seamount/recipe/registry.h"
#include "seamount/recipe/value_bytes.h"
#include "work.h"

namespace seamount::python {
namespace {

using recipe::Value;
namespace kinds = recipe::kinds;

constexpr int kMostCellsASide = 65536;
constexpr int64_t kMostCells = int64_t{1} << 30;

void check_number(const char* name, double value) {
  if (!std::isfinite(value)) throw InvalidArgument(name, format_number(value) + " is no number");
}

/// What keeps a value's numbers alive.
std::shared_ptr<const void> keeper_of(const Value& value) { return std::make_shared<const Value>(value); }

template <class T>
Buffer cells_of(std::shared_ptr<const void> owner, const Grid<T>& grid, bool writable) {
  using Number = std::conditional_t<std::is_same_v<T, Region>, uint8_t, T>;
  return buffer_of(std::move(owner), reinterpret_cast<const Number*>(grid.data()), {grid.height(), grid.width()},
                   writable);
}

/// The numbers of a raster or picture, a block for each band.
py::list bands_of(const Held& held) {
  const Value& value = held.value;
  py::list bands;
  const auto add = [&](Buffer buffer) { bands.append(py::cast(std::move(buffer))); };
  if (value.is<kinds::Terrain>()) {
    add(cells_of(keeper_of(value), value.get<kinds::Terrain>(), held.own));
  } else if (value.is<kinds::Field>()) {
    add(cells_of(keeper_of(value), value.get<kinds::Field>(), held.own));
  } else if (value.is<kinds::Labels>()) {
    add(cells_of(keeper_of(value), value.get<kinds::Labels>(), held.own));
  } else if (value.is<kinds::Current>()) {
    add(cells_of(keeper_of(value), value.get<kinds::Current>().x, held.own));
    add(cells_of(keeper_of(value), value.get<kinds::Current>().y, held.own));
  } else if (value.is<kinds::Image>()) {
    const auto& image = value.get<kinds::Image>();
    add(buffer_of(keeper_of(value), image.rgb.data(), {image.height, image.width, 3}, held.own));
  }
  return bands;
}

/// A raster of one of the kinds over arrays: float32, uint8 for labels; two for a current.
Held raster(const std::string& kind, const py::tuple& frame, const py::list& arrays) {
  const GridFrame where = frame_of(frame);
  const auto hold = [&](size_t i, char format) { return hold_array(arrays[i], format, where.height, where.width); };
  const auto numbers = [&](size_t i) {
    const HeldArray array = hold(i, 'f');
    return borrow_cells(where, static_cast<const float*>(array.data), array.keeper);
  };
  if (kind == "labels") {
    const HeldArray array = hold(0, 'B');
    const auto* cells = static_cast<const uint8_t*>(array.data);
    const auto wrong = std::find_if(cells, cells + where.cells(), [](uint8_t cell) { return cell >= kRegionCount; });
    if (wrong != cells + where.cells())
      throw InvalidArgument("array",
                            fmt::format("{} is no region: 0 mountain, 1 beach, 2 lagoon, 3 reef, 4 abyss", *wrong));
    return {Value(kinds::Labels::kind(), borrow_cells(where, reinterpret_cast<const Region*>(cells), array.keeper)),
            true};
  }
  if (kind == "current") {  // two grids of one value: copied
    return {Value::of<kinds::Current>(VectorField{*numbers(0), *numbers(1)}), true};
  }
  return {Value(kind == "terrain" ? kinds::Terrain::kind() : kinds::Field::kind(), numbers(0)), true};
}

Held image(const py::object& array, Py_ssize_t width, Py_ssize_t height) {
  const HeldArray held = hold_array(array, 'B', height, width, 3);
  Image image(static_cast<int>(width), static_cast<int>(height));
  std::copy_n(static_cast<const uint8_t*>(held.data), image.rgb.size(), image.rgb.begin());
  return {Value::of<kinds::Image>(std::move(image)), true};
}

py::bytes png(const py::object& array, Py_ssize_t width, Py_ssize_t height) {
  const HeldArray held = hold_array(array, 'B', height, width, 3);
  Image image(static_cast<int>(width), static_cast<int>(height));
  std::copy_n(static_cast<const uint8_t*>(held.data), image.rgb.size(), image.rgb.begin());
  std::vector<uint8_t> bytes;
  {
    const py::gil_scoped_release released;
    bytes = io::encode_png(image);
  }
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

const recipe::Kind& kind_of(const std::string& name) {
  const recipe::Kind* kind = recipe::standard_registry().find_kind(name);
  if (kind == nullptr) throw InvalidArgument("kind", "there is no kind of value '" + name + "'");
  return *kind;
}

/// A value from a file, and what was said while it was read.
py::tuple read_value(const std::string& kind, const std::string& path, const py::object& frame) {
  const recipe::Kind& wanted = kind_of(kind);
  if (!wanted.read_file) throw IoError(path, "a " + kind + " is written, never read");
  const GridFrame where = frame_of_any(frame).value_or(recipe::domain_frame({}));
  Work work(0, py::none());
  Held read{work.run([&] { return Value(wanted, wanted.read_file({path, where, false, work.context()})); }), true};
  return py::make_tuple(py::cast(std::move(read)), to_texts(work.notes()));
}

py::bytes to_bytes(const Held& held) {
  std::ostringstream out(std::ios::binary);
  {
    const py::gil_scoped_release released;
    recipe::write_values(out, {{"value", held.value}});
  }
  return py::bytes(out.str());
}

Held from_bytes(const py::bytes& bytes) {
  std::istringstream in(std::string(bytes), std::ios::binary);
  const py::gil_scoped_release released;
  const auto values = recipe::read_values(in, recipe::standard_registry());
  if (!values || values->count("value") == 0) throw InvalidArgument("state", "is not what a value was pickled to");
  return {values->at("value"), true};
}

/// Of a domain as documents state it.
py::tuple domain(double width_m, double height_m, double cell_m, const std::string& crs, double x_m, double y_m) {
  return frame_tuple(recipe::domain_frame({width_m, height_m, cell_m, crs, x_m, y_m}));
}

}  // namespace

py::tuple frame_tuple(const GridFrame& frame) {
  return py::make_tuple(frame.width, frame.height, frame.cell_m, frame.west_m, frame.north_m, to_text(frame.crs));
}

GridFrame frame_of(const py::tuple& frame) {
  const auto side = [&](size_t index, const char* name) {
    const auto cells = frame[index].cast<int64_t>();
    if (cells >= 1 && cells <= kMostCellsASide) return static_cast<int>(cells);
    throw InvalidArgument(name, fmt::format("{} is outside [1, {}]", cells, kMostCellsASide));
  };
  GridFrame made{side(0, "width"),        side(1, "height"),       frame[2].cast<double>(),
                 frame[3].cast<double>(), frame[4].cast<double>(), frame[5].cast<std::string>()};
  if (made.cells() > kMostCells) throw InvalidArgument("width", "more than 2^30 cells are not possible");
  check_number("cell_m", made.cell_m);
  if (made.cell_m <= 0) throw InvalidArgument("cell_m", format_number(made.cell_m) + " is not above 0");
  check_number("west_m", made.west_m);
  check_number("north_m", made.north_m);
  return made;
}

std::optional<GridFrame> frame_of_any(py::handle frame) {
  if (frame.is_none()) return std::nullopt;
  return frame_of(frame.cast<py::tuple>());
}

void add_values(py::module_& module) {
  py::class_<Held>(module, "Value")
      .def_property_readonly("kind", [](const Held& held) { return held.value.kind().name; })
      .def_property_readonly("frame",
                             [](const Held& held) -> py::object {
                               const GridFrame* frame = held.value.frame();
                               return frame == nullptr ? py::object(py::none()) : py::object(frame_tuple(*frame));
                             })
      .def("bands", bands_of)
      .def("bytes", [](const Held& held) { return held.value.bytes(); })
      .def("dump", to_bytes);
  module.def("load", from_bytes);
  module.def("raster", raster);
  module.def("image", image);
  module.def("png", png);
  module.def("read", read_value);
  module.def("frame", [](const py::tuple& frame) { return frame_tuple(frame_of(frame)); });
  module.def("domain", domain);
  module.def("metric_crs", io::metric_crs);
  module.def("crs_name", io::crs_name);
  module.def("model_file", io::find_model);
}

}  // namespace seamount::python
