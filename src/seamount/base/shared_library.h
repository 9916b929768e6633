// Parts of the program that are loaded when they are needed, since few need them and they bring much along.
#pragma once

#include <optional>
#include <string>

namespace seamount {

/// A file in the folder that the environment variable SEAMOUNT_PARTS names, beside the running program, or in
/// ../lib/seamount of it; nullopt where it is in none.
std::optional<std::string> find_part(const std::string& file);

/// The address of a function of a shared library, which stays loaded. Throws Error with the loader's words.
void* load_function(const std::string& library, const char* function);

}  // namespace seamount
