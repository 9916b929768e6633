// catalogue: what may grow in a scene, and by which rules.
#include <array>
#include <string>

#include "seamount/io/atomic_file.h"
#include "seamount/io/input_file.h"
#include "seamount/recipe/catalogue_json.h"
#include "seamount/recipe/format.h"
#include "seamount/recipe/json_text.h"
#include "seamount/recipe/kinds.h"

namespace seamount::recipe {
namespace {

size_t size_of(const seamount::Catalogue& catalogue) {
  size_t size = sizeof catalogue + catalogue.materials.size() * sizeof(Material);
  for (const ObjectClass& of : catalogue.classes) size += sizeof of + of.fitness.size() + of.fitting.size();
  return size;
}

seamount::Catalogue from_bytes(Reader& reader) {
  try {
    return parse_catalogue(reader.text(), "cached catalogue");
  } catch (const RecipeError&) {
    throw Damaged();
  }
}

/// Of a JSON file that says that it is a catalogue.
std::optional<io::FileInfo> describe(const std::string& path) {
  if (io::extension_of(path) != ".json" || !is_catalogue_text(io::read_text(path, kLargestText + 1, {})))
    return std::nullopt;
  const seamount::Catalogue catalogue = read_catalogue(path);
  io::FileInfo info = {{"format", "catalogue of environmental objects"}};
  if (!catalogue.name.empty()) info.emplace_back("name", catalogue.name);
  if (!catalogue.about.empty()) info.emplace_back("about", catalogue.about);
  const auto names = [](const auto& items) {
    std::string text;
    for (const auto& item : items) text += (text.empty() ? "" : ", ") + item.name;
    return text.empty() ? "none" : text;
  };
  info.emplace_back("materials", names(catalogue.materials));
  std::array<std::string, 3> of_kind;
  for (const ObjectClass& of : catalogue.classes) {
    std::string& text = of_kind[static_cast<size_t>(of.skeleton)];
    text += (text.empty() ? "" : ", ") + of.name;
  }
  for (size_t k = 0; k < of_kind.size(); ++k)
    if (!of_kind[k].empty()) info.emplace_back(std::string(Choices<SkeletonKind>::names[k]) + "s", of_kind[k]);
  return info;
}

}  // namespace

const Kind& kinds::Catalogue::kind() {
  static const Kind kind = make_kind<seamount::Catalogue>({
      .name = "catalogue",
      .about = "classes of environmental objects and materials",
      .files = {".json"},
      .reads = {".json"},
      .frame = {},
      .bytes = size_of,
      .write = [](Writer& writer,
                  const seamount::Catalogue& catalogue) { writer.text(catalogue_json(catalogue).dump()); },
      .read = from_bytes,
      .read_file = [](const FileCall& call) { return read_catalogue(call.path, call.run); },
      .info = describe,
  });
  return kind;
}

void kinds::Catalogue::add_formats(Registry& registry) {
  registry.add(make_format<NoParams>(
      {"catalogue", "a catalogue with all its defaults: JSON", {".json"}, {".json"}, {&kind()}},
      [](const NoParams&, const OutputCall& call) {
        io::write_text(call.path,
                       readable_text(OrderedJson::parse(catalogue_json(call.value.get<Catalogue>()).dump())));
      }));
}

}  // namespace seamount::recipe
