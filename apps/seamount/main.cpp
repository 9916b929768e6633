// seamount: the command line. Commands are in the files beside this one.
#include "program.h"

int main(int argc, char** argv) {
  return seamount::app::run_program(argc, argv, seamount::recipe::standard_registry());
}
