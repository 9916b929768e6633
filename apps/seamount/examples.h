// The example recipes and the data files that they name, compiled into the program.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace seamount::app {

struct Example {
  std::string_view file;  ///< "kauai.json", "reef/platform.json"
  std::string_view content;
};

const std::vector<Example>& example_files();

/// Recipes and catalogues can be asked for by name; other data come with the recipes that name them.
bool has_name(const Example& example);
bool is_catalogue(const Example& example);
std::vector<std::string> example_names();

/// Throws InvalidArgument{"example"} for a name that there is not.
const Example& find_example(const std::string& name);

/// What an example says of itself; "" if it says nothing.
std::string example_about(const Example& example);

/// A recipe whose data files lie below `folder` beside it, and each of those files.
std::string example_text(const Example& recipe, const std::string& folder,
                         const std::function<void(const Example& data)>& each);

}  // namespace seamount::app
