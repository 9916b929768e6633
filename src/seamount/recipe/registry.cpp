#include "seamount/recipe/registry.h"

#include <algorithm>
#include <filesystem>

#include "seamount/io/find_model.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

const Port* find_port(const std::vector<Port>& ports, std::string_view name) {
  for (const Port& port : ports) {
    if (port.name == name) return &port;
  }
  return nullptr;
}

template <class Row>
const Row* find_row(const std::vector<std::shared_ptr<const Row>>& rows, std::string_view name) {
  for (const auto& row : rows) {
    if (row->name == name) return row.get();
  }
  return nullptr;
}

template <class... Kinds>
void add_kinds(Registry& registry, std::type_identity<std::tuple<Kinds...>>) {
  (registry.add_kind<Kinds>(), ...);
}

}  // namespace

std::string Call::resolve(const FilePath& file) const {
  const std::filesystem::path path(file.path);
  return path.is_absolute() ? path.string() : (std::filesystem::path(folder) / path).string();
}

std::string Call::resolve(const ModelFile& model) const {
  return model.is_word() ? io::find_model(model.name) : resolve(FilePath{model.name});
}

const Port* Operator::find_in(std::string_view port) const { return find_port(in, port); }
const Port* Operator::find_out(std::string_view port) const { return find_port(out, port); }

bool OutputFormat::takes(const Kind& kind) const {
  return std::find(accepts.begin(), accepts.end(), &kind) != accepts.end();
}

const Kind* Registry::find_kind(std::string_view name) const {
  for (const Kind* kind : kinds_) {
    if (kind->name == name) return kind;
  }
  return nullptr;
}

const Operator* Registry::find_operator(std::string_view name) const { return find_row(operators_, name); }
const OutputFormat* Registry::find_format(std::string_view name) const { return find_row(formats_, name); }

const OutputFormat* Registry::format_for(const std::string& path, const Kind& kind) const {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const auto& format : formats_) {
    if (format->takes(kind) &&
        std::find(format->claims.begin(), format->claims.end(), extension) != format->claims.end())
      return format.get();
  }
  return nullptr;
}

std::vector<std::string> Registry::operator_names() const {
  std::vector<std::string> names;
  for (const auto& op : operators_) names.push_back(op->name);
  return names;
}

const Registry& standard_registry() {
  static const Registry registry = [] {
    Registry all;
    add_kinds(all, std::type_identity<kinds::All>());
    add_terrain_operators(all);
    add_island_operators(all);
    add_contour_operators(all);
    add_contour_conversions(all);
    add_reef_operators(all);
    add_hydrology_operators(all);
    add_erosion_operators(all);
    add_glacier_operators(all);
    add_sketch_operators(all);
    add_learned_operators(all);
    add_ecosystem_operators(all);
    add_amplify_operators(all);
    add_classify_operators(all);
    add_thing_operators(all);
    add_render_operators(all);
    return all;
  }();
  return registry;
}

}  // namespace seamount::recipe
