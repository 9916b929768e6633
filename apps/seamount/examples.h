// The example recipes and the data files that they name, compiled into the program.
#pragma once

#include <string_view>
#include <vector>

namespace seamount::app {

struct Example {
  std::string_view file;  ///< "kauai.json", "reef/platform.json"
  std::string_view content;
};

const std::vector<Example>& example_files();

}  // namespace seamount::app
