// list, describe, schema, new: finding out what there is and where to start.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>

#include "app.h"
#include "examples.h"
#include "seamount/base/text.h"
#include "seamount/io/atomic_file.h"
#include "seamount/recipe/catalogue_json.h"
#include "seamount/recipe/catalogue_reference.h"
#include "seamount/recipe/reference.h"
#include "seamount/recipe/typescript.h"

namespace seamount::app {
namespace {

namespace fs = std::filesystem;

const char* const kCatalogue = "catalogue";
const char* const kTypescript = "typescript";

void list(const recipe::Registry& registry, bool json) {
  if (json) {
    recipe::Json names = {
        {"operators", recipe::Json::array()}, {"formats", recipe::Json::array()}, {"kinds", recipe::Json::array()}};
    for (const auto& op : registry.operators())
      names["operators"].push_back({{"name", op->name}, {"summary", op->summary}});
    for (const auto& format : registry.formats())
      names["formats"].push_back({{"name", format->name}, {"summary", format->summary}});
    for (const recipe::Kind* kind : registry.kinds())
      names["kinds"].push_back({{"name", kind->name}, {"summary", kind->about}});
    std::cout << names.dump(2) << "\n";
    return;
  }
  std::cout << "operators (seamount describe NAME)\n";
  for (const auto& op : registry.operators()) fmt::print("  {:<20} {}\n", op->name, op->summary);
  fmt::print("\noutput formats (\"as\" in a recipe)\n");
  for (const auto& format : registry.formats()) fmt::print("  {:<20} {}\n", format->name, format->summary);
  std::cout << "\nkinds of values\n";
  for (const recipe::Kind* kind : registry.kinds()) fmt::print("  {:<20} {}\n", kind->name, kind->about);
}

/// The operators whose names begin with "name."; false if there are none.
bool describe_family(const recipe::Registry& registry, const std::string& name, bool after_other) {
  bool any = false;
  for (const auto& op : registry.operators()) {
    if (!op->name.starts_with(name + ".")) continue;
    if (!any && after_other) std::cout << "\n";
    if (!any) fmt::print("operators of the family {} (seamount describe NAME)\n", name);
    any = true;
    fmt::print("  {:<20} {}\n", op->name, op->summary);
  }
  return any;
}

void describe(const recipe::Registry& registry, const std::string& name, bool markdown) {
  if (markdown && name.empty()) {
    std::cout << recipe::reference_markdown(registry);
    return;
  }
  if (markdown) {
    if (name != kCatalogue) throw InvalidArgument("--markdown", "is for the whole reference, or for 'catalogue'");
    std::cout << recipe::catalogue_markdown();
    return;
  }
  const auto* op = registry.find_operator(name);
  const auto* format = registry.find_format(name);
  const auto* kind = registry.find_kind(name);
  if (op != nullptr) std::cout << recipe::describe_operator(*op);
  if (format != nullptr) std::cout << recipe::describe_format(*format);
  if (format != nullptr && kind != nullptr) std::cout << "\n";  // labels, drawing, ... are both
  if (kind != nullptr) std::cout << recipe::describe_kind(*kind, registry);
  if (name == kCatalogue) std::cout << "\n" << recipe::describe_catalogue();
  const bool one_thing = format != nullptr || kind != nullptr;
  const bool family = op == nullptr && describe_family(registry, name, one_thing);
  if (op != nullptr || one_thing || family) return;
  std::vector<std::string> names = registry.operator_names();
  for (const auto& row : registry.formats()) names.push_back(row->name);
  for (const recipe::Kind* row : registry.kinds()) names.push_back(row->name);
  throw InvalidArgument(name, "is no operator, output format or kind of value" + suggestion(name, names));
}

void write_new_file(const fs::path& path, std::string_view content) {
  if (fs::exists(path)) throw IoError(path.string(), "exists already; nothing was written over it");
  io::write_atomically(path.string(), [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file << content;
    if (!file.flush()) throw WriteError(path.string(), "cannot be written");
  });
  std::cout << path.string() << "\n";
}

/// Examples by name, each with what it says of itself.
void list_examples() {
  std::cout << "examples (seamount new NAME)\n";
  for (const Example& example : example_files()) {
    if (!has_name(example)) continue;
    const std::string about = example_about(example);
    fmt::print("  {:<28} {}\n", example.file.substr(0, example.file.size() - 5), about.substr(0, about.find('.')));
  }
}

/// Writes an example recipe, and beside it the data that it names; without a name lists them.
void make_new(const std::string& name, const std::string& folder) {
  if (name.empty()) return list_examples();
  const Example& recipe = find_example(name);
  if (is_catalogue(recipe)) return write_new_file(fs::path(folder) / fs::path(recipe.file).filename(), recipe.content);
  const std::string text = example_text(recipe, "", [&](const Example& data) {
    if (!fs::exists(fs::path(folder) / data.file)) write_new_file(fs::path(folder) / data.file, data.content);
  });
  write_new_file(fs::path(folder) / fs::path(recipe.file).filename(), text);
}

}  // namespace

void add_discover_commands(Command program, const recipe::Registry& registry) {
  const auto name = std::make_shared<std::string>();
  const auto folder = std::make_shared<std::string>(".");
  const auto json = std::make_shared<bool>(false);
  const auto markdown = std::make_shared<bool>(false);

  Command list_command = program.add_command("list", "List operators and output formats");
  list_command.add_switch("--json", *json, "as JSON");
  list_command.does([=, &registry] { list(registry, *json); });

  Command describe_command = program.add_command("describe", "Describe an operator or an output format");
  describe_command.add("name", name.get(), "its name");
  describe_command.add_switch("--markdown", *markdown,
                              "the whole reference, as docs/operators.md; of catalogue as docs/catalogues.md");
  describe_command.does([=, &registry] {
    if (name->empty() && !*markdown) throw InvalidArgument("describe", "which one? 'seamount list' shows them");
    describe(registry, *name, *markdown);
  });

  Command schema_command = program.add_command("schema", "Print the JSON Schema of recipes, or of catalogues");
  schema_command.add("of", name.get(),
                     "recipe, catalogue, or typescript: parameters as types; recipe if it is left out");
  schema_command.does([=, &registry] {
    if (*name == kTypescript) {
      std::cout << recipe::typescript_types(registry);
      return;
    }
    if (!name->empty() && *name != kCatalogue && *name != "recipe")
      throw InvalidArgument(
          "schema", "there is none of '" + *name + "'" + suggestion(*name, {"recipe", kCatalogue, kTypescript}));
    const recipe::Json schema = *name == kCatalogue ? recipe::catalogue_schema() : recipe::recipe_schema(registry);
    std::cout << schema.dump(2) << "\n";
  });

  Command new_command = program.add_command("new", "Write an example recipe to start from");
  new_command.add("example", name.get(), fmt::format("one of {}", fmt::join(example_names(), ", ")));
  new_command.add("--out", folder.get(), "folder to write to");
  new_command.does([=] { make_new(*name, *folder); });
}

}  // namespace seamount::app
