// A trained model as parameters name it.
#pragma once

#include <string>

namespace seamount {

/// One of Seamount's own by its word ("mountains"), or a file; relative names are relative to the recipe. Where the
/// files of words lie: io/find_model.h.
struct ModelFile {
  std::string name;  ///< a file where it has a slash or ends with ".safetensors", else a word
  bool is_word() const { return name.find('/') == std::string::npos && !name.ends_with(".safetensors"); }
  bool operator==(const ModelFile&) const = default;
};

}  // namespace seamount
