// What is known of the examples beside their content (examples.cpp.in).
#include <algorithm>

#include "examples.h"
#include "seamount/base/error.h"
#include "seamount/base/text.h"
#include "seamount/recipe/json_document.h"

namespace seamount::app {

bool has_name(const Example& example) { return example.file.ends_with(".json"); }
bool is_catalogue(const Example& example) { return example.file.starts_with("catalogues/"); }

std::vector<std::string> example_names() {
  std::vector<std::string> names;
  for (const Example& example : example_files()) {
    if (has_name(example)) names.emplace_back(example.file.substr(0, example.file.size() - 5));
  }
  return names;
}

const Example& find_example(const std::string& name) {
  const auto& examples = example_files();
  const auto found =
      std::find_if(examples.begin(), examples.end(), [&](const Example& one) { return one.file == name + ".json"; });
  if (found != examples.end()) return *found;
  throw InvalidArgument("example", "there is no '" + name + "'" + suggestion(name, example_names()));
}

std::string example_about(const Example& example) {
  const recipe::Json document = recipe::Json::parse(example.content, nullptr, false);
  const bool says = document.is_object() && document.contains("about") && document["about"].is_string();
  return says ? document["about"].get<std::string>() : "";
}

std::string example_text(const Example& recipe, const std::string& folder,
                         const std::function<void(const Example& data)>& each) {
  std::string text(recipe.content);
  const std::string up = recipe.file.find('/') == std::string_view::npos ? "../" : "../../";
  for (const Example& data : example_files()) {
    const std::string reference = up + "data/" + std::string(data.file);
    const std::string name = folder + std::string(data.file);
    size_t at = text.find(reference);
    if (at == std::string::npos) continue;
    for (; at != std::string::npos; at = text.find(reference, at + name.size()))
      text.replace(at, reference.size(), name);
    each(data);
  }
  return text;
}

}  // namespace seamount::app
