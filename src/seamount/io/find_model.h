// Where the shipped models lie: networks and dictionaries, NAME.safetensors each.
#pragma once

#include <string>

namespace seamount::io {

/// The file of a model. `name` is that of a file where it has a slash or ends with ".safetensors", else "NAME" stands
/// for NAME.safetensors of the first of shared_folders(Shared::models) that has it. Throws IoError{name} where there is
/// no such file; the message tells the folders.
std::string find_model(const std::string& name);

}  // namespace seamount::io
