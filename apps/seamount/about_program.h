// What `seamount --version` says.
#pragma once

#include <string>

namespace seamount::app {

/// The version; below it what the program was built with and which of it this machine has, and where the files lie that
/// come with it.
std::string about_program();

}  // namespace seamount::app
