#include "train_command.h"

namespace seamount::app {

void add_train_command(Command program) {
  Command train = program.add_command("train", "Train what operators load: see --help of each kind");
  train.require_command();
  add_train_dictionary(train);
  add_train_networks(train);
}

}  // namespace seamount::app
