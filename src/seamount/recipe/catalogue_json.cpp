#include "seamount/recipe/catalogue_json.h"

#include <filesystem>

#include "seamount/io/atomic_file.h"
#include "seamount/io/input_file.h"
#include "seamount/ops/ecosystem/rules.h"

namespace seamount::recipe {
namespace {

const char* const kVersion = "seamount_catalogue";

void read_version(Json& root, const ReadPlace& place) {
  if (!root.is_object() || !root.contains(kVersion)) {
    place.fail(std::string("this is no catalogue: \"") + kVersion + "\": 1 is missing");
    return;
  }
  if (root[kVersion] != 1) place.at(kVersion).fail("version " + root[kVersion].dump() + " is not known; 1 is");
  root.erase(kVersion);
}

}  // namespace

Catalogue parse_catalogue(const std::string& text, const std::string& file, const RunContext& run) {
  const JsonDocument document = parse_json(text, file, run);
  Json root = document.root;
  Diagnostics diagnostics;
  const ReadPlace place{"", diagnostics};
  read_version(root, place);
  Catalogue catalogue;
  if (diagnostics.empty()) {
    root.erase("$schema");
    catalogue = read_params<Catalogue>(root, place);
  }
  if (diagnostics.empty()) {
    for (const ecosystem::CatalogueDefect& defect : ecosystem::find_defects(catalogue))
      diagnostics.add(defect.pointer, defect.message);
  }
  if (!diagnostics.empty()) {
    place_diagnostics(diagnostics, document);
    throw RecipeError(file, diagnostics.items());
  }
  return catalogue;
}

Catalogue read_catalogue(const std::string& path, const RunContext& run) {
  Catalogue catalogue = parse_catalogue(io::read_text(path, kLargestText + 1, run), path, run);
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  for (ObjectClass& of : catalogue.classes) {
    for (ThingParams& thing : of.things) {
      if (thing.shape != ThingForm::file) continue;
      if (thing.file.path.empty())
        throw IoError(path, "the class '" + of.name + "' has a thing of shape file without a file");
      thing.file.path = (folder / thing.file.path).lexically_normal().string();
      io::check_readable(thing.file.path);
    }
  }
  return catalogue;
}

bool is_catalogue_text(const std::string& text) {
  if (text.find(kVersion) == std::string::npos) return false;
  const Json root = Json::parse(text, nullptr, false);
  return root.is_object() && root.contains(kVersion);
}

Json catalogue_json(const Catalogue& catalogue) {
  Json json = write_params(catalogue);
  json[kVersion] = 1;
  return json;
}

Json catalogue_schema() {
  Json properties = Json::object();
  for (const ParamInfo& info : describe_params<Catalogue>()) properties[info.name] = param_schema(info);
  properties[kVersion] = {{"const", 1}};
  properties["$schema"] = {{"type", "string"}};
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"title", "Seamount catalogue of environmental objects"},
          {"type", "object"},
          {"properties", properties},
          {"required", {kVersion}},
          {"additionalProperties", false}};
}

}  // namespace seamount::recipe
