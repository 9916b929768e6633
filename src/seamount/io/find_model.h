// Where the shipped models lie: networks and dictionaries, NAME.safetensors each.
#pragma once

#include <string>
#include <vector>

namespace seamount::io {

/// The folders in which models are looked for, the first first: those that the environment variable SEAMOUNT_MODELS
/// names (separated by colons), share/seamount/models of where this program is installed, share/models beside the
/// shared library that this is part of (the Python package), models/ of the sources that it was built from, and
/// share/seamount/models where an installation was meant to go. Not all of them need exist.
std::vector<std::string> model_folders();

/// The file of a model. `name` is that of a file where it has a slash or ends with ".safetensors", else "NAME" stands
/// for NAME.safetensors of the first of model_folders() that has it. Throws IoError{name} where there is no such file;
/// the message tells the folders.
std::string find_model(const std::string& name);

}  // namespace seamount::io
