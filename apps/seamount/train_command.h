// What is trained from data that the user has: each kind is a command of `seamount train` in a file of its own.
#pragma once

#include "app.h"

namespace seamount::app {

/// `seamount train` and its kinds.
void add_train_command(Command program);

// Each adds its kinds.
void add_train_dictionary(Command train);
void add_train_networks(Command train);

}  // namespace seamount::app
