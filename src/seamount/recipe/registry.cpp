#include "seamount/recipe/registry.h"

#include <filesystem>

namespace seamount::recipe {

std::string numbered(const std::string& name, int i) { return i == 0 ? name : name + "_" + std::to_string(i + 1); }
namespace {

const Port* find_port(const std::vector<Port>& ports, std::string_view name) {
  for (const Port& port : ports) {
    if (port.name == name) return &port;
  }
  return nullptr;
}

}  // namespace

std::string Call::resolve(const FilePath& file) const {
  const std::filesystem::path path(file.path);
  return path.is_absolute() ? path.string() : (std::filesystem::path(folder) / path).string();
}

const Port* Operator::find_in(std::string_view port) const { return find_port(in, port); }
const Port* Operator::find_out(std::string_view port) const { return find_port(out, port); }

const Operator* Registry::find(std::string_view name) const {
  for (const Operator& op : operators_) {
    if (op.name == name) return &op;
  }
  return nullptr;
}

std::vector<std::string> Registry::names() const {
  std::vector<std::string> names;
  for (const Operator& op : operators_) names.push_back(op.name);
  return names;
}

const Registry& operators() {
  static const Registry registry = [] {
    Registry all;
    add_terrain_operators(all);
    add_island_operators(all);
    add_contour_operators(all);
    add_contour_conversions(all);
    add_reef_operators(all);
    add_hydrology_operators(all);
    add_erosion_operators(all);
    add_sketch_operators(all);
    add_classify_operators(all);
    add_render_operators(all);
    return all;
  }();
  return registry;
}

}  // namespace seamount::recipe
