// catalogue: what may grow in a scene, and by which rules.
#include "seamount/io/atomic_file.h"
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
      .info = {},
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
