// The whole program but its main(): a program with kinds, operators and formats of its own has the same commands.
#pragma once

#include "seamount/recipe/registry.h"

namespace seamount::app {

/// Does what a command line says and returns the exit code. Errors are said on stderr. Handles signals; call it once.
int run_program(int argc, char** argv, const recipe::Registry& registry);

}  // namespace seamount::app
